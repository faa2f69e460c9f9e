#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "terminal/screen/screen_sgr.h"

/// Says the colours and attributes of a frame in as few bytes as the terminal needs.
///
/// ncurses sends both colours wherever one of them changes, returns to the terminal's own colours
/// for every blank between, and does it in three sequences. This filter stands behind it: it
/// follows what colours and attributes the bytes ask for, and asks for them itself, late and only
/// where they show. A blank shows no foreground and a full block no background; a full block is a
/// blank of the other colour, and an upper half block a lower one with its colours exchanged: of
/// such twins the one is sent that suits the colours in force. (But a blank stays a blank: the
/// blocks of many fonts do not fill their cell to the border, or reach beyond it.) What scrolls or
/// blanks cells takes the background that was asked for.
namespace carom {

class StyleFilter {
  public:
    /// `has_own_colors`: the terminal understands 39 and 49, its own colours one by one.
    explicit StyleFilter(bool has_own_colors = true) : has_own_colors_(has_own_colors) {}

    /// The same picture in fewer bytes. Sequences must be whole. What the terminal is left in
    /// carries over to the next call; what is not understood passes through.
    std::string filtered(std::string_view bytes);

    /// Nothing is known of what the terminal is in.
    void distrust() { style_.reset(); }

    /// The same, and what comes next is in no style.
    void forget() {
        style_.reset();
        wanted_ = {};
    }

  private:
    std::size_t take_sequence(std::string_view rest);
    void take_glyph(std::string_view glyph);
    void take_background();
    void take_style(const SgrStyle& style);
    std::size_t cost_of(const SgrStyle& style) const;

    bool has_own_colors_;
    std::optional<SgrStyle> style_;  // of the terminal; none: not known
    SgrStyle wanted_;                // of what comes next
    std::string out_;
};

}  // namespace carom
