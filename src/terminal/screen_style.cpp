#include "terminal/screen_style.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace carom {
namespace {

constexpr std::string_view blank = " ";
constexpr std::string_view full_block = "\u2588";
constexpr std::string_view upper_half = "\u2580";
constexpr std::string_view lower_half = "\u2584";

std::optional<int> number_in(std::string_view digits) {
    if (digits.empty()) return 0;
    int value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [rest, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t cut = text.find(separator);
        parts.push_back(text.substr(0, cut));
        if (cut == std::string_view::npos) return parts;
        text.remove_prefix(cut + 1);
    }
}

// "38:2::r:g:b" and "48:2::r:g:b".
bool take_direct_color(std::string_view parameter, SgrStyle& style) {
    const auto parts = split(parameter, ':');
    if (parts.size() != 6 || parts[1] != "2" || !parts[2].empty()) return false;
    const auto red = number_in(parts[3]);
    const auto green = number_in(parts[4]);
    const auto blue = number_in(parts[5]);
    if (!red || !green || !blue) return false;
    const SgrColor color = direct_color + (*red << 16 | *green << 8 | *blue);
    if (parts[0] == "38") style.foreground = color;
    if (parts[0] == "48") style.background = color;
    return parts[0] == "38" || parts[0] == "48";
}

// A single parameter; false when it is not known here.
bool take_parameter(int parameter, SgrStyle& style) {
    switch (parameter) {
        case 0:
            style = {};
            return true;
        case 1:
            style.is_bold = true;
            return true;
        case 2:
            style.is_dim = true;
            return true;
        case 4:
            style.is_underlined = true;
            return true;
        case 7:
            style.is_reversed = true;
            return true;
        case 22:
            style.is_bold = style.is_dim = false;
            return true;
        case 24:
            style.is_underlined = false;
            return true;
        case 27:
            style.is_reversed = false;
            return true;
        case 39:
            style.foreground = -1;
            return true;
        case 49:
            style.background = -1;
            return true;
        default:
            break;
    }
    const auto within = [&](int low, int high) { return parameter >= low && parameter <= high; };
    if (within(30, 37)) style.foreground = parameter - 30;
    if (within(40, 47)) style.background = parameter - 40;
    if (within(90, 97)) style.foreground = parameter - 90 + 8;
    if (within(100, 107)) style.background = parameter - 100 + 8;
    return within(30, 37) || within(40, 47) || within(90, 97) || within(100, 107);
}

// `base`: 30 for the foreground, 40 for the background.
void append_color(std::string& text, SgrColor color, int base) {
    const auto out = std::back_inserter(text);
    if (color < 0) {
        fmt::format_to(out, "{};", base + 9);
    } else if (color < 8) {
        fmt::format_to(out, "{};", base + color);
    } else if (color < 16) {
        fmt::format_to(out, "{};", base + 60 + color - 8);
    } else if (color < direct_color) {
        fmt::format_to(out, "{};5;{};", base + 8, color - numbered_color);
    } else {
        const int rgb = color - direct_color;
        fmt::format_to(out, "{}:2::{}:{}:{};", base + 8, rgb >> 16, rgb >> 8 & 255, rgb & 255);
    }
}

// Parameters that lead from one style to another, each followed by ';'. Only what is not yet so.
std::string parameters_between(const SgrStyle& from, const SgrStyle& to) {
    std::string text;
    if (to.is_bold && !from.is_bold) text += "1;";
    if (to.is_dim && !from.is_dim) text += "2;";
    if (to.is_underlined && !from.is_underlined) text += "4;";
    if (to.is_reversed && !from.is_reversed) text += "7;";
    if (to.foreground != from.foreground) append_color(text, to.foreground, 30);
    if (to.background != from.background) append_color(text, to.background, 40);
    return text;
}

bool has_more_attributes(const SgrStyle& a, const SgrStyle& b) {
    return (a.is_bold && !b.is_bold) || (a.is_dim && !b.is_dim) ||
           (a.is_underlined && !b.is_underlined) || (a.is_reversed && !b.is_reversed);
}

// Marks show on blanks too.
bool is_unmarked(const SgrStyle& style) {
    return !style.is_underlined && !style.is_reversed;
}

// Nothing but colours: then a glyph may stand for its twin.
bool is_plain(const SgrStyle& style) {
    return is_unmarked(style) && !style.is_bold && !style.is_dim;
}

std::size_t glyph_length(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte < 0xc0 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
}

}  // namespace

// An empty string: nothing needs to change.
std::string StyleFilter::change_to(const SgrStyle& style) const {
    const bool needs_own_colors = (style.foreground < 0 && style_.foreground >= 0) ||
                                  (style.background < 0 && style_.background >= 0);
    const bool must_reset =
        !is_known_ || has_more_attributes(style_, style) || (needs_own_colors && !has_own_colors_);
    std::string afresh = parameters_between({}, style);
    afresh = afresh.empty() ? "\033[m" : "\033[0;" + afresh;
    if (afresh.back() == ';') afresh.back() = 'm';
    if (must_reset) return afresh;
    if (style == style_) return {};
    std::string change = "\033[" + parameters_between(style_, style);
    change.back() = 'm';
    return change.size() <= afresh.size() ? change : afresh;
}

std::size_t StyleFilter::cost_of(const SgrStyle& style) const {
    return change_to(style).size();
}

void StyleFilter::take_style(const SgrStyle& style) {
    out_ += change_to(style);
    style_ = style;
    is_known_ = true;
}

void StyleFilter::take_glyph(std::string_view glyph) {
    SgrStyle style = wanted_;
    std::string_view shown = glyph;
    const bool has_colors = style.foreground >= 0 && style.background >= 0;
    const auto offer = [&](std::string_view twin, const SgrStyle& other) {
        if (cost_of(other) + twin.size() < cost_of(style) + shown.size()) {
            style = other;
            shown = twin;
        }
    };
    if (glyph == blank && is_unmarked(wanted_) && is_known_ && is_unmarked(style_)) {
        SgrStyle other = style_;
        other.background = wanted_.background;
        offer(blank, other);
        other = style_;
        other.foreground = wanted_.background;
        if (wanted_.background >= 0 && is_plain(other)) offer(full_block, other);
    }
    if (glyph == full_block && is_plain(wanted_) && is_known_ && wanted_.foreground >= 0) {
        SgrStyle other = wanted_;
        other.background = style_.background;
        offer(full_block, other);
        other.background = wanted_.foreground;
        other.foreground = style_.foreground;
        offer(blank, other);
    }
    if ((glyph == upper_half || glyph == lower_half) && is_plain(wanted_) && has_colors) {
        SgrStyle other = wanted_;
        std::swap(other.foreground, other.background);
        offer(glyph == upper_half ? lower_half : upper_half, other);
    }
    take_style(style);
    out_ += shown;
}

// SGR parameters; false, and nothing is taken, when there is one that is not known here.
bool StyleFilter::take_styles(std::string_view parameters) {
    SgrStyle style = wanted_;
    const auto parts = split(parameters, ';');
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].find(':') != std::string_view::npos) {
            if (!take_direct_color(parts[i], style)) return false;
            continue;
        }
        const auto number = number_in(parts[i]);
        if (!number) return false;
        if ((*number == 38 || *number == 48) && i + 2 < parts.size() && parts[i + 1] == "5") {
            const auto color = number_in(parts[i + 2]);
            if (!color) return false;
            (*number == 38 ? style.foreground : style.background) = numbered_color + *color;
            i += 2;
        } else if (!take_parameter(*number, style)) {
            return false;
        }
    }
    wanted_ = style;
    return true;
}

// The sequence that `rest` starts with; returns its length.
std::size_t StyleFilter::take_sequence(std::string_view rest) {
    if (rest.size() < 2 || rest[1] != '[') {
        const bool is_charset = rest.size() > 2 && (rest[1] == '(' || rest[1] == ')');
        const std::size_t length = is_charset ? 3 : std::min<std::size_t>(2, rest.size());
        if (rest.substr(0, length) != "\033(B") out_ += rest.substr(0, length);
        return length;
    }
    std::size_t end = 2;
    while (end < rest.size() && (rest[end] < 0x40 || rest[end] > 0x7e)) {
        ++end;
    }
    const std::string_view sequence = rest.substr(0, end + 1);
    const char final = sequence.back();
    if (final == 'm') {
        if (take_styles(sequence.substr(2, sequence.size() - 3))) return sequence.size();
        take_style(wanted_);
        out_ += sequence;
        is_known_ = false;
        return sequence.size();
    }
    if (final == 'J' || final == 'K' || final == 'X' || final == '@' || final == 'P' ||
        final == 'L' || final == 'M') {  // what they blank takes the background in force
        SgrStyle style = wanted_;
        if (is_known_ && is_unmarked(style_) && is_unmarked(wanted_)) {
            style = style_;
            style.background = wanted_.background;
        }
        take_style(style);
    }
    out_ += sequence;
    return sequence.size();
}

std::string StyleFilter::filtered(std::string_view bytes) {
    out_.clear();
    while (!bytes.empty()) {
        std::size_t length = 1;
        const auto byte = static_cast<unsigned char>(bytes[0]);
        if (byte == 0x1b) {
            length = take_sequence(bytes);
        } else if (byte < 0x20 || byte == 0x7f) {
            out_ += bytes[0];
        } else {
            length = std::min(glyph_length(bytes[0]), bytes.size());
            take_glyph(bytes.substr(0, length));
        }
        bytes.remove_prefix(length);
    }
    return std::exchange(out_, {});
}

}  // namespace carom
