#include "physics/world/fingerprint.h"

#include <doctest/doctest.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "physics/event/motion/event_memory.h"
#include "physics/support/scenes.h"

using namespace carom;

namespace {

// A world in which every column, list and part of the solvers' memory is in use.
World sample() {
    World world = scenes::empty();
    Model& model = world.edit_definition().model;
    model.inelastic = model.one_way = model.curved = true;
    model.scatter = 0.1;
    model.spin = 0.4;
    model.cloth = Cloth{};
    world.edit_definition().kinds.push_back({.layer = 1});
    world.edit_definition().materials.push_back({});
    for (int i = 0; i < 3; ++i)
        add_ball(world, {.position = {9.0 * i, 1.0}});
    for (int i = 0; i < 2; ++i)
        add_capsule(world, {{0.0, -5.0 * i}, {9.0, -5.0 * i}, 0.5}, 0);
    world.edit_emitters().push_back({.count = 5});
    world.edit_flippers().push_back({.capsule = CapsuleId{0}});
    world.edit_held_balls().push_back({.id = BallId{0}});
    world.edit_held_capsules().push_back({.id = CapsuleId{1}});
    world.edit_hands().each = {{.number = 1}};
    world.edit_ledger().counters = {3};
    EventMemory& memory = edit_event_memory(world);
    memory.trajectories.lines.resize(2);
    memory.trajectories.curves.resize(2);
    memory.trajectories.spins.resize(2);
    memory.contacts.resize(2);
    memory.reference = {.ball = {BallId{0}}, .position = {{1.0, 2.0}}, .skin = {0.5}, .order = {0}};
    memory.clustered = {BallId{0}};
    return world;
}

void change(double& value) {
    value += 0.5;
}
void change(Vec2& value) {
    value.y += 0.5;
}
void change(BallId& value) {
    value = BallId{number(value) + 7};
}
void change(CapsuleId& value) {
    value = CapsuleId{number(value) + 7};
}
void change(ClassIndex& value) {
    value = 1;
}
void change(std::uint32_t& value) {
    ++value;
}
void change(Joints& value) {
    value[1] = CapsuleId{7};
}
void change(Capsule& value) {
    value.end.x += 0.5;
}
void change(Side& value) {
    value = Side::none;
}

struct Change {
    std::string what;
    std::function<void(World&)> make;
};

// One change for each thing that a tick or a command can change, except columns.
const std::vector<Change>& changes() {
    const auto memory = [](World& w) -> EventMemory& { return edit_event_memory(w); };
    static const std::vector<Change> all{
        {"tick", [](World& w) { ++w.edit_tick(); }},
        {"gravity", [](World& w) { w.edit_definition().model.gravity = Vec2{}; }},
        {"flipper", [](World& w) { w.edit_flippers()[0].is_pressed = true; }},
        {"flipper's progress", [](World& w) { w.edit_flippers()[0].progress = 0.5; }},
        {"emitter", [](World& w) { w.edit_emitters()[0].emitted = 1; }},
        {"counter", [](World& w) { w.edit_ledger().counters[0] = 4; }},
        {"target of a ball", [](World& w) { w.edit_held_balls()[0].target.x = 1.0; }},
        {"no held ball", [](World& w) { w.edit_held_balls().clear(); }},
        {"target of an edge", [](World& w) { w.edit_held_capsules()[0].end_target.x = 1.0; }},
        {"motor", [](World& w) { w.edit_held_capsules()[0].is_driven = true; }},
        {"pace of a hand", [](World& w) { w.edit_hands().each[0].pace = 1.0; }},
        {"last target of a hand", [](World& w) { w.edit_hands().each[0].end_target.x = 1.0; }},
        {"share of the hands", [](World& w) { w.edit_hands().share = 0.5; }},
        {"overlap before the hands", [](World& w) { w.edit_hands().overlap = 0.5; }},
        {"trajectory", [=](World& w) { memory(w).trajectories.lines[1].velocity.x = 1.0; }},
        {"trajectory's motion",
         [=](World& w) { memory(w).trajectories.lines[1].motion = Motion::resting; }},
        {"bend", [=](World& w) { memory(w).trajectories.curves[1].acceleration.x = 1.0; }},
        {"support", [=](World& w) { memory(w).trajectories.curves[1].second_support.number = 1; }},
        {"stored spin", [=](World& w) { memory(w).trajectories.spins[1].rate = 1.0; }},
        {"persistent contact", [=](World& w) { memory(w).contacts[1].impulse = 1.0; }},
        {"its image on a torus", [=](World& w) { memory(w).contacts[1].along = 1; }},
        {"reference position", [=](World& w) { memory(w).reference.position[0].x = 9.0; }},
        {"order of the solver's balls", [=](World& w) { memory(w).reference.order[0] = 1; }},
        {"cluster", [=](World& w) { memory(w).clustered.push_back(BallId{1}); }},
    };
    return all;
}

}  // namespace

TEST_CASE("every change of a world changes its fingerprint") {
    const World world = sample();
    std::set<std::uint64_t> seen{fingerprint(world)};
    CHECK(fingerprint(sample()) == fingerprint(world));
    for (const Change& each : changes()) {
        CAPTURE(each.what);
        World other = world;
        each.make(other);
        CHECK(seen.insert(fingerprint(other)).second);
    }
    Balls::for_each_column([&](const auto& column) {
        CAPTURE(column.name);
        World other = world;
        REQUIRE((other.balls().*column.values).size() == 3);
        change((other.edit_balls().*column.values)[1]);
        CHECK(seen.insert(fingerprint(other)).second);
    });
    Capsules::for_each_column([&](const auto& column) {
        CAPTURE(column.name);
        World other = world;
        REQUIRE((other.capsules().*column.values).size() == 2);
        change((other.edit_capsules().*column.values)[1]);
        CHECK(seen.insert(fingerprint(other)).second);
    });
}

TEST_CASE("a column that comes into use changes the fingerprint") {
    World plain = scenes::empty();
    add_ball(plain, {});
    World inelastic = plain;
    inelastic.edit_balls().restitution = {1.0};
    CHECK(fingerprint(inelastic) != fingerprint(plain));
}

TEST_CASE("stamps are not part of the fingerprint") {
    World world = sample();
    const std::uint64_t before = fingerprint(world);
    world.edit_balls();
    world.edit_capsules();
    world.edit_definition();
    CHECK(fingerprint(world) == before);
}
