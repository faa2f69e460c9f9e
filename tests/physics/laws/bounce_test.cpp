#include "physics/laws/bounce.h"

#include <doctest/doctest.h>

#include "physics/world/random.h"

using namespace carom;

namespace {

struct Spinning {
    Vec2 velocity;
    double spin = 0.0;
    double radius = 1.0;
    double inverse_mass = 1.0;

    double energy(double inertia) const {
        const double rim = spin * radius;
        return 0.5 * (length_squared(velocity) + inertia * rim * rim) / inverse_mass;
    }
    // About the contact point, `arm` away from the centre.
    double angular_momentum(Vec2 center, double inertia) const {
        return (cross(center, velocity) + inertia * radius * radius * spin) / inverse_mass;
    }
};

double slip(const Spinning& a, const Spinning& b, Vec2 normal) {
    return dot(a.velocity - b.velocity, perpendicular(normal)) - a.radius * a.spin -
           b.radius * b.spin;
}

double draw(double low, double high, std::uint64_t n) {
    return random_between(low, high, 5, RandomStream::level, 0, n);
}

Spinning drawn(std::uint64_t n) {
    return {.velocity = {draw(-9, 9, n), draw(-9, 9, n + 1)},
            .spin = draw(-20, 20, n + 2),
            .radius = draw(0.1, 4, n + 3),
            .inverse_mass = 1.0 / draw(0.1, 9, n + 4)};
}

}  // namespace

TEST_CASE(
    "friction between two balls gains no energy, and conserves momentum and angular momentum") {
    for (std::uint64_t n = 0; n < 20'000; n += 10) {
        Spinning a = drawn(n);
        Spinning b = drawn(n + 5);
        const double angle = draw(0, 2 * pi, n + 1);
        const auto [sine, cosine] = sin_cos(angle);
        const Vec2 normal{cosine, sine};
        const Friction friction{draw(0, 1, n + 2), draw(0.05, 1, n + 3)};
        const double pressed = draw(0, 20, n + 4);
        const double energy = a.energy(friction.inertia) + b.energy(friction.inertia);
        const Vec2 momentum = a.velocity / a.inverse_mass + b.velocity / b.inverse_mass;
        const auto turning = [&] {
            return a.angular_momentum(normal * a.radius, friction.inertia) +
                   b.angular_momentum(-normal * b.radius, friction.inertia);
        };
        const double angular = turning();
        const double before = slip(a, b, normal);

        const double impulse =
            apply_friction(a.velocity, {a.spin, a.radius}, a.inverse_mass, b.velocity,
                           {b.spin, b.radius}, b.inverse_mass, normal, pressed, friction);

        const double rounding = 1e-13 * (1.0 + energy);
        CHECK(a.energy(friction.inertia) + b.energy(friction.inertia) <= energy + rounding);
        const Vec2 after = a.velocity / a.inverse_mass + b.velocity / b.inverse_mass;
        CHECK(length(after - momentum) < 1e-12 * (1.0 + length(momentum)));
        CHECK(turning() == doctest::Approx(angular).epsilon(1e-11));
        // It sticks, or it still slips the same way under full friction.
        const double most = friction.coefficient * pressed;
        CHECK(std::fabs(impulse) <= most);
        const double left = slip(a, b, normal);
        if (std::fabs(impulse) < most)
            CHECK(std::fabs(left) < 1e-11 * (1.0 + std::fabs(before)));
        else
            CHECK(left * before >= -1e-11);
    }
}

TEST_CASE(
    "a ball thrown with spin onto a floor follows the closed forms for sticking and slipping") {
    // With c = I / (m r^2): v' = v - (v + r w) c / (1 + c) if it sticks, else v' = v - mu (1 + e)
    // v_n.
    const double inertia = 0.4;
    const double radius = 0.5;
    for (const double spin : {-30.0, -3.0, 0.0, 2.0, 40.0}) {
        for (const double mu : {0.0, 0.05, 0.3, 2.0}) {
            CAPTURE(spin);
            CAPTURE(mu);
            Spinning ball{{3.0, -4.0}, spin, radius, 1.0 / 2.0};
            const Exchange done = bounce_off(ball.velocity, ball.inverse_mass, {0, 1}, 0.0, 0.5);
            apply_friction_on_surface(ball.velocity, {ball.spin, radius}, ball.inverse_mass, {0, 1},
                                      {}, done.impulse, {mu, inertia});
            CHECK(ball.velocity.y == 2.0);
            // The contact point of the ball moves at v + r w.
            const double point = 3.0 + radius * spin;
            const double most = mu * (1.0 + 0.5) * 4.0;
            const double sticking = point * inertia / (1.0 + inertia);
            const double change = std::fabs(sticking) <= most ? -sticking
                                  : point > 0.0               ? -most
                                                              : most;
            CHECK(ball.velocity.x == doctest::Approx(3.0 + change));
            CHECK(ball.spin == doctest::Approx(spin + change / (inertia * radius)));
        }
    }
}

TEST_CASE("a kinematic surface drags a ball along, no faster than it moves") {
    Spinning ball{{0.0, 0.0}, 0.0, 1.0, 1.0};
    apply_friction_on_surface(ball.velocity, {ball.spin, 1.0}, 1.0, {0, 1}, {3.0, 7.0}, 100.0,
                              {1.0, 0.5});
    CHECK(ball.velocity.x == doctest::Approx(1.0));
    CHECK(ball.velocity.x + ball.spin == doctest::Approx(3.0));
    CHECK(ball.velocity.y == 0.0);
}

TEST_CASE("a ball that moves exactly along with a motorised surface is lifted off it") {
    Vec2 velocity{1.0, 2.0};
    const Exchange done = bounce_off(velocity, 0.5, {0, 1}, 2.0, 0.3, true);
    CHECK(velocity.x == 1.0);
    CHECK(velocity.y == doctest::Approx(2.0 + driven_lift * 2.0));
    CHECK(done.impulse == doctest::Approx(driven_lift * 2.0 / 0.5));
    CHECK(done.approach == 0.0);
    // A surface that stands, or moves away, leaves it alone.
    for (const double surface : {0.0, -2.0}) {
        Vec2 along{1.0, surface};
        bounce_off(along, 0.5, {0, 1}, surface, 0.3, true);
        CHECK(along == Vec2{1.0, surface});
    }
}
