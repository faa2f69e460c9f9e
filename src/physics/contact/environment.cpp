#include "physics/contact/environment.h"

#include <bit>

namespace carom {
namespace {

// All of a pair, stirred, so that a sum over pairs tells one set of them from another.
std::uint64_t stirred(const PressedPair& pair) {
    std::uint64_t bits =
        (std::uint64_t{number(pair.ball)} << 32 | pair.other) * 0x9e3779b97f4a7c15u;
    bits += static_cast<std::uint64_t>(pair.kind) << 16 |
            static_cast<std::uint64_t>(static_cast<std::uint8_t>(pair.across)) << 8 |
            static_cast<std::uint64_t>(static_cast<std::uint8_t>(pair.along));
    bits = (bits ^ std::bit_cast<std::uint64_t>(pair.impulse)) * 0xd6e8feb86659fd93u;
    bits ^= bits >> 32;
    bits = (bits ^ std::bit_cast<std::uint64_t>(pair.rub)) * 0xd6e8feb86659fd93u;
    return bits ^ bits >> 32;
}

std::uint64_t sum_of(const std::vector<PressedPair>& pairs) {
    std::uint64_t sum = 0;
    for (const PressedPair& pair : pairs)
        sum += stirred(pair);
    return sum;
}

}  // namespace

void ContactEnvironment::note(const World& world) {
    model_ = world.model();
    kinds_ = world.kinds();
    materials_ = world.materials();
    meets_ = world.meets();
    kind_ = world.balls().kind;
    restitution_ = world.balls().restitution;
    capsule_ = world.capsules().id;
    shape_ = world.capsules().shape;
    material_ = world.capsules().material;
}

void ContactEnvironment::note_impulses(const World& world) {
    pressed_ = world.memory().pressed.size();
    impulses_ = sum_of(world.memory().pressed);
}

bool ContactEnvironment::is_unchanged(const World& world) const {
    const Capsules& capsules = world.capsules();
    return model_ == world.model() && kinds_ == world.kinds() && materials_ == world.materials() &&
           meets_ == world.meets() && kind_ == world.balls().kind &&
           restitution_ == world.balls().restitution && capsule_ == capsules.id &&
           shape_ == capsules.shape && material_ == capsules.material &&
           pressed_ == world.memory().pressed.size() && impulses_ == sum_of(world.memory().pressed);
}

}  // namespace carom
