#include "terminal/screen/screen_sgr.h"

#include <charconv>

namespace carom {
namespace {

std::optional<int> number_in(std::string_view digits) {
    if (digits.empty()) return 0;
    int value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [rest, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return value;
}

// What stands before the next separator, cut off `rest`; `has_more`: there was one.
std::string_view next_part(std::string_view& rest, bool& has_more, char separator = ';') {
    const std::size_t cut = rest.find(separator);
    const std::string_view part = rest.substr(0, cut);
    has_more = cut != std::string_view::npos;
    rest.remove_prefix(has_more ? cut + 1 : rest.size());
    return part;
}

// "38:2::r:g:b" and "48:2::r:g:b".
bool take_direct_color(std::string_view parameter, SgrStyle& style) {
    const bool is_foreground = parameter.substr(0, 6) == "38:2::";
    if (!is_foreground && parameter.substr(0, 6) != "48:2::") return false;
    parameter.remove_prefix(6);
    int rgb = 0;
    bool has_more = true;
    for (int i = 0; i < 3; ++i) {
        if (!has_more) return false;
        const auto channel = number_in(next_part(parameter, has_more, ':'));
        if (!channel || *channel > 255) return false;
        rgb = rgb << 8 | *channel;
    }
    (is_foreground ? style.foreground : style.background) = direct_color + rgb;
    return !has_more;
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

/// A sequence of bytes that is only counted, or written as well: what a change costs is asked far
/// more often than the change is made.
struct Counter {
    std::size_t size = 0;
    void add(char) { ++size; }
};
struct Writer {
    std::string& text;
    void add(char byte) { text += byte; }
};

template <typename Sink>
void add_number(Sink& sink, int number) {  // 0..9999
    if (number >= 1000) sink.add(static_cast<char>('0' + number / 1000));
    if (number >= 100) sink.add(static_cast<char>('0' + number / 100 % 10));
    if (number >= 10) sink.add(static_cast<char>('0' + number / 10 % 10));
    sink.add(static_cast<char>('0' + number % 10));
}

// Parameters of one sequence.
template <typename Sink>
class Parameters {
  public:
    explicit Parameters(Sink& sink) : sink_(sink) {
        sink_.add('\033');
        sink_.add('[');
    }
    void add(int number) {
        if (has_any_) sink_.add(';');
        has_any_ = true;
        add_number(sink_, number);
    }
    // `base`: 30 for the foreground, 40 for the background.
    void add_color(SgrColor color, int base) {
        if (color < 0) return add(base + 9);
        if (color < 8) return add(base + color);
        if (color < 16) return add(base + 60 + color - 8);
        add(base + 8);
        if (color < direct_color) {
            add(5);
            return add(color - numbered_color);
        }
        const int rgb = color - direct_color;
        sink_.add(':');
        sink_.add('2');
        sink_.add(':');
        for (const int channel : {rgb >> 16, rgb >> 8 & 255, rgb & 255}) {
            sink_.add(':');
            add_number(sink_, channel);
        }
    }
    // Only what is not yet so.
    void add_difference(const SgrStyle& from, const SgrStyle& to) {
        if (to.is_bold && !from.is_bold) add(1);
        if (to.is_dim && !from.is_dim) add(2);
        if (to.is_underlined && !from.is_underlined) add(4);
        if (to.is_reversed && !from.is_reversed) add(7);
        if (to.foreground != from.foreground) add_color(to.foreground, 30);
        if (to.background != from.background) add_color(to.background, 40);
    }
    void end() { sink_.add('m'); }

  private:
    Sink& sink_;
    bool has_any_ = false;
};

template <typename Sink>
void add_change(Sink& sink, const SgrStyle& from, const SgrStyle& to) {
    Parameters<Sink> parameters(sink);
    parameters.add_difference(from, to);
    parameters.end();
}

template <typename Sink>
void add_afresh(Sink& sink, const SgrStyle& to) {
    Parameters<Sink> parameters(sink);
    if (to != SgrStyle{}) parameters.add(0);
    parameters.add_difference({}, to);
    parameters.end();
}

bool has_more_attributes(const SgrStyle& a, const SgrStyle& b) {
    return (a.is_bold && !b.is_bold) || (a.is_dim && !b.is_dim) ||
           (a.is_underlined && !b.is_underlined) || (a.is_reversed && !b.is_reversed);
}

// Whether to start from no style rather than from the one in force.
bool is_better_afresh(const std::optional<SgrStyle>& from, const SgrStyle& to,
                      bool has_own_colors) {
    if (!from || has_more_attributes(*from, to)) return true;
    const bool needs_own_colors = (to.foreground < 0 && from->foreground >= 0) ||
                                  (to.background < 0 && from->background >= 0);
    if (!needs_own_colors) return false;
    Counter afresh;
    Counter change;
    add_afresh(afresh, to);
    add_change(change, *from, to);
    return !has_own_colors || afresh.size < change.size;
}

template <typename Sink>
void add_best(Sink& sink, const std::optional<SgrStyle>& from, const SgrStyle& to,
              bool has_own_colors) {
    if (from == to) return;
    if (is_better_afresh(from, to, has_own_colors)) {
        add_afresh(sink, to);
    } else {
        add_change(sink, *from, to);
    }
}

}  // namespace

std::optional<SgrStyle> styled(const SgrStyle& before, std::string_view parameters) {
    SgrStyle style = before;
    for (bool has_more = true; has_more;) {
        const std::string_view part = next_part(parameters, has_more);
        if (part.find(':') != std::string_view::npos) {
            if (!take_direct_color(part, style)) return std::nullopt;
            continue;
        }
        const auto number = number_in(part);
        if (!number) return std::nullopt;
        if (*number == 38 || *number == 48) {
            if (!has_more || next_part(parameters, has_more) != "5" || !has_more) {
                return std::nullopt;
            }
            const auto color = number_in(next_part(parameters, has_more));
            if (!color || *color > 255) return std::nullopt;
            (*number == 38 ? style.foreground : style.background) = numbered_color + *color;
        } else if (!take_parameter(*number, style)) {
            return std::nullopt;
        }
    }
    return style;
}

std::string style_change(const std::optional<SgrStyle>& from, const SgrStyle& to,
                         bool has_own_colors) {
    std::string text;
    Writer writer{text};
    add_best(writer, from, to, has_own_colors);
    return text;
}

std::size_t style_change_size(const std::optional<SgrStyle>& from, const SgrStyle& to,
                              bool has_own_colors) {
    Counter counter;
    add_best(counter, from, to, has_own_colors);
    return counter.size;
}

}  // namespace carom
