#pragma once

#include <deque>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "level/draft.h"
#include "level/expression.h"
#include "level/load.h"
#include "level/transform.h"

/// What the stages of loading share, and the reading of one statement's words.
namespace carom {

/// A `let`, told by where it stands: unrolled a thousand times it is still one.
struct LetUse {
    Span span;
    std::string name;
    bool is_used = false;
};

/// A statement, and a word of it: the same each time that the statement is unrolled. Only looked
/// up, never walked through, so that no order depends on addresses.
using NamingKey = std::pair<const Node*, const char*>;

struct Context {
    Reporter reporter;
    Draft draft;
    LengthUnit unit = LengthUnit::natural;
    /// The `units` line had a mistake: nothing is concluded from units.
    bool is_unit_unknown = false;
    /// Top-level lets and their lines, known before the unrolling.
    std::map<std::string, int, std::less<>> lets_ahead;
    std::map<const char*, LetUse> lets;
    std::map<NamingKey, std::size_t> naming_index;
    std::map<NamingKey, std::size_t> ball_naming_index;
    std::uint64_t seed = 0;
    /// Too many balls or edges: no more are unrolled.
    bool is_full = false;

    ExpressionRules rules() const {
        return {is_unit_unknown ? LengthUnit::millimetre : unit, &lets_ahead};
    }
};

/// Where a statement is carried out.
struct Frame {
    Scope* scope = nullptr;
    Transform transform;
    bool is_top = true;
    int image = 0;
    int depth = 0;
};

/// A key and its value, in the world's units (angles in degrees).
struct Argument {
    Word value;
    double numbers[4] = {};
};

/// The words of one statement, sorted and evaluated.
struct Arguments {
    const Node* node = nullptr;
    const Statement* statement = nullptr;
    std::vector<Word> plain;
    std::vector<Vec2> points;
    std::vector<Word> point_words;
    std::map<std::string_view, Argument> values;
    std::vector<std::pair<Word, Word>> own_keys;  ///< of let, part and place: name, expression
    std::set<std::string_view> flags;
    bool is_sound = true;  ///< false: mistakes were reported, or something used is poisoned

    bool has(std::string_view key) const { return values.contains(key); }
    /// The first number of a key; none where it is absent.
    std::optional<double> number(std::string_view key) const;
    double number_or(std::string_view key, double otherwise) const;
    /// Pre: the value is a whole number.
    std::uint32_t count(std::string_view key) const;
    Vec2 pair_or(std::string_view key, Vec2 otherwise) const;
    std::optional<Word> word(std::string_view key) const;
    bool flag(std::string_view name) const { return flags.contains(name); }
    /// The value of a key, or the keyword where it is absent.
    Span span_of(std::string_view key) const;
};

/// Reads a node by its statement's row of the table. Reports everything that is wrong with it.
Arguments read_arguments(const Node& node, const Scope& scope, Context& context);

/// What a message calls a number, and how its remedy writes it: r=2, rate 120, or just 2.
struct Label {
    std::string_view name;
    std::string_view joint = "=";  ///< empty: the remedy shows the number alone
};

/// One number, in the world's units (angles in degrees), within bounds. None: reported, or poison.
std::optional<double> read_number(const Word& word, const Label& label, Measure measure,
                                  Bound bound, const Scope& scope, Context& context);

/// "x" or "a..b": the two ends, in order.
std::optional<std::pair<double, double>> read_range(const Word& word, const Label& label,
                                                    Measure measure, Bound bound,
                                                    const Scope& scope, Context& context);

}  // namespace carom
