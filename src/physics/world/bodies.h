#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/shapes.h"
#include "physics/world/ids.h"
#include "physics/world/model.h"

/// The bodies of a world: balls, which move, and capsules, which are its edges. Both are tables
/// with one vector for each quantity. The position of a body in the vectors is its *index*, which
/// changes when a body before it is removed; its *id* never changes. Rows are in ascending order of
/// id.
///
/// Units: length, mass and time of the level (SI where the level has `units`); angles in radians.
namespace carom {

/// A kind of ball, or a material of edges: what collision filters go by.
using ClassIndex = std::uint16_t;

/// What a kind of ball is made of. Emitters and players make balls from it.
struct Kind {
    double radius = 1.0;
    double mass = 3.14159265358979323846;
    double restitution = 1.0;
    /// Ball on ball, >= 0: the coefficient of a pair is the geometric mean of their kinds'. Used
    /// only with Model::spin.
    double friction = 0.0;
    /// Above 0: above the table, as on a ramp. World::kinds has all kinds of layer 0 first, then
    /// the same kinds in the same order for each layer above.
    std::uint8_t layer = 0;

    friend bool operator==(const Kind&, const Kind&) = default;
};

/// What a kind of edge is made of. The coefficients are those of a ball on the edge.
struct Material {
    double restitution = 1.0;
    /// Restitution at approach speed v is restitution / (1 + soften v). s/length, >= 0.
    double soften = 0.0;
    /// Ball on edge, >= 0, whatever the ball. Used only with Model::spin.
    double friction = 0.0;
    /// A solenoid behind the edge adds this speed along the normal to a ball that approaches at
    /// `kick_from` or faster, length/s, both >= 0. Used only with Model::kicks.
    double kick = 0.0;
    double kick_from = 0.0;
    /// `kick` is the speed in the middle of the edge, and falls off to 0 at its ends as a parabola.
    bool kicks_in_the_middle = false;

    friend bool operator==(const Material&, const Material&) = default;
};

/// A ball to be added. Radius, mass and restitution default to those of the kind.
struct BallSpec {
    ClassIndex kind = 0;
    Vec2 position;
    Vec2 velocity;
    std::optional<double> radius;
    std::optional<double> mass;
    std::optional<double> restitution;
    double spin = 0.0;  ///< rad/s, counter-clockwise; ignored without Model::spin
    /// Ignored without Model::cloth. Absent: the ball rolls without slipping.
    std::optional<Vec2> roll = std::nullopt;

    friend bool operator==(const BallSpec&, const BallSpec&) = default;
};

struct Balls {
    std::vector<BallId> id;
    std::vector<Vec2> position;
    std::vector<Vec2> velocity;
    std::vector<double> radius;                ///< > 0
    std::vector<double> inverse_mass;          ///< > 0; 1/mass
    std::vector<ClassIndex> kind;              ///< index into World::kinds
    std::vector<double> restitution;           ///< ball on ball, 0..1; with Model::inelastic
    std::vector<std::uint32_t> edge_contacts;  ///< contacts with edges so far; with Model::scatter
    std::vector<double> spin;                  ///< rad/s, counter-clockwise; with Model::spin
    std::vector<Vec2> roll;                    ///< length/s, see laws/cloth.h; with Model::cloth

    std::size_t size() const { return id.size(); }

    /// A column: the vector, whether a scene uses it (it is empty otherwise), its value for a new
    /// ball, and how a value is written into a spec; null where a spec does not have it. Code that
    /// sets a term of the model while there are balls fills the columns that the term brings, as
    /// `become_inelastic` does.
    template <typename Value>
    struct Column {
        std::string_view name;
        std::vector<Value> Balls::*values;
        bool (*is_used)(const Model&);
        Value (*of_new)(BallId, const BallSpec&, const Kind&);
        void (*to_spec)(const Value&, BallSpec&) = nullptr;
    };

    /// Calls visit(column) for every column, always in the same order. This is the one list of
    /// columns: adding, removing, copying, undo, the hybrid step, fingerprint and snapshot sizes
    /// all come from it. A new column goes last: fingerprints tell old columns by their place.
    template <typename Visit>
    static constexpr void for_each_column(Visit&& visit);
};

/// Which balls an edge pushes, seen from its start to its end; `none`: it is out of the way, as a
/// drop target that is down.
enum class Side : std::uint8_t { both, left, right, none };

/// The edges in which a piece of a curve continues at its start and at its end; `no_joint` where
/// the curve ends, or has a corner. laws/curve.h says what such a joint is.
using Joints = std::array<CapsuleId, 2>;
inline constexpr CapsuleId no_joint{0xffffffffu};

struct Capsules {
    std::vector<CapsuleId> id;
    std::vector<Capsule> shape;
    std::vector<ClassIndex> material;  ///< index into World::materials
    std::vector<Side> side;            ///< with Model::one_way
    std::vector<Joints> joints;        ///< with Model::curved

    std::size_t size() const { return id.size(); }

    template <typename Value>
    struct Column {
        std::string_view name;
        std::vector<Value> Capsules::*values;
    };

    /// Calls visit(column) for every column; see Balls::for_each_column.
    template <typename Visit>
    static constexpr void for_each_column(Visit&& visit);
};

template <typename Visit>
constexpr void Balls::for_each_column(Visit&& visit) {
    using Spec = BallSpec;
    constexpr auto always = +[](const Model&) { return true; };
    visit(Column<BallId>{"id", &Balls::id, always,
                         +[](BallId ball, const Spec&, const Kind&) { return ball; }});
    visit(Column<Vec2>{"position", &Balls::position, always,
                       +[](BallId, const Spec& spec, const Kind&) { return spec.position; },
                       +[](const Vec2& value, Spec& spec) { spec.position = value; }});
    visit(Column<Vec2>{"velocity", &Balls::velocity, always,
                       +[](BallId, const Spec& spec, const Kind&) { return spec.velocity; },
                       +[](const Vec2& value, Spec& spec) { spec.velocity = value; }});
    visit(Column<double>{"radius", &Balls::radius, always,
                         +[](BallId, const Spec& spec, const Kind& type) {
                             return spec.radius.value_or(type.radius);
                         },
                         +[](const double& value, Spec& spec) { spec.radius = value; }});
    visit(Column<double>{"inverse_mass", &Balls::inverse_mass, always,
                         +[](BallId, const Spec& spec, const Kind& type) {
                             return 1.0 / spec.mass.value_or(type.mass);
                         },
                         +[](const double& value, Spec& spec) { spec.mass = 1.0 / value; }});
    visit(Column<ClassIndex>{"kind", &Balls::kind, always,
                             +[](BallId, const Spec& spec, const Kind&) { return spec.kind; },
                             +[](const ClassIndex& value, Spec& spec) { spec.kind = value; }});
    visit(Column<double>{"restitution", &Balls::restitution,
                         +[](const Model& model) { return model.inelastic; },
                         +[](BallId, const Spec& spec, const Kind& type) {
                             return spec.restitution.value_or(type.restitution);
                         },
                         +[](const double& value, Spec& spec) { spec.restitution = value; }});
    visit(Column<std::uint32_t>{"edge_contacts", &Balls::edge_contacts,
                                +[](const Model& model) { return model.scatter.has_value(); },
                                +[](BallId, const Spec&, const Kind&) { return std::uint32_t{}; }});
    visit(Column<double>{"spin", &Balls::spin,
                         +[](const Model& model) { return model.spin.has_value(); },
                         +[](BallId, const Spec& spec, const Kind&) { return spec.spin; },
                         +[](const double& value, Spec& spec) { spec.spin = value; }});
    visit(Column<Vec2>{
        "roll", &Balls::roll, +[](const Model& model) { return model.cloth.has_value(); },
        +[](BallId, const Spec& spec, const Kind&) { return spec.roll.value_or(spec.velocity); },
        +[](const Vec2& value, Spec& spec) { spec.roll = value; }});
}

template <typename Visit>
constexpr void Capsules::for_each_column(Visit&& visit) {
    visit(Column<CapsuleId>{"id", &Capsules::id});
    visit(Column<Capsule>{"shape", &Capsules::shape});
    visit(Column<ClassIndex>{"material", &Capsules::material});
    visit(Column<Side>{"side", &Capsules::side});
    visit(Column<Joints>{"joints", &Capsules::joints});
}

/// How many columns a table lists.
template <typename Table>
constexpr std::size_t count_columns() {
    std::size_t count = 0;
    Table::for_each_column([&](const auto&) { ++count; });
    return count;
}

// A vector that is a member, but in no list, would be lost wherever bodies are handled.
static_assert(sizeof(Balls) == count_columns<Balls>() * sizeof(std::vector<Vec2>));
static_assert(sizeof(Capsules) == count_columns<Capsules>() * sizeof(std::vector<Vec2>));

}  // namespace carom
