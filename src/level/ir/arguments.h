#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "level/ir/context.h"

/// The words of one statement, sorted by its row of the table of statements.
namespace carom {

/// A key and its value, in the world's units (angles in degrees).
struct Argument {
    Word value;
    std::array<double, 4> numbers{};
};

/// The words of one statement, sorted and evaluated.
struct Arguments {
    const Node* node = nullptr;
    const Statement* statement = nullptr;
    std::vector<Word> plain;
    std::vector<Vec2> points;
    std::vector<Word> point_words;
    std::vector<Vec2> places;  ///< of a key that repeats
    std::vector<Word> place_words;
    std::map<std::string_view, Argument> values;
    std::vector<std::pair<Word, Word>> own_keys;  ///< of let, part and place: name, expression
    std::set<std::string_view> flags;
    bool is_valid = true;  ///< false: mistakes were reported, or something used is poisoned

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

}  // namespace carom
