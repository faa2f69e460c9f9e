#include "physics/laws/hertz_impact.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "physics/world/random.h"

using namespace carom;

namespace {

using Body = ImpactBody<double>;
using Contact = HertzContact<double>;

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 314'159, RandomStream::level, who, index);
}

Contact between(std::uint32_t a, std::uint32_t b, Vector<double> normal, double restitution,
                double gap = 0.0, double stiffness = 1e9) {
    return {{a, b, normal, 0.0, restitution}, gap, stiffness};
}

double speed_of(std::span<const Body> bodies) {
    double most = 0.0;
    for (const Body& body : bodies)
        most = std::max(most, length(body.velocity));
    return most;
}

// The bodies after the impact.
std::vector<Body> after(std::vector<Body> bodies, const std::vector<Contact>& contacts) {
    HertzImpact<double> impact;
    for (const auto& touch : impact.press(bodies, contacts, speed_of(bodies)))
        push<double>(bodies, contacts[touch.contact].contact, touch.impulse);
    return bodies;
}

double energy_of(std::span<const Body> bodies) {
    double sum = 0.0;
    for (const Body& body : bodies)
        if (body.inverse_mass > 0.0)
            sum += length_squared(body.velocity) / (2.0 * body.inverse_mass);
    return sum;
}

Vector<double> momentum_of(std::span<const Body> bodies) {
    Vector<double> sum;
    for (const Body& body : bodies)
        sum += body.velocity / body.inverse_mass;
    return sum;
}

// A row of equal balls, the first of which arrives at speed 1.
std::vector<double> row(std::size_t count, double restitution, double gap = 0.0) {
    std::vector<Body> bodies(count, {{}, 1.0});
    bodies[0].velocity = {1.0, 0.0};
    std::vector<Contact> contacts;
    for (std::uint32_t i = 0; i + 1 < count; ++i)
        contacts.push_back(between(i + 1, i, {1.0, 0.0}, restitution, i == 0 ? 0.0 : gap));
    std::vector<double> speeds;
    for (const Body& body : after(bodies, contacts))
        speeds.push_back(body.velocity.x);
    return speeds;
}

}  // namespace

TEST_CASE("Hertz impact: two bodies alone part at the restitution times their approach") {
    for (const double restitution : {0.0, 0.3, 0.6, 0.95, 1.0})
        for (const double speed : {1e-3, 1.0, 50.0})
            for (const double mass : {1.0, 1e3}) {
                CAPTURE(restitution);
                CAPTURE(speed);
                CAPTURE(mass);
                const std::vector<Body> bodies{{{speed, 0.3}, 1.0}, {{}, 1.0 / mass}};
                const auto done = after(bodies, {between(1, 0, {1.0, 0.0}, restitution)});
                const double parting = done[1].velocity.x - done[0].velocity.x;
                // The depth at the turn is known to a step, of which a contact has 128.
                const double kept = parting / speed * (parting / speed);
                CHECK(std::abs(kept - restitution * restitution) < 2e-4);
                CHECK(done[0].velocity.y == 0.3);
            }
}

TEST_CASE("Hertz impact: its duration is that of the closed form") {
    // Love, Mathematical Theory of Elasticity, section 139: 2.94 times the depth over the speed.
    const double stiffness = 4e8;
    const double mass = 0.085;
    for (const double speed : {0.1, 1.0, 10.0}) {
        const double depth = std::pow(1.25 * mass * speed * speed / stiffness, 0.4);
        CHECK(hertz_duration(stiffness, mass, speed) ==
              doctest::Approx(2.9432750614 * depth / speed).epsilon(1e-10));
    }
    CHECK(hertz_stiffness(3.0, 2.0, 2.0) == doctest::Approx(2.0));
}

TEST_CASE("Hertz impact: momentum is kept to rounding, energy too where nothing is lost") {
    for (std::uint64_t who = 0; who < 60; ++who) {
        CAPTURE(who);
        const double restitution = who % 2 == 0 ? 1.0 : draw(0.0, 1.0, who, 1000);
        std::uint64_t n = 0;
        std::vector<Body> bodies;
        for (int i = 0; i < 7; ++i) {
            const double x = draw(-1, 1, who, n++);
            const double y = draw(-1, 1, who, n++);
            bodies.push_back({{x, y}, std::pow(10.0, draw(-1, 1, who, n++))});
        }
        std::vector<Contact> contacts;
        for (std::uint32_t i = 0; i < 7; ++i)
            for (std::uint32_t j = i + 1; j < 7; ++j) {
                if (draw(0, 1, who, n++) > 0.5) continue;
                const double angle = draw(0, 6.28, who, n++);
                const double gap = std::max(0.0, draw(-1e-5, 1e-5, who, n++));
                const double stiffness = std::pow(10.0, draw(8, 10, who, n++));
                contacts.push_back(
                    between(j, i, {std::cos(angle), std::sin(angle)}, restitution, gap, stiffness));
            }
        const auto done = after(bodies, contacts);
        const Vector<double> change = momentum_of(done) - momentum_of(bodies);
        CHECK(std::abs(change.x) < 1e-13);
        CHECK(std::abs(change.y) < 1e-13);
        const double gain = energy_of(done) / energy_of(bodies) - 1.0;
        CHECK(gain < 1e-14);
        if (restitution == 1.0) CHECK(gain > -1e-14);
        HertzImpact<double> impact;
        for (const auto& touch : impact.press(bodies, contacts, speed_of(bodies)))
            CHECK(touch.impulse >= 0.0);
    }
}

TEST_CASE("Hertz impact: a row of touching balls rocks, as a real cradle does") {
    // Hutzler, Delaney, Weaire and MacLeod, Rocking Newton's cradle, Am. J. Phys. 72 (2004) 1508:
    // the pulse is about five balls wide, so the first ball recoils, the last but one follows the
    // last, and all move on.
    // The figures are those of a Python script with steps of 1/2000 of a contact.
    const auto check = [](const std::vector<double>& row, const std::vector<double>& expected) {
        for (std::size_t i = 0; i < row.size(); ++i)
            CHECK(std::abs(row[i] - expected[i]) < 2e-4);
    };
    check(row(3, 1.0), {-0.07095, 0.07640, 0.99455});
    check(row(5, 1.0), {-0.07108, -0.03027, -0.01446, 0.12704, 0.98878});
}

TEST_CASE("Hertz impact: over wide gaps the impulse goes from ball to ball, as in textbooks") {
    // Much wider than the balls are pressed: each pair has parted before the next one meets, and
    // the impact ends with the first.
    const std::vector<double> apart = row(5, 0.9, 1.0);
    CHECK(apart[0] == doctest::Approx(0.05).epsilon(1e-3));
    CHECK(apart[1] == doctest::Approx(0.95).epsilon(1e-4));
    CHECK(apart[2] == 0.0);
    // With gaps of the depth of compression it is in between: the first ball recoils less.
    const double depth = 0.5 * hertz_duration(1e9, 0.5, 1.0) / 1.47;
    const double touching = row(5, 1.0)[0];
    const double near = row(5, 1.0, 0.3 * depth)[0];
    CHECK(near > touching);
    CHECK(near < 0.0);
}

TEST_CASE("Hertz impact: the order of bodies and contacts shows in rounding alone") {
    std::vector<Body> bodies{{{3.0, 0.1}, 1.0}, {{}, 1.0}, {{}, 1.0}, {{}, 0.5}};
    std::vector<Contact> contacts{between(1, 0, {1.0, 0.0}, 0.9),
                                  between(2, 1, {0.8, 0.6}, 0.9, 1e-5),
                                  between(3, 1, {0.8, -0.6}, 0.95, 2e-5)};
    const auto done = after(bodies, contacts);
    std::ranges::reverse(contacts);
    const auto again = after(bodies, contacts);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        CHECK(done[i].velocity.x == doctest::Approx(again[i].velocity.x).epsilon(1e-12));
        CHECK(done[i].velocity.y == doctest::Approx(again[i].velocity.y).epsilon(1e-12));
    }
}

TEST_CASE("Hertz impact: an immovable body gives nothing and takes nothing") {
    const std::vector<Body> bodies{{{2.0, 0.0}, 1.0}, {{}, 1.0}, {{}, 0.0}};
    const auto done =
        after(bodies, {between(1, 0, {1.0, 0.0}, 1.0), between(2, 1, {1.0, 0.0}, 1.0, 1e-5)});
    CHECK(done[2].velocity == Vector<double>{});
    CHECK(energy_of(done) == doctest::Approx(energy_of(bodies)).epsilon(1e-14));
    CHECK(done[0].velocity.x < 0.0);
}

TEST_CASE("Hertz impact: with more digits it is the same impact") {
    const std::vector<ImpactBody<DoubleDouble>> exact{{{DoubleDouble(1.0), {}}, DoubleDouble(1.0)},
                                                      {{}, DoubleDouble(1.0)},
                                                      {{}, DoubleDouble(1.0)}};
    std::vector<HertzContact<DoubleDouble>> contacts;
    for (std::uint32_t i = 0; i < 2; ++i)
        contacts.push_back(
            {{i + 1, i, {DoubleDouble(1.0), {}}, {}, DoubleDouble(0.9)}, {}, DoubleDouble(1e9)});
    HertzImpact<DoubleDouble> impact;
    auto bodies = exact;
    for (const auto& touch : impact.press(exact, contacts, DoubleDouble(1.0)))
        push<DoubleDouble>(bodies, contacts[touch.contact].contact, touch.impulse);
    const std::vector<double> plain = row(3, 0.9);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(static_cast<double>(bodies[i].velocity.x) ==
              doctest::Approx(plain[i]).epsilon(1e-11).scale(1.0));
}

// A ball of 1e-6 hardly approaches the ball that it touches; another one comes at it much faster.
// The steps were those of the slow contact, and the velocities grew without bound.
TEST_CASE("Hertz impact: a contact that joins may be much faster than the first") {
    const std::vector<Body> bodies{{{0.0, 0.0}, 6e4}, {{6e-11, 0.0}, 0.15}, {{-0.04, 0.0}, 0.15}};
    const std::vector<Contact> contacts{between(0, 1, {1.0, 0.0}, 0.9, 0.0, 9e9),
                                        between(2, 0, {1.0, 0.0}, 0.2, 9e-7, 1.2e10)};
    HertzImpact<double> impact;
    std::vector<Body> pressed = bodies;
    for (const auto& touch : impact.press(bodies, contacts, 6e-11))
        push<double>(pressed, contacts[touch.contact].contact, touch.impulse);
    CHECK(speed_of(pressed) < 100.0);
    CHECK(energy_of(pressed) <= energy_of(bodies) * (1.0 + 1e-12));
    CHECK(length(momentum_of(pressed) - momentum_of(bodies)) <= 1e-12);
}

TEST_CASE("Hertz impact: the speed that presses to a depth, also where its square is none") {
    for (const double depth : {1e-3, 1e-9, 1e-200}) {
        const double speed = hertz_speed(1e9, 0.3, depth);
        CHECK(speed > 0.0);
        if (depth > 1e-100)
            CHECK(hertz_duration(1e9, 0.3, speed) * speed / depth ==
                  doctest::Approx(2.94327506142).epsilon(1e-12));
    }
}

TEST_CASE("Hertz impact: what no step resolves is left to impacts that take no time") {
    for (const double light : {1.0, 1e-6, 1e-9, 1e-15}) {
        CAPTURE(light);
        const std::vector<Body> bodies{{{1.0, 0.0}, 1.0}, {{}, 1.0 / light}, {{}, 1.0}};
        const std::vector<Contact> contacts{between(1, 0, {1.0, 0.0}, 1.0),
                                            between(2, 1, {1.0, 0.0}, 1.0),
                                            between(2, 0, {1.0, 0.0}, 1.0, 1e-6)};
        HertzImpact<double> impact;
        const auto touches = impact.press(bodies, contacts, 1.0);
        CHECK(touches.empty() == (light < 1e-7));
        for (const auto& touch : touches)
            CHECK(touch.impulse < 10.0);
    }
}
