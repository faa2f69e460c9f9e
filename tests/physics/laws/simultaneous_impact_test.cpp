#include "physics/laws/simultaneous_impact.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include "physics/world/random.h"

using namespace carom;

namespace {

using Body = ImpactBody<double>;
using Touch = ImpactContact<double>;

double draw(double low, double high, std::uint64_t who, std::uint64_t index) {
    return random_between(low, high, 271'828, RandomStream::level, who, index);
}

Vector<double> direction_of(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

struct Scene {
    std::vector<Body> bodies;
    std::vector<Touch> contacts;
};

// Bodies in a clump: every pair of neighbours touches, some touch fixed bodies.
Scene clump(std::uint64_t who, std::size_t count, double restitution, bool with_walls,
            double mass_range) {
    Scene scene;
    std::uint64_t n = 0;
    for (std::size_t i = 0; i < count; ++i)
        scene.bodies.push_back({{draw(-1, 1, who, n++), draw(-1, 1, who, n++)},
                                std::pow(10.0, draw(-mass_range, mass_range, who, n++))});
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t j = i + 1; j < count; ++j) {
            if (j > i + 1 && draw(0, 1, who, n++) < 0.6) continue;
            scene.contacts.push_back({.a = i,
                                      .b = j,
                                      .normal = direction_of(draw(-3.2, 3.2, who, n++)),
                                      .restitution = restitution});
        }
        if (with_walls && draw(0, 1, who, n++) < 0.5)
            scene.contacts.push_back({.a = i,
                                      .normal = direction_of(draw(-3.2, 3.2, who, n++)),
                                      .restitution = restitution});
    }
    std::erase_if(scene.contacts, [&](const Touch& contact) {
        return !(approach_of<double>(contact, scene.bodies) > 0.0);
    });
    return scene;
}

double energy(const std::vector<Body>& bodies) {
    double sum = 0.0;
    for (const Body& body : bodies)
        sum += length_squared(body.velocity) / body.inverse_mass / 2.0;
    return sum;
}

Vector<double> momentum(const std::vector<Body>& bodies) {
    Vector<double> sum;
    for (const Body& body : bodies)
        sum += body.velocity * (1.0 / body.inverse_mass);
    return sum;
}

double sum_of_momenta(const std::vector<Body>& bodies) {
    double sum = 0.0;
    for (const Body& body : bodies)
        sum += length(body.velocity) / body.inverse_mass;
    return sum;
}

}  // namespace

TEST_CASE("simultaneous impact: the momentum of movable bodies is conserved") {
    for (std::uint64_t who = 0; who < 500; ++who) {
        CAPTURE(who);
        Scene scene = clump(who, 2 + who % 9, draw(0, 1, who, 999), false, 2.0);
        const auto before = momentum(scene.bodies);
        const double size = sum_of_momenta(scene.bodies);
        reflect<double>(scene.bodies, scene.contacts);
        CHECK(length(momentum(scene.bodies) - before) < 1e-14 * size);
    }
}

TEST_CASE("simultaneous impact: with restitution 1 energy is conserved, with or without walls") {
    double worst = 0.0;
    for (std::uint64_t who = 0; who < 1000; ++who) {
        CAPTURE(who);
        Scene scene = clump(who, 2 + who % 9, 1.0, who % 2 == 0, 1.0);
        const double before = energy(scene.bodies);
        reflect<double>(scene.bodies, scene.contacts);
        worst = std::max(worst, std::fabs(energy(scene.bodies) / before - 1.0));
    }
    MESSAGE("energy of simultaneous impacts differs by at most ", worst);
    CHECK(worst < 1e-13);
}

TEST_CASE("simultaneous impact: with restitution below 1 energy is lost, never gained") {
    for (std::uint64_t who = 0; who < 1000; ++who) {
        CAPTURE(who);
        const double restitution = draw(0.0, 0.99, who, 999);
        Scene scene = clump(who, 2 + who % 9, restitution, who % 2 == 0, 2.0);
        if (scene.contacts.empty()) continue;
        const double before = energy(scene.bodies);
        reflect<double>(scene.bodies, scene.contacts);
        CHECK(energy(scene.bodies) < before);
    }
}

TEST_CASE("simultaneous impact: clumps with a high mass ratio gain no energy") {
    // Changing all violated contacts at once cycled here, and energy was gained.
    for (std::uint64_t who = 0; who < 2000; ++who) {
        CAPTURE(who);
        const double restitution = who % 4 == 0 ? 0.0 : draw(0.0, 0.99, who, 999);
        Scene scene = clump(who, 2 + who % 15, restitution, who % 2 == 0, 4.0);
        const double before = energy(scene.bodies);
        reflect<double>(scene.bodies, scene.contacts);
        CHECK(energy(scene.bodies) <= before * (1.0 + 1e-12));
    }
}

TEST_CASE(
    "simultaneous impact: impulses push, and afterwards nothing approaches as fast as before") {
    for (std::uint64_t who = 0; who < 1000; ++who) {
        CAPTURE(who);
        const double restitution = draw(0.0, 1.0, who, 999);
        Scene scene = clump(who, 2 + who % 9, restitution, who % 2 == 0, 1.0);
        std::vector<double> before;
        for (const Touch& contact : scene.contacts)
            before.push_back(approach_of<double>(contact, scene.bodies));
        const auto impulses = reflect<double>(scene.bodies, scene.contacts);
        REQUIRE(impulses.size() == scene.contacts.size());
        for (std::size_t i = 0; i < impulses.size(); ++i) {
            CHECK(impulses[i] >= 0.0);
            // For a single wall: a contact that approached at u separates at e u or faster. The
            // impulses stop every approach, so after 1 + e of them the velocity is at most -e u.
            const double after = approach_of<double>(scene.contacts[i], scene.bodies);
            CHECK(after <= -restitution * before[i] + 1e-11);
        }
    }
}

TEST_CASE("simultaneous impact: a single contact follows the textbook") {
    for (std::uint64_t who = 0; who < 200; ++who) {
        const double restitution = draw(0, 1, who, 0);
        const double a = draw(0.1, 3, who, 1);
        const double b = draw(0.1, 3, who, 2);
        const double u = draw(0.1, 2, who, 3);
        std::vector<Body> bodies{{{0.0, 1.0}, 1 / a}, {{u, 0.0}, 1 / b}};
        const std::vector<Touch> contacts{
            {.a = 0, .b = 1, .normal = {1.0, 0.0}, .restitution = restitution}};
        const auto impulses = reflect<double>(bodies, contacts);
        const double impulse = (1 + restitution) * a * b / (a + b) * u;
        CHECK(impulses[0] == doctest::Approx(impulse).epsilon(1e-14));
        CHECK(bodies[0].velocity.x == doctest::Approx(impulse / a).epsilon(1e-14));
        CHECK(bodies[0].velocity.y == 1.0);
        CHECK(bodies[1].velocity.x == doctest::Approx(u - impulse / b).epsilon(1e-13));
    }
}

TEST_CASE("simultaneous impact: a break is symmetric") {
    // A ball between two, as at the head of a rack: the two leave symmetrically.
    std::vector<Body> bodies{{{1.0, 0.0}, 1.0}, {{}, 1.0}, {{}, 1.0}};
    const double half = std::sqrt(0.75);
    const std::vector<Touch> contacts{{.a = 1, .b = 0, .normal = {half, 0.5}},
                                      {.a = 2, .b = 0, .normal = {half, -0.5}}};
    reflect<double>(bodies, contacts);
    CHECK(bodies[1].velocity.x == doctest::Approx(bodies[2].velocity.x).epsilon(1e-14));
    CHECK(bodies[1].velocity.y == doctest::Approx(-bodies[2].velocity.y).epsilon(1e-14));
    CHECK(std::fabs(bodies[0].velocity.y) < 1e-15);
    // The closed form from momentum and energy, with both leaving along their normals.
    const double v = 2.0 * half / (1.0 + 2.0 * half * half);
    CHECK(length(bodies[1].velocity) == doctest::Approx(v).epsilon(1e-13));
    CHECK(bodies[0].velocity.x == doctest::Approx(1.0 - 2.0 * half * v).epsilon(1e-13));
}

TEST_CASE("simultaneous impact: into a corner and out again") {
    for (std::uint64_t who = 0; who < 200; ++who) {
        const Vector<double> before{-draw(0.1, 1, who, 0), -draw(0.1, 1, who, 1)};
        std::vector<Body> bodies{{before, 1.0}};
        const std::vector<Touch> contacts{{.a = 0, .normal = {1.0, 0.0}},
                                          {.a = 0, .normal = {0.0, 1.0}}};
        reflect<double>(bodies, contacts);
        CHECK(length(bodies[0].velocity + before) < 1e-14);
    }
    // Two equal walls, as where two collinear edges meet, act as one.
    std::vector<Body> bodies{{{-1.0, 0.5}, 1.0}};
    const std::vector<Touch> contacts{{.a = 0, .normal = {1.0, 0.0}},
                                      {.a = 0, .normal = {1.0, 0.0}}};
    reflect<double>(bodies, contacts);
    CHECK(length(bodies[0].velocity - Vector<double>{1.0, 0.5}) < 1e-13);
    // A moving surface.
    bodies = {{{0.0, 0.0}, 1.0}};
    const std::vector<Touch> pushed{{.a = 0, .normal = {1.0, 0.0}, .surface = 2.0}};
    reflect<double>(bodies, pushed);
    CHECK(bodies[0].velocity.x == 4.0);
}

TEST_CASE("simultaneous impact: the order of bodies and of contacts does not matter") {
    double worst = 0.0;
    for (std::uint64_t who = 0; who < 500; ++who) {
        CAPTURE(who);
        const Scene scene = clump(who, 2 + who % 9, draw(0, 1, who, 999), who % 2 == 0, 1.0);
        const std::size_t count = scene.bodies.size();
        std::vector<std::uint32_t> place(count);
        std::iota(place.begin(), place.end(), 0u);
        for (std::size_t i = count; i > 1; --i)
            std::swap(
                place[i - 1],
                place[static_cast<std::size_t>(draw(0, static_cast<double>(i), who, 2000 + i))]);
        Scene other;
        other.bodies.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            other.bodies[place[i]] = scene.bodies[i];
        for (Touch contact : scene.contacts) {
            contact.a = place[contact.a];
            if (contact.b != Touch::fixed) {
                contact.b = place[contact.b];
                // With the bodies of the contact exchanged, too.
                if (contact.b < contact.a) {
                    std::swap(contact.a, contact.b);
                    contact.normal = -contact.normal;
                }
            }
            other.contacts.push_back(contact);
        }
        std::reverse(other.contacts.begin(), other.contacts.end());
        Scene straight = scene;
        reflect<double>(straight.bodies, straight.contacts);
        reflect<double>(other.bodies, other.contacts);
        for (std::size_t i = 0; i < count; ++i)
            worst = std::max(worst,
                             length(straight.bodies[i].velocity - other.bodies[place[i]].velocity));
    }
    MESSAGE("another order gives velocities that differ by at most ", worst);
    CHECK(worst < 1e-11);
}

TEST_CASE("simultaneous impact: a contact that does not approach never pulls") {
    // A ball that leaves a wall, alone and beside one that runs into another wall.
    const Body leaving{{1.0, 0.0}, 1.0};
    const Body arriving{{-2.0, 0.0}, 1.0};
    for (const double restitution : {0.0, 1.0}) {
        CAPTURE(restitution);
        const Touch first{.a = 0, .normal = {1.0, 0.0}, .restitution = restitution};
        const Touch second{.a = 1, .normal = {1.0, 0.0}, .restitution = restitution};
        std::vector<Body> bodies{leaving, arriving};
        const std::vector<Touch> contacts{first, second};
        const auto alone = reflect<double>(bodies, std::vector<Touch>{first});
        CHECK(alone[0] == 0.0);
        CHECK(bodies[0].velocity == leaving.velocity);
        const auto both = reflect<double>(bodies, contacts);
        CHECK(both[0] == 0.0);
        CHECK(bodies[0].velocity == leaving.velocity);
        CHECK(both[1] == 2.0 * (1.0 + restitution));
    }
}

TEST_CASE("simultaneous impact: 32 digits give the same result, more accurately") {
    for (std::uint64_t who = 0; who < 200; ++who) {
        CAPTURE(who);
        Scene scene = clump(who, 2 + who % 9, 1.0, who % 2 == 0, 1.0);
        std::vector<ImpactBody<DoubleDouble>> bodies;
        std::vector<ImpactContact<DoubleDouble>> contacts;
        for (const Body& body : scene.bodies)
            bodies.push_back({{DoubleDouble(body.velocity.x), DoubleDouble(body.velocity.y)},
                              DoubleDouble(body.inverse_mass)});
        for (const Touch& contact : scene.contacts) {
            const Vector<DoubleDouble> normal{DoubleDouble(contact.normal.x),
                                              DoubleDouble(contact.normal.y)};
            const DoubleDouble size = square_root(dot(normal, normal));
            contacts.push_back({.a = contact.a, .b = contact.b, .normal = normal / size});
        }
        const auto energy_of = [&] {
            DoubleDouble sum;
            for (const auto& body : bodies)
                sum += length_squared(body.velocity) / body.inverse_mass;
            return sum;
        };
        const DoubleDouble before = energy_of();
        reflect<DoubleDouble>(bodies, contacts);
        reflect<double>(scene.bodies, scene.contacts);
        CHECK(std::fabs(((energy_of() - before) / before).high) < 1e-27);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            CHECK(length(Vector<double>(Vec2(bodies[i].velocity)) - scene.bodies[i].velocity) <
                  1e-11);
    }
}
