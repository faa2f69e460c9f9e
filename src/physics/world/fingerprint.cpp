#include "physics/world/fingerprint.h"

#include <fmt/format.h>

#include <cassert>

#include "physics/world/hash.h"

namespace carom {
namespace {

// The columns that there were when version 2 was made: it has the length even of an empty one. A
// later column counts only where a scene uses it, so recordings from before it keep their marks.
constexpr std::size_t first_ball_columns = 10;
constexpr std::size_t first_capsule_columns = 4;

template <typename Table>
void add_columns(Hash& hash, const Table& table, std::size_t first_columns) {
    std::size_t number = 0;
    Table::for_each_column([&](const auto& column) {
        const auto& values = table.*column.values;
        if (number++ < first_columns || !values.empty()) hash.add(values);
    });
}

// Nothing while nothing is held: recordings from before hands keep their marks there.
void add_hands(Hash& hash, const Hands& hands) {
    if (hands.each.empty()) return;
    for (const Hand& hand : hands.each) {
        hash.add(hand.is_on_ball);
        hash.add(hand.number);
        hash.add(hand.start_target);
        hash.add(hand.end_target);
        hash.add(hand.pace);
    }
    hash.add(hands.share);
    hash.add(hands.overlap);
}

// Nothing without movers: recordings from before them keep their marks.
void add_movers(Hash& hash, const World& world) {
    for (const Mover& mover : world.movers()) {
        hash.add(mover.clock);
        hash.add(mover.share);
        hash.add(mover.runs);
    }
}

// Nothing without seesaws: recordings from before them keep their marks.
void add_seesaws(Hash& hash, const World& world) {
    for (const Seesaw& seesaw : world.seesaws()) {
        hash.add(seesaw.capsule);
        hash.add(seesaw.angle);
        hash.add(seesaw.rate);
    }
}

void add_kinematic_bodies(Hash& hash, const World& world) {
    for (const Flipper& flipper : world.flippers()) {
        hash.add(flipper.capsule);
        hash.add(flipper.progress);
        hash.add(flipper.rate);
        hash.add(flipper.is_pressed);
        if (flipper.is_stalled()) hash.add(flipper.stall);
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
    add_hands(hash, world.hands());
    add_movers(hash, world);
    add_seesaws(hash, world);
}

std::uint64_t fingerprint_2(const World& world) {
    Hash hash;
    hash.add(world.tick());
    hash.add(world.model().gravity);
    add_columns(hash, world.balls(), first_ball_columns);
    add_columns(hash, world.capsules(), first_capsule_columns);
    add_kinematic_bodies(hash, world);
    for (const Emitter& emitter : world.emitters())
        hash.add(emitter.emitted);
    hash.add(world.ledger().counters);
    world.memory().add_to(hash, world.model(), 2);
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
        if (flipper.is_stalled()) hash.add(static_cast<std::uint64_t>(flipper.stall));
    }
    for (const Emitter& emitter : world.emitters())
        hash.add(std::uint64_t{emitter.emitted});
    for (const std::uint64_t count : world.ledger().counters)
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
    world.memory().add_to(hash, world.model(), 1);
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
