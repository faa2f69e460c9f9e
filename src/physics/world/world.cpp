#include "physics/world/world.h"

#include <algorithm>
#include <cassert>

#include "geometry/closest.h"
#include "physics/world/columns.h"

namespace carom {
namespace {

template <typename Id>
std::optional<std::size_t> find(const std::vector<Id>& ids, Id id) {
    const auto found = std::lower_bound(ids.begin(), ids.end(), id);
    if (found == ids.end() || *found != id) return std::nullopt;
    return static_cast<std::size_t>(found - ids.begin());
}

template <typename Vector>
std::size_t bytes_in(const Vector& values) {
    return values.capacity() * sizeof(values[0]);
}

std::size_t bytes_of_edges(const std::vector<Mover>& movers) {
    std::size_t bytes = 0;
    for (const Mover& mover : movers)
        bytes += bytes_in(mover.edges) + bytes_in(mover.path);
    return bytes;
}

// In a list in ascending order of id: the entry with this id, or else where it would be.
template <typename List, typename Id>
auto place_of(List& list, Id id) {
    return std::ranges::lower_bound(list, id, {}, [](const auto& held) { return held.id; });
}

template <typename Held, typename Id>
const Held* find_held(const std::vector<Held>& list, Id id) {
    const auto place = place_of(list, id);
    return place != list.end() && place->id == id ? &*place : nullptr;
}

template <typename Held>
void put_held(std::vector<Held>& list, const Held& held) {
    const auto place = place_of(list, held.id);
    if (place != list.end() && place->id == held.id)
        *place = held;
    else
        list.insert(place, held);
}

void become_rough(World& world) {
    if (!world.model().rough) world.edit_definition().model.rough = true;
}

void become_one_way(World& world) {
    if (world.model().one_way) return;
    world.edit_definition().model.one_way = true;
    world.edit_capsules().side.assign(world.capsules().size(), Side::both);
}

}  // namespace

void become_inelastic(World& world) {
    if (world.model().inelastic) return;
    world.edit_definition().model.inelastic = true;
    // Until now every ball was elastic, whatever its kind says.
    world.edit_balls().restitution.assign(world.balls().size(), 1.0);
}

World::World() = default;
World::World(const World& other) = default;
World::World(World&& other) noexcept = default;
World& World::operator=(const World& other) = default;
World& World::operator=(World&& other) noexcept = default;
World::~World() = default;

Definition& World::edit_definition() {
    stamps_.definition = new_stamp();
    return definition_;
}

Balls& World::edit_balls() {
    stamps_.roster = stamps_.motion = new_stamp();
    return balls_;
}

Capsules& World::edit_capsules() {
    stamps_.capsules = new_stamp();
    return capsules_;
}

std::vector<HeldBall>& World::edit_held_balls() {
    stamps_.held = new_stamp();
    return held_balls_;
}

std::vector<HeldCapsule>& World::edit_held_capsules() {
    stamps_.held = new_stamp();
    return held_capsules_;
}

SolverMemory& World::edit_memory() {
    stamps_.memory = new_stamp();
    return memory_;
}

std::size_t bytes_of(const World& world) {
    const Definition& definition = world.definition();
    return sizeof(World) + bytes_in_columns(world.balls()) + bytes_in_columns(world.capsules()) +
           bytes_in(definition.kinds) + bytes_in(definition.materials) +
           bytes_in(definition.meets) + bytes_in(definition.zones) + bytes_in(world.emitters()) +
           bytes_in(world.flippers()) + bytes_in(world.movers()) + bytes_of_edges(world.movers()) +
           bytes_in(world.seesaws()) + bytes_in(world.held_balls()) +
           bytes_in(world.held_capsules()) + bytes_in(world.hands().each) +
           bytes_in(world.ledger().counters) + bytes_in(world.ledger().removed) +
           world.memory().bytes();
}

BallId add_ball(World& world, const BallSpec& spec) {
    const Kind& kind = world.kinds()[spec.kind];
    assert(spec.mass.value_or(kind.mass) > 0.0);
    if (spec.restitution.value_or(kind.restitution) < 1.0) become_inelastic(world);
    if (kind.friction > 0.0) become_rough(world);
    const BallId id = world.edit_ids().take_ball();
    Balls& balls = world.edit_balls();
    Balls::for_each_column([&](const auto& column) {
        if (column.is_used(world.model()))
            (balls.*column.values).push_back(column.of_new(id, spec, kind));
    });
    return id;
}

BallSpec spec_of(const World& world, std::size_t index) {
    BallSpec spec;
    Balls::for_each_column([&](const auto& column) {
        const auto& values = world.balls().*column.values;
        if (column.to_spec && !values.empty()) column.to_spec(values[index], spec);
    });
    return spec;
}

BallSpec spec_at_rest(const World& world, std::size_t index, Vec2 position) {
    BallSpec spec = spec_of(world, index);
    spec.position = position;
    spec.velocity = {};
    spec.spin = 0.0;
    spec.roll.reset();
    return spec;
}

CapsuleId add_capsule(World& world, const Capsule& shape, ClassIndex material, Side side) {
    const Material& made_of = world.materials()[material];
    if (made_of.restitution < 1.0 || made_of.soften > 0.0) become_inelastic(world);
    if (made_of.friction > 0.0) become_rough(world);
    if (made_of.kick > 0.0) world.edit_definition().model.kicks = true;
    if (side != Side::both) become_one_way(world);
    const CapsuleId id = world.edit_ids().take_capsule();
    Capsules& capsules = world.edit_capsules();
    capsules.id.push_back(id);
    capsules.shape.push_back(shape);
    capsules.material.push_back(material);
    if (world.model().one_way) capsules.side.push_back(side);
    if (world.model().curved) capsules.joints.push_back({no_joint, no_joint});
    return id;
}

std::optional<std::size_t> index_of(const World& world, BallId id) {
    return find(world.balls().id, id);
}

std::optional<std::size_t> index_of(const World& world, CapsuleId id) {
    return find(world.capsules().id, id);
}

const HeldBall* held_of(const World& world, BallId id) {
    return find_held(world.held_balls(), id);
}

const HeldCapsule* held_of(const World& world, CapsuleId id) {
    return find_held(world.held_capsules(), id);
}

void hold(World& world, const HeldBall& held) {
    put_held(world.edit_held_balls(), held);
}

void hold(World& world, const HeldCapsule& held) {
    put_held(world.edit_held_capsules(), held);
}

void set_side(World& world, CapsuleId id, Side side) {
    const auto index = index_of(world, id);
    if (!index) return;
    if (side != Side::both) become_one_way(world);
    if (world.model().one_way) world.edit_capsules().side[*index] = side;
}

void set_joints(World& world, CapsuleId id, const Joints& joints) {
    const auto index = index_of(world, id);
    if (!index) return;
    if (!world.model().curved) {
        world.edit_definition().model.curved = true;
        world.edit_capsules().joints.assign(world.capsules().size(), {no_joint, no_joint});
    }
    world.edit_capsules().joints[*index] = joints;
}

std::size_t kinds_of_a_layer(const World& world) {
    return static_cast<std::size_t>(std::ranges::count(world.kinds(), 0, &Kind::layer));
}

void set_layer(World& world, BallId id, std::uint8_t layer) {
    const auto index = index_of(world, id);
    if (!index) return;
    const std::size_t kinds = kinds_of_a_layer(world);
    const ClassIndex kind = world.balls().kind[*index];
    const std::size_t there = kind % kinds + layer * kinds;
    if (there == kind || there >= world.kinds().size()) return;
    world.edit_balls().kind[*index] = static_cast<ClassIndex>(there);
    // The ball no longer meets what its trajectory was to meet.
    forget_trajectories(world);
}

void forget_trajectories(World& world) {
    if (!world.memory().is_empty()) world.edit_memory().forget_trajectories();
}

void remove_ball(World& world, BallId id) {
    const auto index = index_of(world, id);
    if (!index) return;
    erase_row(world.edit_balls(), *index);
    std::erase_if(world.edit_held_balls(), [id](const HeldBall& held) { return held.id == id; });
    world.edit_ledger().removed.push_back({.id = id, .zone = -1, .tick = world.tick()});
}

void remove_capsule(World& world, CapsuleId id) {
    const auto index = index_of(world, id);
    if (!index) return;
    erase_row(world.edit_capsules(), *index);
    std::erase_if(world.edit_held_capsules(),
                  [id](const HeldCapsule& held) { return held.id == id; });
    std::erase_if(world.edit_flippers(),
                  [id](const Flipper& flipper) { return flipper.capsule == id; });
    for (Mover& mover : world.edit_movers())
        std::erase_if(mover.edges, [id](const MovedEdge& edge) { return edge.capsule == id; });
    std::erase_if(world.edit_seesaws(),
                  [id](const Seesaw& seesaw) { return seesaw.capsule == id; });
}

std::vector<std::uint64_t> census(const World& world) {
    std::vector<std::uint64_t> counts = world.ledger().counters;
    for (const Zone& zone : world.zones()) {
        if (zone.effect != Zone::Effect::census) continue;
        for (const Vec2 position : world.balls().position)
            if (is_inside(zone.shape, position)) ++counts[zone.counter];
    }
    return counts;
}

bool kinds_meet(const World& world, ClassIndex a, ClassIndex b) {
    if (!world.model().filtered) return true;
    const std::size_t classes = world.kinds().size() + world.materials().size();
    return world.definition().meets[a * classes + b] != 0;
}

bool kind_meets_material(const World& world, ClassIndex kind, ClassIndex material) {
    if (!world.model().filtered) return true;
    const std::size_t classes = world.kinds().size() + world.materials().size();
    return world.definition().meets[kind * classes + world.kinds().size() + material] != 0;
}

}  // namespace carom
