#pragma once

#include "level/assemble/assemble.h"
#include "level/assemble/resolve_names.h"

/// Names that people give to balls, edges and bins, and what refers to them.
namespace carom {

class SymbolTable {
  public:
    SymbolTable(const LevelIr& ir, const ResolvedNames& names, Context& context)
        : ir_(ir), names_(names), context_(context) {}

    /// Gives each named ball its own name: the first of a statement the plain one, its copies
    /// NAME.2, NAME.3 ...; a cradle's balls NAME.1, NAME.2 ... Reports names that are taken.
    void name_balls(const std::vector<StartingBall>& balls);

    /// Reports what `show` and `expect` say wrong, without a world.
    void check_references();

    /// Pre: the scene's world has all balls and capsules. Fills in names, groups, zones, counters,
    /// shows and expects.
    void fill_in(Scene& scene);

    /// By LevelIr::zones, the index into World::zones. Pre: filled in.
    const std::vector<std::uint32_t>& world_zones() const { return world_zones_; }

  private:
    struct Bins {
        std::string name;
        std::vector<std::uint32_t> zones;  ///< indices into LevelIr::zones, left to right
        std::uint32_t first_counter = 0;
    };
    void collect_bins();
    const Bins* bins_named(const Word& name);
    bool is_error_name(std::string_view name) const;
    std::optional<Show> make_show(const ShowIr& spec);
    std::optional<std::vector<double>> expected_shares(const Word& against, std::size_t bins);
    std::optional<Expect> make_expect(const ExpectIr& spec);
    std::optional<Quantity> quantity_of(const Word& word);
    std::optional<Quantity> ball_quantity(const Word& word, std::size_t dot);
    std::optional<Quantity> bins_quantity(const Word& word, std::size_t open);

    const LevelIr& ir_;
    const ResolvedNames& names_;
    Context& context_;
    std::vector<std::string> ball_names_;
    std::map<std::string, std::uint32_t, std::less<>> ball_numbers_;
    std::vector<Bins> bins_;
    std::map<std::string, std::size_t, std::less<>> bins_index_;
    std::vector<std::uint32_t> world_zones_;
    std::vector<Show> shows_;
    std::vector<Expect> expects_;
};

}  // namespace carom
