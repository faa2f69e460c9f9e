#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes.h"
#include "level/scene/dress.h"
#include "level/scene/observables.h"
#include "level/scene/pinball_table.h"
#include "level/scene/pool_table.h"
#include "level/scene/quantities.h"
#include "level/scene/rules.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// The result of loading a level: the world at its start, and the data that belong to the level but
/// not to the world, such as names, views and experiments.
namespace carom {

/// The unit of lengths written without one. The scene itself is in SI units, or, for `natural`, in
/// the level's own.
enum class LengthUnit : std::uint8_t { natural, millimetre, centimetre, metre, inch };

/// A panel that the level shows beside the world.
struct Show {
    enum class What : std::uint8_t { histogram, energy, observable };
    What what = What::histogram;
    Observable observable{};  ///< of What::observable
    /// Histogram: its bins from left to right, as indices into Ledger::counters.
    std::vector<std::uint32_t> counters;
    std::string of;
    /// Histogram: the expected share of each bin; empty: no curve.
    std::vector<double> expected;
    std::string against;
};

/// An experiment: a quantity of the run, and what the level expects of its value. Units: those of
/// the world.
struct Expect {
    /// How the quantity compares to `value`; `within`: it differs by `tolerance` at most.
    enum class Relation : std::uint8_t { within, less, at_most, more, at_least };
    /// The ticks at which the relation must hold. The last one is that of `at`.
    enum class When : std::uint8_t {
        last,    ///< the last one
        by,      ///< some tick
        always,  ///< every tick
        never    ///< no tick
    };
    std::string quantity;  ///< as the level writes it
    Quantity what;
    double value = 0.0;
    double tolerance = 0.0;
    std::optional<double> at;  ///< s; none: the end of the run
    int line = 0;
    Relation relation = Relation::within;
    When when = When::last;
};

/// "within", "<", "<=", ">", ">=".
std::string_view sign(Expect::Relation relation);
/// Whether the relation of `expect` holds for this value.
bool holds(const Expect& expect, double measured);
/// How far a value is from holding, in its unit; 0 or less: it holds, or is at the bound.
double shortfall(const Expect& expect, double measured);

/// Balls, edges and zones that share a name.
struct Group {
    std::string name;
    std::vector<BallId> balls;
    std::vector<CapsuleId> capsules;
    std::vector<std::uint32_t> counters;
};

/// An include of one file in another, both as indices into Scene::files. `path`: as written in the
/// include.
struct Include {
    std::size_t from = 0;
    std::size_t file = 0;
    std::string path;

    friend bool operator==(const Include&, const Include&) = default;
};

struct Scene {
    // Defined in scene.cpp: the code for so many members is then compiled once.
    Scene();
    Scene(const Scene& other);
    Scene(Scene&& other) noexcept;
    Scene& operator=(const Scene& other);
    Scene& operator=(Scene&& other) noexcept;
    ~Scene();

    std::string file;
    std::string title;  ///< safe to print on a terminal, like the comment
    /// The comment at the top of the file, without its marks and common indentation. It says what
    /// the level shows and what to try.
    std::vector<std::string> comment;
    World world;
    Box view;  ///< the part of the world that the camera shows
    LengthUnit unit = LengthUnit::natural;
    /// The solver that the level or an option names; none: pick_solver decides.
    std::optional<SolverSettings> solver;

    std::vector<std::string> ball_names;  ///< by ball number; empty where a ball has none
    // Edges as `move` and `remove` find them, by capsule id at the start.
    std::vector<std::string> edge_names;      ///< empty: no edge has a name
    std::vector<std::uint32_t> edge_numbers;  ///< in the order of the file; empty: those of the ids
    std::vector<std::string> kind_names;      ///< by World::kinds
    std::vector<std::string> material_names;  ///< by World::materials
    std::vector<std::string> zone_names;      ///< by World::zones
    std::vector<std::string> mover_names;     ///< by World::movers
    std::vector<std::string> counter_names;   ///< by Ledger::counters
    std::vector<Group> groups;
    /// The capsules of each closed edge and box, in order. A ball outside the outline in which it
    /// started has escaped.
    std::vector<std::vector<CapsuleId>> outlines;
    std::vector<Show> shows;
    std::vector<Expect> expects;
    Observation observation;
    /// The level's file and the files that it includes, for hashes, --watch and recordings.
    std::vector<std::string> files;
    std::vector<std::string> texts;  ///< by index of `files`
    std::vector<Include> includes;   ///< in the order of first use
    std::uint64_t text_hash = 0;
    /// An override, or an option for the solver, rate or seed, was given. It changes the level's
    /// meaning, so its `expect` statements are not judged.
    bool overridden = false;
    /// The game to play; "sandbox" where the level names none.
    std::string game = "sandbox";
    PoolTable pool;
    PinballTable table;
    Dress dress;
    RuleBook rules;
};

}  // namespace carom
