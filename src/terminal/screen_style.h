#pragma once

#include <string>
#include <string_view>

/// Says the colours and attributes of a frame in as few bytes as the terminal needs.
///
/// ncurses sends both colours wherever one of them changes, returns to the terminal's own colours
/// for every blank between, and does it in three sequences. This filter stands behind it: it
/// follows what colours and attributes the bytes ask for, and asks for them itself, late and only
/// where they show. A blank shows no foreground and a full block no background; a full block is a
/// blank of the other colour, and an upper half block a lower one with its colours exchanged: of
/// such twins the one is sent that suits the colours in force.
namespace carom {

/// A colour as SGR sequences name it: -1 the terminal's own, 0..7 and 8..15 by a parameter of its
/// own (31, 91), 256 + n as number n of 256 (38;5;n), direct_color + 0xRRGGBB (38:2::r:g:b).
using SgrColor = int;
inline constexpr SgrColor numbered_color = 256;
inline constexpr SgrColor direct_color = 1 << 24;

struct SgrStyle {
    SgrColor foreground = -1;
    SgrColor background = -1;
    bool is_bold = false;
    bool is_dim = false;
    bool is_underlined = false;
    bool is_reversed = false;

    friend bool operator==(const SgrStyle&, const SgrStyle&) = default;
};

class StyleFilter {
  public:
    /// `has_own_colors`: the terminal understands 39 and 49, its own colours one by one.
    explicit StyleFilter(bool has_own_colors = true) : has_own_colors_(has_own_colors) {}

    /// The same picture in fewer bytes. Sequences must be whole. What the terminal is left in
    /// carries over to the next call; what is not understood passes through.
    std::string filtered(std::string_view bytes);

    /// Nothing is known of what the terminal is in; what comes next is in no style.
    void forget() {
        is_known_ = false;
        wanted_ = {};
    }

  private:
    std::size_t take_sequence(std::string_view rest);
    bool take_styles(std::string_view parameters);
    void take_glyph(std::string_view glyph);
    void take_style(const SgrStyle& style);
    std::size_t cost_of(const SgrStyle& style) const;
    std::string change_to(const SgrStyle& style) const;

    bool has_own_colors_;
    bool is_known_ = false;  // whether the terminal is in style_
    SgrStyle style_;         // of the terminal
    SgrStyle wanted_;        // of what comes next
    std::string out_;
};

}  // namespace carom
