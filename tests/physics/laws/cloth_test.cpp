#include "physics/laws/cloth.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "physics/world/random.h"

using namespace carom;

namespace {

constexpr double ball = 0.4;  // inertia of a solid ball

double draw(double low, double high, std::uint64_t index) {
    return random_between(low, high, 4'711, RandomStream::level, 0, index);
}

Vector<double> draw_vector(double most, std::uint64_t index) {
    return {draw(-most, most, 2 * index), draw(-most, most, 2 * index + 1)};
}

// The law in small steps of mean velocities, so second order within a phase.
ClothState<double> integrated(const Cloth& cloth, double inertia, ClothState<double> state,
                              double duration, int steps) {
    const double step = duration / steps;
    for (int i = 0; i < steps; ++i) {
        const Vector<double> slip = state.velocity - state.roll;
        const double slipping = length(slip);
        const Vector<double> before = state.velocity;
        const double force = cloth.slide * cloth.gravity;
        const double stops = force * (1.0 + 1.0 / inertia) * step;
        if (slipping > stops) {
            state.velocity += slip * (-force * step / slipping);
            state.roll += slip * (force / inertia * step / slipping);
        } else {
            // It starts to roll within the step.
            state.velocity += slip * (-inertia / (1.0 + inertia));
            state.roll = state.velocity;
            const double speed = length(state.velocity);
            const double lost = cloth.roll * cloth.gravity * step;
            state.velocity =
                speed > lost ? state.velocity * (1.0 - lost / speed) : Vector<double>{};
            state.roll = state.velocity;
        }
        state.position += (before + state.velocity) * (0.5 * step);
    }
    return state;
}

}  // namespace

TEST_CASE("a stun ball slides 12 v^2 / (49 mu g), then rolls on at 5/7 of its speed") {
    for (std::uint64_t i = 0; i < 100; ++i) {
        CAPTURE(i);
        const Cloth cloth{.slide = draw(0.05, 0.5, 3 * i),
                          .roll = draw(0.001, 0.02, 3 * i + 1),
                          .gravity = draw(1.0, 20.0, 3 * i + 2)};
        const Vector<double> velocity = draw_vector(5.0, i);
        const double speed = length(velocity);
        const auto sliding = cloth_phase(cloth, ball, velocity, {});
        REQUIRE(sliding.motion == ClothMotion::sliding);
        const double force = cloth.slide * cloth.gravity;
        CHECK(*sliding.lasts == doctest::Approx(2.0 * speed / (7.0 * force)).epsilon(1e-14));
        const auto taken = cloth_state_after<double>(
            cloth, ball, {.position = {}, .velocity = velocity}, *sliding.lasts);
        CHECK(length(taken.position) ==
              doctest::Approx(12.0 * speed * speed / (49.0 * force)).epsilon(1e-14));
        CHECK(length(taken.velocity) == doctest::Approx(speed * 5.0 / 7.0).epsilon(1e-14));
        CHECK(taken.roll == taken.velocity);
        // Then it rolls v^2 / (2 roll g) further, and rests there.
        const auto end = cloth_state_after(cloth, ball, taken, 1e6);
        const double rolled = std::pow(speed * 5.0 / 7.0, 2) / (2.0 * cloth.roll * cloth.gravity);
        CHECK(length(end.position - taken.position) == doctest::Approx(rolled).epsilon(1e-12));
        CHECK(end.velocity == Vector<double>{});
        CHECK(end.roll == Vector<double>{});
    }
}

TEST_CASE("draw brings a ball back, follow drives it on") {
    const Cloth cloth;
    // At rest except for its spin, like a cue ball after a full hit: it ends up rolling at 2/7 of
    // it.
    for (const double roll : {-3.0, 3.0}) {
        const auto phase = cloth_phase<double>(cloth, ball, {}, {roll, 0.0});
        REQUIRE(phase.motion == ClothMotion::sliding);
        const auto taken = cloth_state_after<double>(
            cloth, ball, {.position = {}, .roll = {roll, 0.0}}, *phase.lasts);
        CHECK(taken.velocity.x == doctest::Approx(roll * 2.0 / 7.0).epsilon(1e-14));
        CHECK(taken.position.x * roll > 0.0);
    }
}

TEST_CASE("a ball on cloth follows the law in small steps") {
    double worst = 0.0;
    for (std::uint64_t i = 0; i < 60; ++i) {
        const double inertia = draw(0.2, 1.0, 100 + i);
        const Cloth cloth{.slide = draw(0.1, 0.4, 200 + i), .roll = draw(0.005, 0.02, 300 + i)};
        const ClothState<double> start{.position = draw_vector(1.0, 400 + i),
                                       .velocity = draw_vector(3.0, 500 + i),
                                       .roll = draw_vector(3.0, 600 + i)};
        const double duration = draw(0.1, 3.0, 700 + i);
        const auto exact = cloth_state_after(cloth, inertia, start, duration);
        const auto slow = integrated(cloth, inertia, start, duration, 100'000);
        worst = std::max({worst, length(exact.position - slow.position),
                          length(exact.velocity - slow.velocity), length(exact.roll - slow.roll)});
    }
    MESSAGE("worst difference to 100,000 small steps: " << worst);
    CHECK(worst < 2e-4);
}

TEST_CASE("time on cloth may be divided anywhere, and energy only falls") {
    const Cloth cloth;
    const auto energy = [](const ClothState<double>& s) {
        return length_squared(s.velocity) + ball * length_squared(s.roll);
    };
    for (std::uint64_t i = 0; i < 100; ++i) {
        ClothState<double> state{.velocity = draw_vector(3.0, 800 + i),
                                 .roll = draw_vector(3.0, 900 + i),
                                 .spin = draw(-50.0, 50.0, 1000 + i)};
        const auto whole = cloth_state_after(cloth, ball, state, 4.0);
        for (int piece = 0; piece < 400; ++piece) {
            const double before = energy(state);
            const double spin = std::abs(state.spin);
            state = cloth_state_after(cloth, ball, state, 0.01);
            CHECK(energy(state) <= before);
            CHECK(std::abs(state.spin) <= spin);
        }
        CHECK(length(state.position - whole.position) < 1e-11);
        CHECK(length(state.velocity - whole.velocity) < 1e-12);
        CHECK(std::abs(state.spin - whole.spin) < 1e-11);
    }
}

TEST_CASE("side spin decays on its own, at its own rate") {
    const Cloth cloth{.spin = 10.0};
    CHECK(cloth_spin_after(cloth, 30.0, 2.0) == 10.0);
    CHECK(cloth_spin_after(cloth, -30.0, 2.0) == -10.0);
    CHECK(cloth_spin_after(cloth, 30.0, 3.0) == 0.0);
    CHECK(cloth_spin_after(cloth, -30.0, 1e9) == 0.0);
    CHECK(cloth_spin_after(Cloth{.spin = 0.0}, 30.0, 1e9) == 30.0);
}

TEST_CASE("without rolling resistance a ball rolls for ever") {
    const auto phase = cloth_phase<double>(Cloth{.roll = 0.0}, ball, {1.0, 0.0}, {1.0, 0.0});
    CHECK(phase.motion == ClothMotion::rolling);
    CHECK_FALSE(phase.lasts);
    const auto far = cloth_state_after<double>(Cloth{.roll = 0.0}, ball,
                                               {.velocity = {1.0, 0.0}, .roll = {1.0, 0.0}}, 100.0);
    CHECK(far.position.x == 100.0);
}

TEST_CASE("a ball at rest on cloth stays at rest") {
    const auto phase = cloth_phase<double>(Cloth{}, ball, {}, {});
    CHECK(phase.motion == ClothMotion::still);
    CHECK_FALSE(phase.lasts);
}
