#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "level/context.h"
#include "level/spelling.h"

namespace carom {
namespace {

// Beyond these, squares and fourth powers in the physics would overflow or vanish.
constexpr double largest_quantity = 1e18;
constexpr double smallest_positive = 1e-18;

// "r=", "rate ", or nothing.
std::string lead_of(const Label& label) {
    return label.name.empty() || label.joint.empty() ? ""
                                                     : fmt::format("{}{}", label.name, label.joint);
}

std::string remedy_for(const Label& label, Measure measure, const Context& context) {
    return fmt::format("write {}, such as {}{}", described(measure), lead_of(label),
                       sample(measure, context.unit));
}

// The world's number, or a message that names both what is there and what is wanted.
std::optional<double> converted(const Word& word, const Value& value, const Label& label,
                                Measure measure, Context& context) {
    if (context.is_unit_unknown) return value.number;
    const Dimension wanted = dimension_of(measure);
    if (measure == Measure::result) return value.number;
    if (context.unit == LengthUnit::natural) {
        if (value.is_bare()) return value.number;
        const Dimension& d = value.dimension;
        if (d.angle == wanted.angle && d.time == wanted.time) return value.number;
        context.reporter.error(word.span(),
                               fmt::format("{} is {}, {} is wanted", word.text,
                                           described(value.dimension), described(measure)),
                               remedy_for(label, measure, context));
        return std::nullopt;
    }
    if (value.dimension == wanted || (value.is_bare() && value.number == 0.0)) {
        return value.number;
    }
    if (value.is_bare()) {
        if (measure == Measure::length) return value.number * scale(context.unit);
        if (measure == Measure::angle || measure == Measure::soften ||
            measure == Measure::frequency) {
            return value.number;
        }
        context.reporter.error(
            word.span(), fmt::format("{} has no unit, {} is wanted", word.text, described(measure)),
            fmt::format("write it with its unit, such as {}{}", lead_of(label),
                        sample(measure, context.unit)));
        return std::nullopt;
    }
    context.reporter.error(word.span(),
                           fmt::format("{} is {}, {} is wanted", word.text,
                                       described(value.dimension), described(measure)),
                           remedy_for(label, measure, context));
    return std::nullopt;
}

bool holds(double number, Bound bound) {
    switch (bound) {
        case Bound::not_negative:
            return number >= 0.0;
        case Bound::positive:
            return number > 0.0;
        case Bound::share:
            return number >= 0.0 && number <= 1.0;
        case Bound::up_to_thousand:
            return number >= 1.0 && number <= 1000.0;
        case Bound::any:
            break;
    }
    return true;
}

std::string_view demand(Bound bound) {
    switch (bound) {
        case Bound::not_negative:
            return "must not be negative";
        case Bound::positive:
            return "must be more than 0";
        case Bound::share:
            return "must be from 0 to 1";
        case Bound::up_to_thousand:
            return "must be from 1 to 1000";
        case Bound::any:
            break;
    }
    return "";
}

// Every number of a level passes here. The remedy shows the author's own number, mended.
std::optional<double> bounded(const Word& word, double number, const Label& label, Measure measure,
                              Bound bound, Context& context) {
    const std::string subject(label.name.empty() ? described(measure) : std::string(label.name));
    const std::string shown = written(number, measure, context.unit);
    if (measure == Measure::whole && std::floor(number) != number) {
        context.reporter.error(word.span(),
                               fmt::format("{} must be a whole number, but is {}", subject, shown),
                               remedy_for(label, measure, context));
        return std::nullopt;
    }
    if (!holds(number, bound)) {
        const std::string mended =
            bound == Bound::share ? "0.8" : written(-number, measure, context.unit);
        std::string remedy = remedy_for(label, measure, context);
        if (number < 0.0 && bound != Bound::up_to_thousand) {
            remedy =
                fmt::format("write {}, such as {}{}", described(measure), lead_of(label), mended);
        }
        context.reporter.error(
            word.span(), fmt::format("{} {}, but is {}", subject, demand(bound), shown), remedy);
        return std::nullopt;
    }
    const bool is_too_small = bound == Bound::positive && number < smallest_positive;
    if (std::abs(number) > largest_quantity || is_too_small) {
        context.reporter.error(word.span(), fmt::format("{} is out of range: {}", subject, shown),
                               "quantities go from 1e-18 to 1e18");
        return std::nullopt;
    }
    return number;
}

// Sorts the words of one statement into what they are.
class Reading {
  public:
    Reading(const Node& node, const Scope& scope, Context& context)
        : scope_(scope), context_(context) {
        result_.node = &node;
        result_.statement = node.statement;
    }

    Arguments read() {
        const std::size_t errors = context_.reporter.errors();
        const std::vector<Word> words = result_.node->rest();
        if (check_spaces(words)) {
            for (const Word& word : words)
                read_word(word);
        }
        if (context_.reporter.errors() == errors && result_.is_sound) check_counts();
        if (context_.reporter.errors() != errors) result_.is_sound = false;
        return std::move(result_);
    }

  private:
    const Statement& statement() const { return *result_.statement; }

    void mistake(const Span& at, std::string message, std::string remedy) {
        context_.reporter.error(at, std::move(message), std::move(remedy));
        result_.is_sound = false;
    }

    // "a = 1" and "W / 2": one mistake, though it makes several odd words.
    bool check_spaces(const std::vector<Word>& words) {
        if (statement().name.starts_with("legend "))
            return true;  // any character is a letter there
        for (const Word& word : words) {
            if (word.text.find_first_not_of("=+-*/^,") != std::string_view::npos) continue;
            const bool is_key = word.text == "=";
            mistake(word.span(), fmt::format("'{}' stands alone", word.text),
                    is_key ? "write key=value without spaces"
                           : "arithmetic and points are written without spaces: W/2,0");
            return false;
        }
        return true;
    }

    // Names come first: what stands behind a point or a key is a flag, misspelt, or a mistake.
    void read_plain(const Word& word) {
        if (result_.points.empty() && result_.values.empty() && result_.own_keys.empty()) {
            result_.plain.push_back(word);
        } else if (result_.is_sound) {
            report_surplus(word);
        }
    }

    void read_word(const Word& word) {
        if (word.text[0] == '"') {
            result_.plain.push_back(word);
            return;
        }
        const std::size_t equals = word.text.find('=');
        if (equals != std::string_view::npos) {
            read_key(word, equals);
            return;
        }
        if (std::ranges::count(statement().flags, word.text) > 0) {
            result_.flags.insert(word.text);
            return;
        }
        if (statement().points_most > 0 && split_outside_brackets(word, ",").size() > 1) {
            read_point(word);
            return;
        }
        read_plain(word);
    }

    void read_point(const Word& word) {
        const std::optional<Vec2> point =
            read_pair(word, "", statement().point_measure, Bound::any);
        if (!point) {
            result_.is_sound = false;
            return;
        }
        result_.points.push_back(*point);
        result_.point_words.push_back(word);
    }

    std::optional<Vec2> read_pair(const Word& word, std::string_view name, Measure measure,
                                  Bound bound) {
        const std::vector<Word> pieces = split_outside_brackets(word, ",");
        if (!are_brackets_closed(word)) return std::nullopt;
        if (pieces.size() != 2) {
            mistake(word.span(), numbers_wanted(pieces.size(), 2),
                    fmt::format("write {}{}x,y without spaces", name, name.empty() ? "" : "="));
            return std::nullopt;
        }
        const Label label{name, ""};
        const auto x = read_number(pieces[0], label, measure, bound, scope_, context_);
        const auto y = read_number(pieces[1], label, measure, bound, scope_, context_);
        if (!x || !y) return std::nullopt;
        return Vec2{*x, *y};
    }

    static std::string numbers_wanted(std::size_t there, int wanted) {
        return fmt::format("{} {} here, {} are wanted", there,
                           there == 1 ? "number stands" : "numbers stand", wanted);
    }

    // An open bracket hides the commas behind it: that is the mistake, not their number.
    bool are_brackets_closed(const Word& word) {
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < word.text.size(); ++i) {
            if (word.text[i] == '(') open.push_back(i);
            if (word.text[i] == ')' && !open.empty()) open.pop_back();
        }
        if (open.empty()) return true;
        mistake(word.part(open.back(), 1).span(), "the ')' is missing",
                "arithmetic is written without spaces: (W-2*R)/2");
        return false;
    }

    void read_key(const Word& word, std::size_t equals) {
        const Word name = word.part(0, equals);
        const Word value = word.part(equals + 1);
        const auto key = std::ranges::find(statement().keys, name.text, &KeyRule::name);
        if (key != statement().keys.end()) {
            if (result_.values.contains(key->name)) {
                mistake(name.span(), fmt::format("{}= stands here twice", name.text),
                        "keep one of them");
            } else if (value.text.empty()) {
                mistake(word.span(), fmt::format("{}= has no value", name.text),
                        "write key=value without spaces");
            } else {
                read_value(*key, value);
            }
            return;
        }
        if (statement().takes_any_key && is_identifier(name.text)) {
            result_.own_keys.emplace_back(name, value);
            return;
        }
        report_key(word, name);
    }

    void report_key(const Word& word, const Word& name) {
        if (name.text.empty()) {
            mistake(word.span(), "'=' has no key before it", "write key=value without spaces");
            return;
        }
        if (!is_identifier(name.text)) {
            mistake(name.span(), fmt::format("'{}' is not a name", name.text),
                    "a name has letters, digits and '_', and begins with a letter");
            return;
        }
        std::vector<std::string_view> known;
        for (const KeyRule& key : statement().keys)
            known.push_back(key.name);
        mistake(
            name.span(), fmt::format("{} has no key '{}'", statement().name, name.text),
            did_you_mean(name.text, known,
                         known.empty() ? fmt::format("write it as: {}", statement().usage)
                                       : fmt::format("its keys are: {}", fmt::join(known, " "))));
    }

    void read_value(const KeyRule& key, const Word& value) {
        Argument argument{value, {}};
        if (!read_numbers(key, argument)) {
            result_.is_sound = false;
            return;
        }
        result_.values.emplace(key.name, argument);
    }

    bool read_numbers(const KeyRule& key, Argument& argument) {
        const Word& value = argument.value;
        switch (key.form) {
            case Form::scalar: {
                if (key.name == "mu" || key.name == "w") return read_spin(key, argument);
                const auto number =
                    read_number(value, {key.name}, key.measure, key.bound, scope_, context_);
                argument.numbers[0] = number.value_or(0.0);
                return number.has_value();
            }
            case Form::pair: {
                const auto pair = read_pair(value, key.name, key.measure, key.bound);
                argument.numbers[0] = pair.value_or(Vec2{}).x;
                argument.numbers[1] = pair.value_or(Vec2{}).y;
                return pair.has_value();
            }
            case Form::range: {
                const auto range =
                    read_range(value, {key.name}, key.measure, key.bound, scope_, context_);
                if (range) {
                    argument.numbers[0] = range->first;
                    argument.numbers[1] = range->second;
                }
                return range.has_value();
            }
            case Form::box:
                return read_box(key, argument);
            case Form::word:
                return read_name(key, value);
            case Form::deferred:
            case Form::call:
                break;
        }
        return true;
    }

    // Friction and spin are physics that this version does not have: only none of it is accepted.
    bool read_spin(const KeyRule& key, const Argument& argument) {
        const auto value = evaluate(argument.value, scope_, context_.rules(), context_.reporter);
        if (!value) return false;
        if (value->number == 0.0) return true;
        mistake(argument.value.span(),
                fmt::format("{}={} needs 'use spin', which is not in this version of carom",
                            key.name, argument.value.text),
                fmt::format("leave {} out", key.name));
        return false;
    }

    bool read_box(const KeyRule& key, Argument& argument) {
        const std::vector<Word> pieces = split_outside_brackets(argument.value, ",");
        if (!are_brackets_closed(argument.value)) return false;
        if (pieces.size() != 4) {
            mistake(argument.value.span(), numbers_wanted(pieces.size(), 4),
                    fmt::format("write {}=x0,y0,x1,y1 without spaces", key.name));
            return false;
        }
        bool is_complete = true;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto number =
                read_number(pieces[i], {key.name, ""}, key.measure, key.bound, scope_, context_);
            argument.numbers[i] = number.value_or(0.0);
            is_complete = is_complete && number;
        }
        if (!is_complete) return false;
        if (argument.numbers[0] < argument.numbers[2] &&
            argument.numbers[1] < argument.numbers[3]) {
            return true;
        }
        mistake(argument.value.span(), fmt::format("the {} is empty", key.name),
                "write the lower left corner first: x0,y0,x1,y1");
        return false;
    }

    bool read_name(const KeyRule& key, const Word& value) {
        if (is_identifier(value.text)) return true;
        mistake(value.span(), fmt::format("'{}' is not a name", value.text),
                fmt::format("write {}=NAME", key.name));
        return false;
    }

    void check_counts() {
        const Statement& s = statement();
        for (const KeyRule& key : s.keys) {
            if (key.is_required && !result_.values.contains(key.name)) {
                mistake(result_.node->keyword().span(),
                        fmt::format("{} needs {}=", s.name, key.name),
                        fmt::format("write it as: {}", s.usage));
                return;
            }
        }
        if (std::ssize(result_.plain) > s.plain_most) {
            report_surplus(result_.plain[static_cast<std::size_t>(s.plain_most)]);
            return;
        }
        if (std::ssize(result_.points) > s.points_most) {
            const Word& word = result_.point_words[static_cast<std::size_t>(s.points_most)];
            mistake(word.span(),
                    fmt::format("{} takes no more than {} points", s.name, s.points_most),
                    fmt::format("write it as: {}", s.usage));
            return;
        }
        if (std::ssize(result_.plain) < s.plain_least ||
            std::ssize(result_.points) < s.points_least) {
            mistake(result_.node->keyword().span(), fmt::format("{} is not complete", s.name),
                    fmt::format("write it as: {}", s.usage));
        }
    }

    void report_surplus(const Word& word) {
        const Statement& s = statement();
        std::string otherwise = fmt::format("write it as: {}", s.usage);
        std::vector<std::string_view> known = s.flags;
        for (const KeyRule& key : s.keys) {
            if (key.name == word.text)
                otherwise = fmt::format("write {}=... without spaces", key.name);
            known.push_back(key.name);
        }
        if (word.text.find_first_of("+*/,") != std::string_view::npos) {
            otherwise = "points are written x,y and arithmetic a+b, without spaces";
        }
        mistake(word.span(), fmt::format("'{}' is not expected here", word.text),
                std::ranges::count(known, word.text) > 0
                    ? otherwise
                    : did_you_mean(word.text, known, otherwise));
    }

    const Scope& scope_;
    Context& context_;
    Arguments result_;
};

}  // namespace

std::optional<double> Arguments::number(std::string_view key) const {
    const auto found = values.find(key);
    if (found == values.end()) return std::nullopt;
    return found->second.numbers[0];
}

double Arguments::number_or(std::string_view key, double otherwise) const {
    return number(key).value_or(otherwise);
}

std::uint32_t Arguments::count(std::string_view key) const {
    constexpr double most = 4e9;
    return static_cast<std::uint32_t>(std::min(most, number_or(key, 0.0)));
}

Vec2 Arguments::pair_or(std::string_view key, Vec2 otherwise) const {
    const auto found = values.find(key);
    if (found == values.end()) return otherwise;
    return {found->second.numbers[0], found->second.numbers[1]};
}

std::optional<Word> Arguments::word(std::string_view key) const {
    const auto found = values.find(key);
    if (found == values.end()) return std::nullopt;
    return found->second.value;
}

Span Arguments::span_of(std::string_view key) const {
    const auto found = values.find(key);
    return found == values.end() ? node->keyword().span() : found->second.value.span();
}

Arguments read_arguments(const Node& node, const Scope& scope, Context& context) {
    return Reading(node, scope, context).read();
}

std::optional<double> read_number(const Word& word, const Label& label, Measure measure,
                                  Bound bound, const Scope& scope, Context& context) {
    const std::optional<Value> value = evaluate(word, scope, context.rules(), context.reporter);
    if (!value) return std::nullopt;
    const std::optional<double> number = converted(word, *value, label, measure, context);
    if (!number) return std::nullopt;
    return bounded(word, *number, label, measure, bound, context);
}

std::optional<std::pair<double, double>> read_range(const Word& word, const Label& label,
                                                    Measure measure, Bound bound,
                                                    const Scope& scope, Context& context) {
    const std::vector<Word> ends = split_outside_brackets(word, "..");
    if (ends.size() > 2) {
        context.reporter.error(word.span(), "a range has two ends",
                               fmt::format("write {}a..b", lead_of(label)));
        return std::nullopt;
    }
    const auto low = read_number(ends.front(), label, measure, bound, scope, context);
    if (ends.size() == 1 || !low) return low ? std::optional(std::pair{*low, *low}) : std::nullopt;
    const auto high = read_number(ends.back(), label, measure, bound, scope, context);
    if (!high) return std::nullopt;
    if (*low > *high) {
        context.reporter.error(word.span(), fmt::format("the range {} runs backwards", word.text),
                               "write the smaller end first");
        return std::nullopt;
    }
    return std::pair{*low, *high};
}

}  // namespace carom
