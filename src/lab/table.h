#pragma once

#include <string>
#include <vector>

namespace carom {

/// Columns of text, as wide as what stands in them, two blanks apart.
class Table {
  public:
    /// The names of the columns. One that starts with '<' (which is not shown) stands at the left
    /// of its column, like all cells under it; the others at the right.
    explicit Table(const std::vector<std::string>& heads);

    /// Pre: as many cells as there are columns; ASCII.
    void add(std::vector<std::string> cells);

    /// The names, then the rows; no blanks at the ends of lines, a newline after each.
    std::string text() const;

  private:
    std::vector<bool> at_left_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace carom
