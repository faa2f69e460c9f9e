#pragma once

#include <string>
#include <vector>

namespace carom {

/// Text in columns, each as wide as its widest cell, two blanks apart.
class Table {
  public:
    /// The headings of the columns. A heading that starts with '<' (which is not shown) aligns its
    /// column to the left; the others are aligned to the right.
    explicit Table(const std::vector<std::string>& heads);

    /// Pre: as many cells as there are columns; ASCII.
    void add(std::vector<std::string> cells);

    /// The headings, then the rows; no blanks at the ends of lines, a newline after each.
    std::string text() const;

  private:
    std::vector<bool> at_left_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace carom
