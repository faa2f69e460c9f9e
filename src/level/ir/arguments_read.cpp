#include "level/ir/arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "level/ir/numbers.h"
#include "level/text/brackets.h"
#include "level/text/joined.h"
#include "level/text/spelling.h"
#include "level/values/color_names.h"

namespace carom {
namespace {

// Parses the words of one statement.
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
        if (context_.reporter.errors() == errors && result_.is_valid) check_counts();
        if (context_.reporter.errors() != errors) result_.is_valid = false;
        return std::move(result_);
    }

  private:
    const Statement& statement() const { return *result_.statement; }

    void mistake(FaultCode code, const Span& at, std::string message, std::string remedy) {
        context_.reporter.error(code, at, std::move(message), std::move(remedy));
        result_.is_valid = false;
    }

    // Reports the first lone sign of "a = 1" or "W / 2", and not the words around it as well.
    bool check_spaces(const std::vector<Word>& words) {
        if (statement().takes_lone_signs || statement().is_sentence) return true;
        for (const Word& word : words) {
            if (word.text.find_first_not_of("=+-*/^,") != std::string_view::npos) continue;
            const bool is_key = word.text == "=";
            const bool is_expect = is_key && statement().name == "expect";
            mistake("lone-sign", word.span(), fmt::format("'{}' stands alone", word.text),
                    is_expect ? "write: expect QUANTITY VALUE within TOLERANCE"
                    : is_key  ? "write key=value without spaces"
                              : "arithmetic and points are written without spaces: W/2,0");
            return false;
        }
        return true;
    }

    // Plain words come first. After a point or a key, a word that is no flag is an error.
    void read_plain(const Word& word) {
        if (result_.points.empty() && result_.values.empty() && result_.own_keys.empty()) {
            result_.plain.push_back(word);
        } else if (result_.is_valid) {
            report_surplus(word);
        }
    }

    void read_word(const Word& word) {
        if (word.text[0] == '"' || statement().is_sentence) {
            result_.plain.push_back(word);
            return;
        }
        const std::size_t equals = word.text.find('=');
        if (word.text == "<=" || word.text == ">=") {
            read_plain(word);
        } else if (equals != std::string_view::npos) {
            read_key(word, equals);
        } else if (std::ranges::count(statement().flags, word.text) > 0) {
            result_.flags.insert(word.text);
        } else if (statement().points_most > 0 && split_outside_brackets(word, ",").size() > 1) {
            read_point(word);
        } else {
            read_plain(word);
        }
    }

    void read_point(const Word& word) {
        const std::optional<Vec2> point =
            read_pair(word, "", statement().point_measure, Bound::any, scope_, context_);
        if (!point) {
            result_.is_valid = false;
            return;
        }
        result_.points.push_back(*point);
        result_.point_words.push_back(word);
    }

    void read_key(const Word& word, std::size_t equals) {
        const Word name = word.part(0, equals);
        const Word value = word.part(equals + 1);
        const auto key = std::ranges::find(statement().keys, name.text, &KeyRule::name);
        if (key != statement().keys.end()) {
            if (result_.values.contains(key->name) && !key->repeats) {
                mistake("key-twice", name.span(), fmt::format("{}= stands here twice", name.text),
                        "keep one of them");
            } else if (value.text.empty()) {
                mistake("key-without-value", word.span(),
                        fmt::format("{}= has no value", name.text),
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
            mistake("value-without-key", word.span(), "'=' has no key before it",
                    "write key=value without spaces");
            return;
        }
        if (!is_identifier(name.text)) {
            mistake("not-a-name", name.span(), fmt::format("'{}' is not a name", name.text),
                    "a name has letters, digits and '_', and begins with a letter");
            return;
        }
        std::vector<std::string_view> known;
        for (const KeyRule& key : statement().keys)
            known.push_back(key.name);
        mistake(
            "unknown-key", name.span(),
            fmt::format("{} has no key '{}'", statement().name, name.text),
            did_you_mean(name.text, known,
                         known.size() < 2 ? fmt::format("write it as: {}", statement().usage)
                                          : fmt::format("its keys are: {}", joined(known, " "))));
    }

    void read_value(const KeyRule& key, const Word& value) {
        Argument argument{value, {}};
        if (!read_numbers(key, argument)) {
            result_.is_valid = false;
            return;
        }
        if (key.repeats) {
            result_.places.push_back({argument.numbers[0], argument.numbers[1]});
            result_.place_words.push_back(value);
        }
        result_.values.emplace(key.name, argument);
    }

    bool read_numbers(const KeyRule& key, Argument& argument) {
        const Word& value = argument.value;
        switch (key.shape) {
            case KeyShape::scalar: {
                const auto number =
                    read_number(value, {key.name}, key.measure, key.bound, scope_, context_);
                argument.numbers[0] = number.value_or(0.0);
                if (number && *number != 0.0) note_need(key, value);
                return number.has_value();
            }
            case KeyShape::pair: {
                const auto pair =
                    read_pair(value, key.name, key.measure, key.bound, scope_, context_);
                argument.numbers[0] = pair.value_or(Vec2{}).x;
                argument.numbers[1] = pair.value_or(Vec2{}).y;
                return pair.has_value();
            }
            case KeyShape::range: {
                const auto range =
                    read_range(value, {key.name}, key.measure, key.bound, scope_, context_);
                if (range) {
                    argument.numbers[0] = range->first;
                    argument.numbers[1] = range->second;
                }
                return range.has_value();
            }
            case KeyShape::box: {
                const auto box = read_box(value, key.name, key.measure, scope_, context_);
                argument.numbers = box.value_or(argument.numbers);
                return box.has_value();
            }
            case KeyShape::word:
                return read_name(key, value);
            case KeyShape::color:
                return read_color(key, argument);
            case KeyShape::deferred:
            case KeyShape::call:
                break;
        }
        return true;
    }

    // Records a value that needs `use spin`, which may come later in the file (check_terms).
    void note_need(const KeyRule& key, const Word& value) {
        if (!key.needs_spin) return;
        if (context_.spin_needs_seen.insert(value.text.data()).second)
            context_.ir.spin_needs.push_back({key.name, value});
    }

    bool read_color(const KeyRule& key, Argument& argument) {
        const std::string_view text = argument.value.text;
        if (const auto color = color_of(text)) {
            argument.numbers[0] = *color;
            return true;
        }
        mistake("unknown-color", argument.value.span(),
                fmt::format("there is no colour '{}'", text),
                text.starts_with('#')
                    ? "write six hexadecimal digits, such as #d92b2b"
                    : did_you_mean(
                          text, color_names(),
                          fmt::format("write {}=red, {}=#d92b2b or another; docs/levels.md has "
                                      "the names",
                                      key.name, key.name)));
        return false;
    }

    bool read_name(const KeyRule& key, const Word& value) {
        if (is_identifier(value.text)) return true;
        mistake("not-a-name", value.span(), fmt::format("'{}' is not a name", value.text),
                fmt::format("write {}=NAME", key.name));
        return false;
    }

    void check_counts() {
        const Statement& s = statement();
        for (const KeyRule& key : s.keys) {
            if (key.is_required && !result_.values.contains(key.name)) {
                // "ball a 3,4": the point that should be at=3,4.
                const auto point = std::ranges::find_if(result_.plain, [](const Word& word) {
                    return word.text.find(',') != std::string_view::npos;
                });
                const bool has_point = key.name == "at" && point != result_.plain.end();
                mistake("key-missing", has_point ? point->span() : result_.node->keyword().span(),
                        fmt::format("{} needs {}=", s.name, key.name),
                        has_point ? fmt::format("write at={}", point->text)
                                  : fmt::format("write it as: {}", s.usage));
                return;
            }
        }
        if (std::ssize(result_.plain) > s.plain_most) {
            report_surplus(result_.plain[static_cast<std::size_t>(s.plain_most)]);
            return;
        }
        if (std::ssize(result_.points) > s.points_most) {
            const Word& word = result_.point_words[static_cast<std::size_t>(s.points_most)];
            mistake("too-many-points", word.span(),
                    fmt::format("{} takes no more than {} points", s.name, s.points_most),
                    fmt::format("write it as: {}", s.usage));
            return;
        }
        if (std::ssize(result_.plain) < s.plain_least ||
            std::ssize(result_.points) < s.points_least) {
            mistake("statement-incomplete", result_.node->keyword().span(),
                    fmt::format("{} is not complete", s.name),
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
        mistake("unexpected-word", word.span(), fmt::format("'{}' is not expected here", word.text),
                std::ranges::count(known, word.text) > 0
                    ? otherwise
                    : did_you_mean(word.text, known, otherwise));
    }

    const Scope& scope_;
    Context& context_;
    Arguments result_;
};

}  // namespace

Arguments read_arguments(const Node& node, const Scope& scope, Context& context) {
    return Reading(node, scope, context).read();
}

}  // namespace carom
