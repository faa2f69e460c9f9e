#include "level/values/literal.h"

#include <fmt/format.h>

#include <charconv>

#include "level/text/spelling.h"
#include "level/text/words.h"

namespace carom {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

class LiteralReader {
  public:
    explicit LiteralReader(std::string_view text) : text_(text) {}

    Literal read(LengthUnit unit, const std::function<bool(std::string_view)>& is_let) {
        if (!read_number() || !read_unit(is_let)) return std::move(literal_);
        if (at_ < text_.size() && continues_identifier(text_[at_])) {
            const std::string_view rest = text_.substr(at_);
            fail("unexpected-text", at_, rest.size(),
                 fmt::format("'{}' is not expected here", rest), "a product needs its '*'");
            return std::move(literal_);
        }
        const Dimension& dimension = literal_.value.dimension;
        if (unit == LengthUnit::natural && (dimension.length != 0 || dimension.mass != 0)) {
            fail("unit-in-natural-level", 0, at_,
                 fmt::format("{} has a unit, but the level has none", text_.substr(0, at_)),
                 "leave the unit out, or begin with a line such as 'units mm'");
        }
        literal_.length = at_;
        return std::move(literal_);
    }

  private:
    bool fail(FaultCode code, std::size_t at, std::size_t length, std::string fault,
              std::string remedy) {
        literal_.code = code;
        literal_.fault_at = at;
        literal_.fault_length = length;
        literal_.fault = std::move(fault);
        literal_.remedy = std::move(remedy);
        return false;
    }

    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    void skip_digits() {
        while (is_digit(peek()))
            ++at_;
    }

    // Reads digits with at most one point and an exponent.
    bool read_number() {
        skip_digits();
        if (peek() == '.' && text_.substr(at_, 2) != "..") {
            ++at_;
            skip_digits();
        }
        if (peek() == 'e' || peek() == 'E') {
            std::size_t digits = at_ + 1;
            if (digits < text_.size() && (text_[digits] == '-' || text_[digits] == '+')) ++digits;
            if (digits < text_.size() && is_digit(text_[digits])) {
                at_ = digits;
                skip_digits();
            }
        }
        double& value = literal_.value.number;
        const auto [end, error] = std::from_chars(text_.data(), text_.data() + at_, value);
        if (error != std::errc::result_out_of_range && value <= largest_number) return true;
        return fail("number-out-of-range", 0, at_,
                    fmt::format("{} is out of range", text_.substr(0, at_)),
                    "numbers go from 1e-300 to 1e300");
    }

    std::string_view letters_at(std::size_t from) const {
        std::size_t end = from;
        while (end < text_.size() && starts_identifier(text_[end]))
            ++end;
        return text_.substr(from, end - from);
    }

    bool read_unit(const std::function<bool(std::string_view)>& is_let) {
        const std::string_view letters = letters_at(at_);
        if (!letters.empty()) {
            const Unit* unit = unit_named(letters);
            if (!unit) {
                return fail("unknown-unit", at_, letters.size(),
                            fmt::format("'{}' is not a unit", letters),
                            did_you_mean(letters, unit_names(),
                                         "units are mm cm m in, g kg, ms s, m/s, m/s2, deg; "
                                         "a product needs its '*'"));
            }
            at_ += letters.size();
            multiply(*unit, read_exponent(), false);
        }
        while (peek() == '/') {
            const std::string_view below = letters_at(at_ + 1);
            const Unit* unit = unit_named(below);
            if (!unit || (letters.empty() && (unit->dimension.time != 1 || is_let(below)))) break;
            at_ += 1 + below.size();
            multiply(*unit, read_exponent(), true);
        }
        return true;
    }

    int read_exponent() {
        if (peek() != '2' && peek() != '3') return 1;
        return text_[at_++] - '0';
    }

    void multiply(const Unit& unit, int exponent, bool is_below) {
        Value& value = literal_.value;
        for (int i = 0; i < exponent; ++i) {
            value.number = is_below ? value.number / unit.size : value.number * unit.size;
            value.dimension =
                is_below ? value.dimension / unit.dimension : value.dimension * unit.dimension;
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    Literal literal_;
};

}  // namespace

bool begins_literal(std::string_view text) {
    if (text.empty()) return false;
    return is_digit(text[0]) || (text[0] == '.' && text.size() > 1 && is_digit(text[1]));
}

Literal read_literal(std::string_view text, LengthUnit unit,
                     const std::function<bool(std::string_view)>& is_let) {
    return LiteralReader(text).read(unit, is_let);
}

}  // namespace carom
