#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "level/ir/ball_list.h"
#include "level/ir/rules_ir.h"
#include "level/language/blocks.h"
#include "level/scene/scene.h"
#include "level/values/expression.h"

/// The intermediate representation (IR) of a level. Its arithmetic is done and its blocks are
/// expanded, but its names are not resolved, since a kind or a material may be declared after its
/// use. An XIr is the IR of an X of the scene. All numbers are in the units of the world (SI or
/// natural, radians).
namespace carom {

struct KindIr {
    Word name;
    std::optional<double> radius;
    std::optional<double> mass;
    std::optional<double> density;
    std::optional<double> restitution;
    double friction = 0.0;
    std::optional<Rgb24> color{};
    bool is_valid = true;  ///< false: its statement had an error
};

struct MaterialIr {
    Word name;
    Material values;
    std::uint8_t layer = 0;  ///< the layer of its edges
    std::optional<Rgb24> color{};
};

/// Binds the edges of a statement to a material and a name. Whether the first of `plain` is a
/// material or a name is known when all materials are.
struct EdgeBinding {
    const Node* node = nullptr;
    std::vector<Word> plain;
    bool may_begin_with_material = false;
    std::optional<Word> material{};  ///< the value of material=; `plain` then has no material
    std::optional<Word> name{};      ///< the value of name=; `plain` then has no name
    bool makes_edges = true;         ///< false: the statement makes zones, which have no material
    /// A pinball device: its material where the author names none; its kick in any case.
    std::optional<Material> device_material{};
    std::optional<Rgb24> color{};
};

/// How a cradle hangs. `up`: from a ball to its pivot, length; `swing`: how far balls that move at
/// the start are from their place at rest.
struct CradleIr {
    Vec2 up;
    double swing = 0.0;
    std::uint32_t count = 0;
};

/// Binds the balls of a statement to a name and a kind.
struct BallBinding {
    const Node* node = nullptr;
    std::optional<Word> name;
    std::optional<Word> kind;
    bool is_numbered = false;  ///< the first ball has a suffix too, as in a cradle
    std::optional<Rgb24> color{};
    std::optional<CradleIr> cradle{};
};

struct CapsuleIr {
    Capsule shape;
    int binding = 0;  ///< index into LevelIr::edge_bindings
    int chain = 0;    ///< index into LevelIr::chains; pieces of one edge share it
    Origin origin;
    int device = -1;  ///< index into LevelIr::devices; -1: none
    Side side = Side::both;
    bool is_moved = false;  ///< by a motion, or on a hinge
};

struct ChainIr {
    bool is_closed = false;
    bool is_smooth = false;  ///< a curve: an arc, a polyline with fillets, or one that says so
    bool has_gaps = true;    ///< false: gaps at its ends are intended
};

struct ZoneIr {
    Zone zone;
    int binding = 0;  ///< index into LevelIr::edge_bindings
    Origin origin;
    int device = -1;  ///< index into LevelIr::devices; -1: none
    bool is_pocket = false;
};

/// A pinball device. Its shapes are the capsules and zones that refer to it. A device without
/// shapes is a mirror duplicate, and dropped, unless it is a lamp.
struct DeviceIr {
    Device device;
    int binding = 0;  ///< index into LevelIr::edge_bindings
    std::optional<Flipper> flipper{};
    Button button = Button::left_flipper;  ///< moves the flipper
    Origin origin{};
    DeviceDress dress{};
};

/// The place of a rack. Its balls are among LevelIr::balls.
struct RackIr {
    const RackLayout* layout = nullptr;
    Vec2 foot;
    Vec2 toward;
    double gap = 0.0;
    std::optional<std::uint64_t> seed{};
    int binding = 0;  ///< index into LevelIr::ball_bindings
};

struct CueIr {
    Word ball;
    double least_power = 0.0;
    double most_power = 0.0;
    double scatter = 0.0;  ///< degrees
};

struct EmitterIr {
    Word kind;
    Emitter emitter;
    Origin origin;
};

/// Balls that assembly places at random, after everything else.
struct FillIr {
    std::optional<Word> kind;
    std::uint32_t count = 0;
    Box box;
    double least_radius = 0.0;  ///< 0: that of the kind
    double most_radius = 0.0;
    std::optional<Word> radius_of_mass;  ///< r=, if it is an expression in the mass m
    Scope scope;                         ///< the variables that radius_of_mass uses
    double least_mass = 0.0;             ///< 0: that of the kind
    double most_mass = 0.0;
    std::optional<double> density;
    std::optional<double> restitution;
    Vec2 velocity;
    double least_speed = 0.0;
    double most_speed = 0.0;
    double rms_speed = 0.0;
    std::size_t balls_before = 0;  ///< how many LevelIr::balls precede it in the file
    int number = 0;                ///< index of its random stream
    Origin origin;
};

/// A change to a body that another statement has placed: see amendments.cpp and assemble/amend.h.
struct AmendmentIr {
    Span span;
    // The body: one of these.
    std::optional<Word> name{};
    std::optional<std::uint32_t> ball{};  ///< its number, in the order of the file
    std::optional<std::uint32_t> edge{};
    bool removes = false;
    // Of a ball; none: unchanged.
    std::optional<Vec2> position{};
    std::optional<Vec2> velocity{};
    std::optional<double> spin{};
    std::optional<Vec2> roll{};
    std::vector<Vec2> ends{};  ///< of an edge: one place, for a peg, or both ends
    // Of a motion; none: unchanged.
    std::optional<double> clock{};  ///< s
    std::optional<bool> runs{};
    bool is_of_motion() const { return clock || runs; }
    // Of a seesaw; none: unchanged.
    std::optional<double> tilt{};     ///< degrees
    std::optional<double> turning{};  ///< rad/s
    bool is_of_seesaw() const { return tilt || turning; }
};

/// A motion, and the edges that it moves, by name. The mover has no edges yet.
struct MotionIr {
    std::vector<Word> names;  ///< the first is that of the motion
    Mover mover;
    Span at;
    Span every_at;
    Span time_at;
    bool waits = false;  ///< from the start
};

/// A seesaw, and the edge that turns, by name. It has no edge, home and inertia yet.
struct SeesawIr {
    Word name;
    Seesaw seesaw;
    double mass = 1.0;  ///< of a bar along the edge
    Span stops_at;
    Span tilt_at;
};

struct CollideIr {
    Word a;
    Word b;
};

struct ShowIr {
    Show::What what = Show::What::energy;
    Observable observable{};
    std::optional<Word> of;
    std::optional<Word> against;
    Span span;
};

struct ExpectIr {
    Word quantity;
    Expect expect;  ///< without its quantity
};

/// A value other than 0 that has an effect only under `use spin`.
struct SpinNeed {
    std::string_view key;
    Word value;
};

struct LevelSettings {
    std::optional<Vec2> gravity;
    std::optional<double> drag;
    std::optional<double> stop_speed;
    std::optional<double> speed_limit;
    std::optional<double> scatter;  ///< radians
    std::optional<double> spin;     ///< moment of inertia / (m r^2)
    std::optional<double> inertia;  ///< of `use spin inertia=`
    std::optional<Cloth> cloth;
    std::optional<Span> cloth_at;
    std::optional<double> modulus;  ///< E / (1 - nu^2)
    std::optional<Span> modulus_at;
    std::optional<Span> wrap;
    bool may_overlap = false;
    std::optional<Box> world;
    std::optional<SolverSettings> solver;
    Need need;
    std::optional<double> rate;
    std::optional<std::uint64_t> seed;
    std::optional<std::string> game;
    std::optional<Span> game_at;
    PinballTable table;      ///< the settings of `game pinball`; no devices
    std::uint32_t race = 0;  ///< of a game of pool
    double clock = 0.0;      ///< of a game of pool, s
    PoolRules rules;         ///< of a game of pool
    std::uint32_t players = 1;
    bool least_wins = false;  ///< of `game shots`
    bool may_miss = false;    ///< of `game shots`: RuleBook::may_miss
    double settle = 0.0;      ///< of `game shots`, s
    bool is_shots = false;
};

/// The meaning of a letter of a map.
struct LegendIr {
    enum class What { ball, peg, solid };
    What what = What::ball;
    std::optional<Word> kind;
    std::optional<Word> material;
    std::optional<double> radius;
    Vec2 velocity;
};

struct LevelIr {
    LevelSettings settings;
    std::vector<KindIr> kinds;
    std::vector<MaterialIr> materials;
    std::vector<BallBinding> ball_bindings;
    std::vector<EdgeBinding> edge_bindings;
    BallList balls;
    std::vector<CapsuleIr> capsules;
    std::vector<ChainIr> chains;
    std::vector<ZoneIr> zones;
    std::vector<EmitterIr> emitters;
    std::vector<FillIr> fills;
    std::vector<RackIr> racks;
    std::vector<CueIr> cues;
    std::vector<DeviceIr> devices;
    std::vector<RuleIr> rules;
    std::vector<TaskIr> tasks;
    std::vector<GoalIr> goals;
    std::vector<RuleVariable> variables;
    std::vector<RuleTimer> timers;
    std::map<std::string, RuleSymbolIr, std::less<>> rule_symbols;  ///< variables and timers
    std::vector<CollideIr> collides;
    std::vector<AmendmentIr> amendments;
    std::vector<MotionIr> motions;
    std::vector<SeesawIr> seesaws;
    std::vector<SpinNeed> spin_needs;
    std::optional<Span> needs_cloth;  ///< the first value that needs `use cloth`
    std::vector<ShowIr> shows;
    std::vector<ExpectIr> expects;
    Observation observation;
    std::vector<PaintedArea> areas;
    std::vector<BoardLabel> labels;
    BoardTheme theme;
    std::size_t painted_points = 0;                        ///< corners of areas, and labels
    std::map<std::string, LegendIr, std::less<>> legends;  ///< by letter
    /// Names of balls, edges and bins that are error values: their statements had errors, so
    /// references to them are not reported.
    std::vector<std::string> error_names;
    std::uint64_t balls_reserved = 0;  ///< balls of all statements, fills and emitters
};

/// The most kinds and materials together.
inline constexpr std::size_t max_classes = 1000;

/// The most balls, the most edges, and the most statements that a level may run.
inline constexpr std::uint64_t max_items = 1'000'000;

/// The most zones (bins, pockets, rollovers ...), and the most pinball devices.
inline constexpr std::uint64_t max_zones = 100'000;

/// The most corners of painted areas, circles and labels together.
inline constexpr std::size_t max_painted_points = 100'000;

}  // namespace carom
