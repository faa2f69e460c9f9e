#include "lab/measure/independent.h"

#include <algorithm>

#include "geometry/double_double.h"
#include "lab/measure/oracle.h"

namespace carom {

// What the oracle asks of its numbers, found by argument-dependent look-up.
inline DoubleDouble sqrt_of(const DoubleDouble& x) {
    return square_root(x);
}
inline int sign_of(const DoubleDouble& x) {
    return x > DoubleDouble(0.0) ? 1 : x < DoubleDouble(0.0) ? -1 : 0;
}
inline double double_of(const DoubleDouble& x) {
    return x.high;
}

namespace {

constexpr std::uint64_t most_tests = 10'000'000;

bool is_known_to_the_oracle(const World& world) {
    const Model& m = world.model();
    if (m.drag || m.stop_speed || m.speed_limit || m.scatter || m.spin || m.cloth || m.modulus ||
        m.wrap || m.one_way || m.kicks || m.hinged || m.filtered || !m.ball_ball || !m.ball_edge)
        return false;
    if (!world.emitters().empty() || !world.zones().empty() || !world.flippers().empty() ||
        !world.movers().empty() || !world.held_balls().empty() || !world.held_capsules().empty())
        return false;
    return std::ranges::all_of(world.materials(),
                               [](const Material& material) { return material.soften == 0.0; });
}

std::string_view text_of(oracle::Stop stop) {
    return stop == oracle::Stop::work ? "it is too much work for it from there on"
                                      : "impacts at one instant are beyond it";
}

}  // namespace

IndependentCheck check_independently(const World& start, std::span<const double> times,
                                     std::span<const Positions> reference,
                                     const std::function<bool()>& go_on) {
    IndependentCheck check;
    if (!is_known_to_the_oracle(start)) {
        check.ended = "it knows only gravity, restitution and fixed edges";
        return check;
    }
    oracle::Oracle<DoubleDouble> oracle(start, most_tests);
    Positions positions{start.balls().id, start.balls().position};
    for (std::size_t i = 0; i < times.size(); ++i) {
        const oracle::Stop stop = oracle.run_until(times[i], times.back());
        if (stop != oracle::Stop::none) {
            check.ended = text_of(stop);
            return check;
        }
        for (std::size_t ball = 0; ball < positions.position.size(); ++ball) {
            const auto place = oracle.position(ball);
            positions.position[ball] = {double_of(place.x), double_of(place.y)};
        }
        check.differences.push_back(difference(reference[i], positions, std::nullopt).rms);
        if (!go_on()) return check;
    }
    return check;
}

}  // namespace carom
