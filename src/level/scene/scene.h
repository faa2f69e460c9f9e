#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes.h"
#include "level/scene/pinball_table.h"
#include "level/scene/pool_table.h"
#include "level/scene/quantities.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// A level, loaded: the world at its start, and all that is about the world but not in it.
namespace carom {

/// The unit of bare lengths in the level's text. Inside, everything is SI; `natural` has no units
/// at all.
enum class LengthUnit : std::uint8_t { natural, millimetre, centimetre, metre, inch };

/// What a level wants drawn beside the world.
struct Show {
    enum class What : std::uint8_t { histogram, energy };
    What what = What::histogram;
    /// Histogram: of which group of zones, as indices into World::counters, left to right.
    std::vector<std::uint32_t> counters;
    std::string of;
    /// Histogram: the expected share of each counter; empty: no curve.
    std::vector<double> expected;
    std::string against;
};

/// An experiment with a number to check.
struct Expect {
    std::string quantity;  ///< as the level says it
    Quantity what;
    double value = 0.0;
    double tolerance = 0.0;
    std::optional<double> at;  ///< s; none: the end of the run
    int line = 0;
};

/// A name that stands for balls, edges or zones.
struct Group {
    std::string name;
    std::vector<BallId> balls;
    std::vector<CapsuleId> capsules;
    std::vector<std::uint32_t> counters;
};

/// That `path`, as an include in one file says it, is another file. Both by Scene::files.
struct Include {
    std::size_t from = 0;
    std::size_t file = 0;
    std::string path;

    friend bool operator==(const Include&, const Include&) = default;
};

struct Scene {
    std::string file;
    std::string title;  ///< printable, as the comment is
    /// The comment that opens the file, without the marks and the blanks that all of its lines
    /// begin with: what it shows and what to try.
    std::vector<std::string> comment;
    World world;
    Box view;  ///< what the camera shows
    LengthUnit unit = LengthUnit::natural;
    /// The solver that the level (or an override) names; none: carom picks.
    std::optional<SolverSettings> solver;

    std::vector<std::string> ball_names;      ///< by ball number; empty where a ball has none
    std::vector<std::string> kind_names;      ///< by World::kinds
    std::vector<std::string> material_names;  ///< by World::materials
    std::vector<std::string> zone_names;      ///< by World::zones
    std::vector<std::string> counter_names;   ///< by World::counters
    std::vector<Group> groups;
    /// Capsules of each closed edge and box, in order: what `escaped` means.
    std::vector<std::vector<CapsuleId>> outlines;
    std::vector<Show> shows;
    std::vector<Expect> expects;
    /// The level's text and all that was included, for hashes, for --watch and for recordings.
    std::vector<std::string> files;
    std::vector<std::string> texts;  ///< by `files`
    std::vector<Include> includes;   ///< in the order in which they were first met
    std::uint64_t text_hash = 0;
    /// There is an override, or options changed solver, rate or seed: `expect` is not judged.
    bool overridden = false;
    /// What is played: "sandbox" where the level does not say.
    std::string game = "sandbox";
    PoolTable pool;
    PinballTable table;
};

}  // namespace carom
