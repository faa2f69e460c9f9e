#include "physics/world/fingerprint.h"

#include <fmt/format.h>

#include <cassert>

#include "physics/world/hash.h"

namespace carom {
namespace {

template <typename Table>
void add_columns(Hash& hash, const Table& table) {
    Table::for_each_column([&](const auto& column) { hash.add(table.*column.values); });
}

void add_kinematic_bodies(Hash& hash, const World& world) {
    for (const Flipper& flipper : world.flippers()) {
        hash.add(flipper.capsule);
        hash.add(flipper.progress);
        hash.add(flipper.rate);
        hash.add(flipper.is_pressed);
    }
    hash.add(std::uint64_t{world.held_balls().size()});
    for (const HeldBall& held : world.held_balls()) {
        hash.add(held.id);
        hash.add(held.target);
    }
    hash.add(std::uint64_t{world.held_capsules().size()});
    for (const HeldCapsule& held : world.held_capsules()) {
        hash.add(held.id);
        hash.add(held.start_target);
        hash.add(held.end_target);
        hash.add(held.is_driven);
    }
}

void add_support(Hash& hash, const PathSupport& support) {
    hash.add(support.by);
    hash.add(support.across);
    hash.add(support.along);
    hash.add(support.number);
}

void add_paths(Hash& hash, const SolverMemory& memory) {
    hash.add(std::uint64_t{memory.paths.size()});
    for (const BallPath& path : memory.paths) {
        hash.add(path.id);
        hash.add(path.quick);
        hash.add(path.motion);
        hash.add(path.time);
        hash.add(path.position);
        hash.add(path.velocity);
    }
    for (const PathBend& bend : memory.path_bends) {
        hash.add(bend.acceleration);
        hash.add(bend.center);
        add_support(hash, bend.support);
        add_support(hash, bend.second_support);
        hash.add(bend.carriers);
    }
    for (const SpinPath& path : memory.spin_paths) {
        hash.add(path.time);
        hash.add(path.spin);
        hash.add(path.rate);
        hash.add(path.rolls);
    }
    hash.add(memory.paths_gravity);
    hash.add(memory.paths_drag);
}

void add_memory(Hash& hash, const SolverMemory& memory) {
    add_paths(hash, memory);
    hash.add(std::uint64_t{memory.pressed.size()});
    for (const PressedPair& pair : memory.pressed) {
        hash.add(pair.ball);
        hash.add(pair.other);
        hash.add(pair.kind);
        hash.add(pair.across);
        hash.add(pair.along);
        hash.add(pair.impulse);
        hash.add(pair.rub);
    }
    hash.add(memory.homes.ball);
    hash.add(memory.homes.place);
    hash.add(memory.homes.margin);
    hash.add(memory.heaped);
}

std::uint64_t fingerprint_2(const World& world) {
    Hash hash;
    hash.add(world.tick());
    hash.add(world.model().gravity);
    add_columns(hash, world.balls());
    add_columns(hash, world.capsules());
    add_kinematic_bodies(hash, world);
    for (const Emitter& emitter : world.emitters())
        hash.add(emitter.emitted);
    hash.add(world.counters());
    add_memory(hash, world.memory());
    return hash.state();
}

// The order and the choice of what is added must never change: recordings were marked with it.
std::uint64_t fingerprint_1(const World& world) {
    Hash hash;
    hash.add(world.tick());
    if (world.model().gravity) hash.add(*world.model().gravity);
    const Balls& balls = world.balls();
    hash.add(std::uint64_t{balls.size()});
    for (std::size_t i = 0; i < balls.size(); ++i) {
        hash.add(std::uint64_t{number(balls.id[i])});
        hash.add(balls.position[i]);
        hash.add(balls.velocity[i]);
        hash.add(balls.radius[i]);
        hash.add(balls.inverse_mass[i]);
    }
    for (const std::uint32_t contacts : balls.edge_contacts)
        hash.add(std::uint64_t{contacts});
    for (const double spin : balls.spin)
        hash.add(spin);
    for (const Vec2 roll : balls.roll)
        hash.add(roll);
    hash.add(std::uint64_t{world.capsules().size()});
    for (std::size_t i = 0; i < world.capsules().size(); ++i) {
        hash.add(std::uint64_t{number(world.capsules().id[i])});
        hash.add(world.capsules().shape[i]);
    }
    for (const Flipper& flipper : world.flippers()) {
        hash.add(flipper.progress);
        hash.add(flipper.rate);
        hash.add(std::uint64_t{flipper.is_pressed});
    }
    for (const Emitter& emitter : world.emitters())
        hash.add(std::uint64_t{emitter.emitted});
    for (const std::uint64_t count : world.counters())
        hash.add(count);
    for (const HeldBall& held : world.held_balls()) {
        hash.add(std::uint64_t{number(held.id)});
        hash.add(held.target);
    }
    for (const HeldCapsule& held : world.held_capsules()) {
        hash.add(std::uint64_t{number(held.id)});
        hash.add(held.start_target);
        hash.add(held.end_target);
    }
    for (std::size_t i = 0; i < world.memory().paths.size(); ++i) {
        const BallPath& path = world.memory().paths[i];
        const PathBend bend =
            i < world.memory().path_bends.size() ? world.memory().path_bends[i] : PathBend{};
        hash.add(std::uint64_t{number(path.id)});
        hash.add(path.time);
        hash.add(path.position);
        hash.add(path.velocity);
        hash.add(bend.acceleration);
        hash.add(std::uint64_t{path.quick});
        hash.add(static_cast<std::uint64_t>(path.motion));
        if (world.model().cloth) hash.add(bend.center);
    }
    for (const SpinPath& path : world.memory().spin_paths) {
        hash.add(path.time);
        hash.add(path.spin);
        hash.add(path.rate);
        hash.add(std::uint64_t{path.rolls});
    }
    for (const PressedPair& pair : world.memory().pressed) {
        hash.add(std::uint64_t{number(pair.ball)});
        hash.add(std::uint64_t{pair.other});
        hash.add(static_cast<std::uint64_t>(pair.kind));
        hash.add(pair.impulse);
        hash.add(pair.rub);
    }
    for (std::size_t i = 0; i < world.memory().homes.ball.size(); ++i) {
        hash.add(std::uint64_t{number(world.memory().homes.ball[i])});
        hash.add(world.memory().homes.place[i]);
        hash.add(world.memory().homes.margin[i]);
    }
    for (const BallId id : world.memory().heaped)
        hash.add(std::uint64_t{number(id)});
    return hash.state();
}

}  // namespace

std::uint64_t fingerprint(const World& world, int version) {
    assert(version >= 1 && version <= fingerprint_version);
    return version == 1 ? fingerprint_1(world) : fingerprint_2(world);
}

std::string hexadecimal(std::uint64_t fingerprint) {
    return fmt::format("{:016x}", fingerprint);
}

}  // namespace carom
