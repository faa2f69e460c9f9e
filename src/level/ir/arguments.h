#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "level/ir/context.h"

/// Parses the words of one statement by its row of the statement table.
namespace carom {

/// The value of a key: the word, and its numbers in the units of the world (angles in degrees).
struct Argument {
    Word value;
    std::array<double, 4> numbers{};
};

/// The arguments of one statement, parsed and evaluated.
struct Arguments {
    const Node* node = nullptr;
    const Statement* statement = nullptr;
    std::vector<Word> plain;
    std::vector<Vec2> points;
    std::vector<Word> point_words;
    std::vector<Vec2> places;  ///< one for each use of a key that repeats
    std::vector<Word> place_words;
    std::map<std::string_view, Argument> values;
    std::vector<std::pair<Word, Word>> own_keys;  ///< let, part, place: name and expression
    std::set<std::string_view> flags;
    bool is_valid = true;  ///< false: an error was reported, or an error value used

    bool has(std::string_view key) const { return values.contains(key); }
    /// The first number of a key; none: the key is absent.
    std::optional<double> number(std::string_view key) const;
    double number_or(std::string_view key, double otherwise) const;
    /// The whole number of a key, at most 4e9; 0 if the key is absent.
    std::uint32_t count(std::string_view key) const;
    /// The colour of a key of KeyShape::color.
    std::optional<Rgb24> color(std::string_view key = "color") const;
    Vec2 pair_or(std::string_view key, Vec2 otherwise) const;
    std::optional<Word> word(std::string_view key) const;
    bool flag(std::string_view name) const { return flags.contains(name); }
    /// The span of the value of a key; of the keyword if the key is absent.
    Span span_of(std::string_view key) const;
};

/// Parses a node by the row of its statement, and evaluates its numbers in `scope`. Reports
/// unknown, missing and surplus arguments, and numbers out of bounds. Pre: node.statement is not
/// null.
Arguments read_arguments(const Node& node, const Scope& scope, Context& context);

}  // namespace carom
