#pragma once

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
    void name_balls(const std::vector<StartingBall>& balls);

    /// Names the edges: the only edge of a name has that name, of several the second has NAME.2.
    /// Call before edges are removed.
    void name_edges();
    /// Only these edges are left, by their numbers, ascending.
    void keep_edges(std::vector<std::uint32_t> numbers) { edge_numbers_ = std::move(numbers); }
    /// The number of the ball, or of the edge, of this name; none: no such.
    std::optional<std::uint32_t> ball_named(std::string_view name);
    std::optional<std::size_t> edge_named(std::string_view name);
    /// All names of balls and edges.
    std::vector<std::string_view> body_names() const;
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
    struct Bins {
        std::string name;
        std::vector<std::uint32_t> zones;  ///< indices into LevelIr::zones, left to right
        std::uint32_t first_counter = 0;
    };
    // symbol_table.cpp: names
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
    std::vector<std::string> ball_names_;
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
