#include "terminal/screen/screen_style.h"

#include <algorithm>
#include <utility>

namespace carom {
namespace {

constexpr std::string_view blank = " ";
constexpr std::string_view full_block = "\u2588";
constexpr std::string_view upper_half = "\u2580";
constexpr std::string_view lower_half = "\u2584";

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

std::size_t StyleFilter::cost_of(const SgrStyle& style) const {
    return style_change_size(style_, style, has_own_colors_);
}

void StyleFilter::take_style(const SgrStyle& style) {
    if (style_ == style) return;
    out_ += style_change(style_, style, has_own_colors_);
    style_ = style;
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
    if (glyph == blank && is_unmarked(wanted_) && style_ && is_unmarked(*style_)) {
        SgrStyle other = *style_;
        other.background = wanted_.background;
        offer(blank, other);
    }
    if (glyph == full_block && is_plain(wanted_) && style_ && wanted_.foreground >= 0) {
        SgrStyle other = wanted_;
        other.background = style_->background;
        offer(full_block, other);
        other.background = wanted_.foreground;
        other.foreground = style_->foreground;
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

// For what blanks cells: they take the background in force.
void StyleFilter::take_background() {
    SgrStyle style = wanted_;
    if (style_ && is_unmarked(*style_) && is_unmarked(wanted_)) {
        style = *style_;
        style.background = wanted_.background;
    }
    take_style(style);
}

// The sequence that `rest` starts with; returns its length.
std::size_t StyleFilter::take_sequence(std::string_view rest) {
    if (rest.size() < 2 || rest[1] != '[') {
        const bool is_charset = rest.size() > 2 && (rest[1] == '(' || rest[1] == ')');
        const std::size_t length = is_charset ? 3 : std::min<std::size_t>(2, rest.size());
        const std::string_view sequence = rest.substr(0, length);
        // These may scroll, and so does a new line.
        if (sequence == "\033M" || sequence == "\033D" || sequence == "\033E") take_background();
        if (sequence != "\033(B") out_ += sequence;
        return length;
    }
    std::size_t end = 2;
    while (end < rest.size() && (rest[end] < 0x40 || rest[end] > 0x7e)) {
        ++end;
    }
    const std::string_view sequence = rest.substr(0, end + 1);
    const char final = sequence.back();
    if (final == 'm') {
        if (const auto style = styled(wanted_, sequence.substr(2, sequence.size() - 3))) {
            wanted_ = *style;
        } else {
            take_style(wanted_);
            out_ += sequence;
            style_.reset();
        }
        return sequence.size();
    }
    constexpr std::string_view blanking = "JKX@PLMST";
    if (blanking.find(final) != std::string_view::npos) take_background();
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
            if (bytes[0] == '\n') take_background();
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
