#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "level/language/blocks.h"
#include "level/scene/scene.h"
#include "level/values/expression.h"

/// A level with its arithmetic done and its blocks unrolled, but its names not yet looked up:
/// order in the file is free, so kinds and materials may come last. All numbers are the world's
/// (SI or natural; radians).
namespace carom {

struct KindIr {
    Word name;
    std::optional<double> radius;
    std::optional<double> mass;
    std::optional<double> density;
    std::optional<double> restitution;
    double friction = 0.0;
    bool is_valid = true;  ///< false: it had a mistake, so nothing is concluded from it
};

struct MaterialIr {
    Word name;
    Material values;
    std::uint8_t layer = 0;  ///< on which its edges stand
};

/// What a statement calls the edges that it draws. The words say no more than that: whether the
/// first of `plain` is a material or a name is decided when all materials are known.
struct EdgeBinding {
    const Node* node = nullptr;
    std::vector<Word> plain;
    bool may_begin_with_material = false;
    std::optional<Word> material{};  ///< of a key material=
    bool makes_edges = true;         ///< false: only zones, which have no material
    /// Of a part: what it is made of where no material is named, and its kick in any case.
    std::optional<Material> device_material{};
};

/// What a statement calls its balls, and of which kind they are.
struct BallBinding {
    const Node* node = nullptr;
    std::optional<Word> name;
    std::optional<Word> kind;
    bool is_numbered = false;  ///< also the first has a suffix: a cradle's
};

/// Where something comes from: for messages, and to tell copies made by `mirror`.
struct Origin {
    Span span;
    int image = 0;  ///< which image, of any mirror; 0: the original
};

struct BallIr {
    Vec2 position;
    Vec2 velocity;
    std::optional<double> radius;
    std::optional<double> mass;
    std::optional<double> restitution;
    double spin = 0.0;  ///< rad/s
    std::optional<Vec2> roll;
    /// Of a rack: how far from `position`, in diameters and gaps.
    Vec2 racked;
    double gap = 0.0;
    int binding = 0;  ///< index into LevelIr::ball_bindings
    Origin origin;
};

struct CapsuleIr {
    Capsule shape;
    Side side = Side::both;
    int binding = 0;  ///< index into LevelIr::edge_bindings
    int chain = 0;    ///< pieces of one edge, arc or box share it
    Origin origin;
    int device = -1;  ///< index into LevelIr::devices; -1: none
};

struct ChainIr {
    bool is_closed = false;
    bool has_gaps = true;  ///< false: no ball comes to its ends, so gaps there are no mistake
};

struct ZoneIr {
    Zone zone;
    int binding = 0;  ///< index into LevelIr::edge_bindings
    Origin origin;
    int device = -1;  ///< index into LevelIr::devices; -1: none
    bool is_pocket = false;
};

/// A device, but for what it is drawn as: the capsules and zones that refer to it. One to which
/// nothing refers (the twin of another in a mirror) is no device, but for a lamp.
struct DeviceIr {
    Device device;
    int binding = 0;  ///< index into LevelIr::edge_bindings
    std::optional<Flipper> flipper{};
    Button button = Button::left_flipper;  ///< of the flipper
    Origin origin{};
};

/// An action and a rule, before their names are looked up.
struct RuleActionIr {
    RuleAction action;
    std::optional<Word> group;
};
struct RuleIr {
    Word name;
    Word when_word;
    Rule::When when = Rule::When::hit;
    struct Need {
        Word name;
        bool is_not = false;
    };
    std::vector<Need> needs;
    std::vector<RuleActionIr> actions;
};

/// Where balls are racked; the balls themselves are drafts of their own.
struct RackIr {
    Rack::Shape shape = Rack::Shape::eight;
    Vec2 foot;
    Vec2 toward;
    int binding = 0;  ///< index into LevelIr::ball_bindings
};

struct CueIr {
    Word ball;
    double least_power = 0.0;
    double most_power = 0.0;
};

struct EmitterIr {
    Word kind;
    Emitter emitter;
    Origin origin;
};

/// Balls to be placed by chance, once all else stands.
struct FillIr {
    std::optional<Word> kind;
    std::uint32_t count = 0;
    Box box;
    double least_radius = 0.0;  ///< 0: the kind's
    double most_radius = 0.0;
    std::optional<Word> radius_of_mass;  ///< r= where it is an expression of the mass m
    Scope scope;                         ///< what has a value in it
    double least_mass = 0.0;             ///< 0: the kind's
    double most_mass = 0.0;
    std::optional<double> density;
    std::optional<double> restitution;
    Vec2 velocity;
    double least_speed = 0.0;
    double most_speed = 0.0;
    double rms_speed = 0.0;
    std::size_t balls_before = 0;  ///< LevelIr::balls that precede it in the file
    int number = 0;                ///< its own stream of chance
    Origin origin;
};

struct CollideIr {
    Word a;
    Word b;
};

struct ShowIr {
    Show::What what = Show::What::energy;
    std::optional<Word> of;
    std::optional<Word> against;
    Span span;
};

struct ExpectIr {
    Word quantity;
    double value = 0.0;
    double tolerance = 0.0;
    std::optional<double> at;
};

/// A value other than 0 that means something only under `use spin`.
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
    std::optional<double> inertia;  ///< the same, where the level says it
    std::optional<Cloth> cloth;
    std::optional<Span> cloth_at;
    std::optional<Span> wrap;
    bool may_overlap = false;
    std::optional<Box> world;
    std::optional<SolverSettings> solver;
    std::optional<double> rate;
    std::optional<std::uint64_t> seed;
    std::optional<std::string> game;
    std::optional<Span> game_at;
    PinballTable table;      ///< its settings, of `game pinball`
    std::uint32_t race = 0;  ///< of a game of pool, and so is the clock
    double clock = 0.0;
};

/// What a letter of a map stands for.
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
    std::vector<BallIr> balls;
    std::vector<CapsuleIr> capsules;
    std::vector<ChainIr> chains;
    std::vector<ZoneIr> zones;
    std::vector<EmitterIr> emitters;
    std::vector<FillIr> fills;
    std::vector<RackIr> racks;
    std::vector<CueIr> cues;
    std::vector<DeviceIr> devices;
    std::vector<RuleIr> rules;
    std::vector<CollideIr> collides;
    std::vector<SpinNeed> spin_needs;
    std::optional<Span> needs_cloth;  ///< the first value that means nothing without it
    std::vector<ShowIr> shows;
    std::vector<ExpectIr> expects;
    std::map<std::string, LegendIr, std::less<>> legends;  ///< by letter
    /// Names of balls, edges and bins whose statements had a mistake: they exist all the same.
    std::vector<std::string> error_names;
    std::uint64_t balls_reserved = 0;  ///< balls, fills and emitters together
};

/// Most kinds and materials together.
inline constexpr std::size_t max_classes = 1000;

/// Most balls, most edges and most statements that a level may unroll to.
inline constexpr std::uint64_t max_items = 1'000'000;

}  // namespace carom
