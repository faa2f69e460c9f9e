#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "level/ir/level_ir.h"
#include "level/text/reporter.h"
#include "level/text/words.h"

/// The drawing of a `map`, and what its characters mean.
namespace carom {

/// The cells of a drawing: one character each. Rows count from the top.
class Drawing {
  public:
    explicit Drawing(const std::vector<Word>& lines);

    int rows() const { return static_cast<int>(cells_.size()); }
    int columns() const { return columns_; }
    /// The number of characters in the row.
    int length(int row) const {
        return static_cast<int>(cells_[static_cast<std::size_t>(row)].size());
    }
    /// The character of a cell; blank outside of the drawing.
    std::string_view at(int row, int column) const {
        if (row < 0 || row >= rows() || column < 0) return " ";
        const auto& line = cells_[static_cast<std::size_t>(row)];
        if (column >= static_cast<int>(line.size())) return " ";
        return line[static_cast<std::size_t>(column)];
    }
    Span span(int row, int column) const {
        const Word& line = lines_[static_cast<std::size_t>(row)];
        return {line.source, line.line, column + 1, 1};
    }

  private:
    const std::vector<Word>& lines_;
    std::vector<std::vector<std::string_view>> cells_;
    int columns_ = 0;
};

/// What the characters of drawings mean: lines, joints, blanks, and letters by their legends.
class DrawingLetters {
  public:
    explicit DrawingLetters(const LevelIr& ir) : ir_(ir) {}

    /// What a letter means; null: nothing. A built-in letter keeps its meaning unless a legend of
    /// the level redefines it.
    const LegendIr* legend_of(std::string_view letter) const;
    static bool is_line(std::string_view c) {
        return c == "-" || c == "|" || c == "/" || c == "\\";
    }
    /// A joint draws nothing, but lines that run into it meet at its centre.
    bool is_joint(std::string_view c) const { return c == "+" && !legend_of(c); }

    /// Reports each unknown character once, and a comment as such. Returns whether there is none.
    bool check(const Drawing& drawing, Reporter& reporter) const;

  private:
    bool is_known(std::string_view c) const;
    std::optional<int> comment_in(const Drawing& drawing, int row) const;

    const LevelIr& ir_;
};

}  // namespace carom
