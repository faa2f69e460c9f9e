#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Colours and attributes as terminals are told them: SGR sequences, ESC [ parameters m.
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

/// The style after a sequence with these parameters. None: one of them is not known here.
std::optional<SgrStyle> styled(const SgrStyle& before, std::string_view parameters);

/// What a terminal must be sent that is in one style (none: who knows in which) to be in another:
/// the shorter of the difference and a fresh start. `has_own_colors`: it understands 39 and 49, its
/// own colours one by one.
std::string style_change(const std::optional<SgrStyle>& from, const SgrStyle& to,
                         bool has_own_colors);
/// Its size, without making it.
std::size_t style_change_size(const std::optional<SgrStyle>& from, const SgrStyle& to,
                              bool has_own_colors);

}  // namespace carom
