#pragma once

#include <span>

#include "level/assemble/assemble.h"
#include "level/assemble/resolve_names.h"

/// The symbol table: the names of balls, edges and bins, and the statements that refer to them.
namespace carom {

class SymbolTable {
  public:
    SymbolTable(const LevelIr& ir, const ResolvedNames& names, Context& context)
        : ir_(ir), names_(names), context_(context) {}

    /// Names the balls: the first ball of a statement NAME gets NAME, and its copies NAME.2, NAME.3
    /// ...; the balls of a cradle or a rack get NAME.1, NAME.2 ... Reports names that are taken.
    /// `bindings`: of each ball, the index into LevelIr::ball_bindings; -1: it was placed by a
    /// fill.
    void name_balls(std::span<const int> bindings);

    /// Names the edges: the only edge of a name has that name, of several the second has NAME.2.
    /// Call before edges are removed.
    void name_edges();
    /// Only these edges are left, by their numbers, ascending.
    void keep_edges(std::vector<std::uint32_t> numbers) { edge_numbers_ = std::move(numbers); }
    /// The number of the ball, or of the edge, of this name; none: no such.
    std::optional<std::uint32_t> ball_named(std::string_view name);
    std::optional<std::size_t> edge_named(std::string_view name);
    /// All names of edges, and one of the balls of each statement.
    std::vector<std::string> body_names() const;
    /// Whether the statement that gives the name had an error.
    bool is_error_name(std::string_view name) const;

    /// Reports unknown names in `show` and `expect`; needs no world.
    void check_references();

    /// Sets the names, groups, zones, counters, shows and expects of the scene. Pre: its world has
    /// all balls and capsules.
    void fill_in(Scene& scene);

    /// The index into World::zones for each of LevelIr::zones. Pre: filled in.
    const std::vector<std::uint32_t>& world_zones() const { return world_zones_; }

  private:
    /// The name that a statement gives to its balls.
    struct BallStatement {
        std::string_view name;
        const Node* node = nullptr;
        bool is_numbered = false;  ///< its first ball has a number too
        std::uint32_t count = 0;
    };
    /// 8 bytes: a level may have a million.
    struct BallName {
        std::uint32_t statement = none;
        std::uint32_t ordinal = 0;  ///< from 1

        auto operator<=>(const BallName&) const = default;
    };
    static constexpr std::uint32_t none = 0xffffffffu;
    struct Bins {
        std::string name;
        std::vector<std::uint32_t> zones;  ///< indices into LevelIr::zones, left to right
        std::uint32_t first_counter = 0;
    };
    // symbol_table.cpp: names
    std::string name_of(const BallName& ball) const;
    std::vector<std::string> names_of_statements() const;
    void collect_bins();
    const Bins* bins_named(const Word& name);
    // symbol_references.cpp: what `show` and `expect` refer to
    std::optional<Show> make_show(const ShowIr& spec);
    std::optional<std::vector<double>> expected_shares(const Word& against, std::size_t bins);
    std::optional<Expect> make_expect(const ExpectIr& spec);
    std::optional<Quantity> quantity_of(const Word& word);
    std::optional<Quantity> ball_quantity(const Word& word, std::size_t dot);
    std::optional<Quantity> edges_quantity(const Word& word, QuantityKind kind);
    std::optional<Quantity> bins_quantity(const Word& word, std::size_t open);

    const LevelIr& ir_;
    const ResolvedNames& names_;
    Context& context_;
    std::vector<BallStatement> ball_statements_;
    std::map<std::string_view, std::uint32_t> ball_statement_index_;
    std::vector<BallName> ball_names_;
    std::vector<std::uint32_t> named_balls_;              ///< by name; filled when first needed
    std::vector<std::uint32_t> edge_numbers_;             ///< of those left; empty: all are
    std::vector<std::string> edge_names_;                 ///< by number; empty: no edge has a name
    std::map<std::string_view, std::size_t> edge_index_;  ///< by name; filled when first needed
    std::vector<Bins> bins_;
    std::map<std::string, std::size_t, std::less<>> bins_index_;
    std::vector<std::uint32_t> world_zones_;
    std::vector<Show> shows_;
    std::vector<Expect> expects_;
};

}  // namespace carom
