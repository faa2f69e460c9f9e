#include "physics/contact/reference_positions.h"

#include <functional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "physics/contact/bodies.h"
#include "physics/contact/contact_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/world/fingerprint.h"

using namespace carom;

namespace {

// A heap at rest, and the solver that computed it.
struct Heap {
    World world = scenes::bucket(120, 0.0);
    Solver solver{{.kind = SolverKind::contact}};

    Heap() {
        world.edit_definition().model.inelastic = true;
        world.edit_definition().kinds.push_back(world.kinds()[0]);
        world.edit_definition().materials.push_back(world.materials()[0]);
        for (int i = 0; i < 900; ++i)
            solver.tick(world);
    }
};

// Fast enough to bounce, too slow to leave its fat AABB.
void shake(World& world) {
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        world.edit_balls().velocity[i] = {0.0, i % 3 == 0 ? -0.5 : 0.1};
}

}  // namespace

TEST_CASE("contact: a heap at rest reuses its pairs") {
    Heap heap;
    const ReferencePositions before = contact_memory(heap.world).reference;
    REQUIRE(before.ball == heap.world.balls().id);
    for (int i = 0; i < 50; ++i)
        heap.solver.tick(heap.world);
    CHECK(contact_memory(heap.world).reference == before);

    SUBCASE("until a ball leaves its fat AABB") {
        heap.world.edit_balls().velocity[7] = {0.0, 200.0};
        heap.solver.tick(heap.world);
        CHECK_FALSE(contact_memory(heap.world).reference == before);
    }
    SUBCASE("until a ball is removed") {
        remove_ball(heap.world, heap.world.balls().id[3]);
        heap.solver.tick(heap.world);
        CHECK(contact_memory(heap.world).reference.ball == heap.world.balls().id);
    }
    SUBCASE("until a ball is replaced by another in its place") {
        // The last one, so that all rows keep their places.
        const Vec2 place = heap.world.balls().position.back();
        const double radius = heap.world.balls().radius.back();
        remove_ball(heap.world, heap.world.balls().id.back());
        add_ball(heap.world, {.position = place, .radius = radius});
        heap.solver.tick(heap.world);
        CHECK(contact_memory(heap.world).reference.ball == heap.world.balls().id);
    }
    SUBCASE("until something is held") {
        const BallId held = heap.world.balls().id[3];
        heap.world.edit_held_balls() = {{held, heap.world.balls().position[3]}};
        heap.solver.tick(heap.world);
        CHECK_FALSE(contact_memory(heap.world).reference == before);
    }
    SUBCASE("until another solver takes over") {
        Solver swept({.kind = SolverKind::swept});
        swept.tick(heap.world);
        CHECK(contact_memory(heap.world).reference.ball.empty());
    }
}

// Data kept from tick to tick must equal what a fresh solver computes from the world, whatever
// changed in between.
TEST_CASE("contact: a changed heap continues as in a fresh solver") {
    struct Row {
        std::string what;
        std::function<void(World&)> change;
    };
    const std::vector<Row> rows{
        {"nothing", [](World&) {}},
        {"an edge moves", [](World& w) { w.edit_capsules().shape[0].start.y += 0.004; }},
        {"an edge comes",
         [](World& w) {
             add_capsule(w, {{4.0, 3.0}, {16.0, 4.0}, 0.2}, 0);
         }},
        {"an edge goes", [](World& w) { remove_capsule(w, w.capsules().id[0]); }},
        {"an edge of another material",
         [](World& w) {
             w.edit_definition().materials[1].restitution = 0.9;
             w.edit_capsules().material.assign(w.capsules().size(), 1);
             shake(w);
         }},
        {"a material bounces",
         [](World& w) {
             w.edit_definition().materials[0].restitution = 0.9;
             shake(w);
         }},
        {"balls bounce",
         [](World& w) {
             w.edit_balls().restitution.assign(w.balls().size(), 0.8);
             shake(w);
         }},
        {"balls rub",
         [](World& w) {
             w.edit_definition().model.spin = 0.5;
             w.edit_balls().spin.assign(w.balls().size(), 1.0);
             w.edit_definition().kinds[0].friction = 0.4;
         }},
        {"a ball is heavier", [](World& w) { w.edit_balls().inverse_mass[100] = 0.125; }},
        {"a ball is smaller", [](World& w) { w.edit_balls().radius[5] *= 0.99; }},
        {"a ball is elsewhere by a hair", [](World& w) { w.edit_balls().position[60].x += 1e-3; }},
        {"two balls change places",
         [](World& w) { std::swap(w.edit_balls().position[60], w.edit_balls().position[61]); }},
        {"a ball goes", [](World& w) { remove_ball(w, w.balls().id[11]); }},
        {"a ball goes and another comes",
         [](World& w) {
             const Vec2 place = w.balls().position[11];
             remove_ball(w, w.balls().id[11]);
             add_ball(w, {.position = place, .velocity = {}});
         }},
        {"a ball presses harder",
         [](World& w) { edit_contact_memory(w).contacts[20].impulse *= 1.5; }},
        {"nothing presses", [](World& w) { edit_contact_memory(w).contacts.clear(); }},
        {"other balls meet no more",
         [](World& w) {
             w.edit_definition().model.filtered = true;
             w.edit_definition().meets.assign(16, 1);
             w.edit_definition().meets[0 * 4 + 1] = w.edit_definition().meets[1 * 4 + 0] = 0;
             w.edit_balls().kind[80] = 1;
         }},
        {"gravity turns",
         [](World& w) {
             w.edit_definition().model.gravity = Vec2{1.0, -9.0};
         }},
        {"nobody has a home", [](World& w) { edit_contact_memory(w).reference.clear(); }},
    };
    const Heap heap;
    for (const Row& row : rows) {
        CAPTURE(row.what);
        World seen = heap.world;
        Solver solver({.kind = SolverKind::contact});
        solver.tick(seen);
        solver.tick(seen);
        row.change(seen);
        World unseen = seen;
        for (int i = 0; i < 20; ++i) {
            solver.tick(seen);
            Solver stranger({.kind = SolverKind::contact});
            stranger.tick(unseen);
            REQUIRE(fingerprint(seen) == fingerprint(unseen));
        }
    }
}

// Balls that leave their skins in the middle of a tick add pairs; the next tick must not show it.
TEST_CASE("contact: a heap on which balls fall continues as in a fresh solver") {
    Heap heap;
    World& seen = heap.world;
    for (int i = 0; i < 40; ++i)
        add_ball(seen, {.position = {0.7 * (i % 8) - 3.0, 40.0 + 2.5 * (i / 8)},
                        .velocity = {0.3 * (i % 5), -30.0 - i},
                        .radius = 0.5});
    World unseen = seen;
    int kept = 0;
    int renewed = 0;
    for (int i = 0; i < 240; ++i) {
        const ReferencePositions before = contact_memory(seen).reference;
        heap.solver.tick(seen);
        const ReferencePositions& after = contact_memory(seen).reference;
        if (after.order == before.order)
            for (std::size_t b = 0; b < after.position.size(); ++b)
                ++(after.position[b] == before.position[b] ? kept : renewed);
        Solver stranger({.kind = SolverKind::contact});
        stranger.tick(unseen);
        REQUIRE(fingerprint(seen) == fingerprint(unseen));
    }
    // A few balls leave their skins; the others keep their reference positions.
    CHECK(renewed > 1000);
    CHECK(kept > 2 * renewed);
}

TEST_CASE(
    "contact: fast balls have fat AABBs for a substep, a fast one among slow ones for a tick") {
    for (const bool is_crowd : {true, false}) {
        CAPTURE(is_crowd);
        World world = scenes::empty();
        world.edit_definition().rate = 60.0;
        world.edit_definition().model.gravity = Vec2{0.0, -10.0};
        for (int i = 0; i < 100; ++i)
            add_ball(world, {.position = {10.0 * (i % 10), 10.0 * (i / 10)},
                             .velocity = {is_crowd || i == 0 ? 90.0 : 0.0, 0.0},
                             .radius = 0.5});
        Solver solver({.kind = SolverKind::contact});
        solver.tick(world);
        // It moves 1.5 in a tick of four substeps.
        REQUIRE(contact_memory(world).reference.skin.size() == 100);
        if (is_crowd)
            CHECK(contact_memory(world).reference.skin[0] < 0.6);
        else
            CHECK(contact_memory(world).reference.skin[0] > 1.5);
    }
}

TEST_CASE("contact: the skin of a held ball covers its way to the target") {
    World world = scenes::empty();
    const BallId held = add_ball(world, {.position = {0.0, 0.0}, .radius = 0.5});
    add_ball(world, {.position = {0.0, 9.0}, .radius = 0.5});
    world.edit_held_balls().push_back({held, {5.0, 0.0}});
    set_reference_positions(world, skin_sizes(world, contact_substep(world, 4, false)));
    CHECK(contact_memory(world).reference.skin[0] > 5.0);
    CHECK(contact_memory(world).reference.skin[1] < 0.5);
}
