#include "terminal/screen/sgr.h"

#include <algorithm>

namespace carom {
namespace {

struct AttributeCode {
    Attribute attribute;
    char code;
};
constexpr std::array attribute_codes{AttributeCode{bold, '1'}, AttributeCode{dim, '2'},
                                     AttributeCode{underline, '4'}, AttributeCode{reverse, '7'}};

// The parameters of one sequence.
class Parameters {
  public:
    explicit Parameters(SgrText& text) : text_(text) { text_.add("\033["); }

    void reset() { add(0); }
    void add_difference(const SgrStyle& from, const SgrStyle& to) {
        for (const AttributeCode& row : attribute_codes) {
            if ((to.attributes & ~from.attributes & row.attribute) == 0) continue;
            separate();
            text_.add(row.code);
        }
        if (to.foreground != from.foreground) add_color(to.foreground, 30);
        if (to.background != from.background) add_color(to.background, 40);
    }
    void end() { text_.add('m'); }

  private:
    void separate() {
        if (has_any_) text_.add(';');
        has_any_ = true;
    }
    void add(int number) {
        separate();
        text_.add_number(number);
    }
    // `base`: 30 for the foreground, 40 for the background.
    void add_color(Color color, int base) {
        if (color < 0) return add(base + 9);
        if (color < 8) return add(base + color);
        if (color < 16) return add(base + 60 + color - 8);
        add(base + 8);
        if (!is_direct(color)) {
            text_.add(";5");
            return add(color);
        }
        const Rgb rgb = rgb_of(color);
        text_.add(";2");
        for (const int channel : {rgb.red, rgb.green, rgb.blue})
            add(channel);
    }

    SgrText& text_;
    bool has_any_ = false;
};

SgrText difference(const SgrStyle& from, const SgrStyle& to) {
    SgrText text;
    Parameters parameters(text);
    parameters.add_difference(from, to);
    parameters.end();
    return text;
}

SgrText fresh_start(const SgrStyle& to) {
    SgrText text;
    Parameters parameters(text);
    if (to != SgrStyle{}) parameters.reset();
    parameters.add_difference({}, to);
    parameters.end();
    return text;
}

}  // namespace

void SgrText::add(std::string_view text) {
    std::ranges::copy(text, bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += text.size();
}

void SgrText::add_number(int number) {
    if (number >= 100) add(static_cast<char>('0' + number / 100));
    if (number >= 10) add(static_cast<char>('0' + number / 10 % 10));
    add(static_cast<char>('0' + number % 10));
}

SgrText style_change(const std::optional<SgrStyle>& from, const SgrStyle& to, bool has_own_colors) {
    if (from == to) return {};
    // Not every terminal can take attributes back one by one.
    if (!from || (from->attributes & ~to.attributes) != 0) return fresh_start(to);
    const bool returns_to_own = (to.foreground < 0 && from->foreground >= 0) ||
                                (to.background < 0 && from->background >= 0);
    if (!returns_to_own) return difference(*from, to);
    const SgrText afresh = fresh_start(to);
    if (!has_own_colors) return afresh;
    const SgrText change = difference(*from, to);
    return afresh.size() < change.size() ? afresh : change;
}

}  // namespace carom
