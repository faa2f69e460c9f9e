#include "physics/world/fingerprint.h"

#include <bit>

#include <fmt/format.h>

namespace carom {
namespace {

// One round a word, each a bijection of the state, so that no word can be lost.
class Hash {
  public:
    void add(std::uint64_t word) {
        state_ = (state_ ^ word) * 0x9fb21c651e98df25u;
        state_ ^= state_ >> 32;
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(Vec2 v) {
        add(v.x);
        add(v.y);
    }
    void add(const Capsule& c) {
        add(c.start);
        add(c.end);
        add(c.radius);
    }
    std::uint64_t state() const { return state_; }

  private:
    std::uint64_t state_ = 0x243f6a8885a308d3u;
};

}  // namespace

std::uint64_t fingerprint(const World& world) {
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

std::string hexadecimal(std::uint64_t fingerprint) {
    return fmt::format("{:016x}", fingerprint);
}

}  // namespace carom
