#include "physics/world/solver_memory.h"

#include <cstdint>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/world/fingerprint.h"

using namespace carom;

namespace {

void fill_contacts(ContactMemory& memory) {
    memory.contacts = {{.ball = BallId{5},
                        .other = 8,
                        .kind = ContactKind::ball_ball,
                        .across = -1,
                        .along = 1,
                        .impulse = 0.5,
                        .tangential_impulse = -0.25}};
}

World with_trajectories() {
    World world;
    EventMemory& memory = edit_event_memory(world);
    fill_contacts(memory);
    memory.trajectories.lines = {{.id = BallId{3},
                                  .recent_collisions = 7,
                                  .motion = Motion::turning,
                                  .time = 0.5,
                                  .position = {1.0, 2.0},
                                  .velocity = {3.0, -4.0}},
                                 {.id = BallId{5},
                                  .motion = Motion::resting,
                                  .time = 0.25,
                                  .position = {-1.0, 6.0},
                                  .velocity = {}}};
    memory.trajectories.curves = {{.acceleration = {0.0, -9.0},
                                   .center = {8.0, 1.5},
                                   .support = {SupportId::Kind::edge, -1, 1, 2},
                                   .second_support = {SupportId::Kind::ball, 0, -1, 9},
                                   .support_digest = 77},
                                  {.acceleration = {}, .center = {2.5, 0.0}}};
    memory.trajectories.spins = {{.time = 0.5, .spin = -2.0, .rate = 0.125, .rolls = true},
                                 {.spin = 6.0}};
    memory.trajectories.gravity = {0.0, -9.0};
    memory.trajectories.drag = 0.75;
    memory.clustered = {BallId{5}, BallId{8}};
    return world;
}

World with_reference_positions() {
    World world;
    ContactMemory& memory = edit_contact_memory(world);
    fill_contacts(memory);
    memory.reference = {
        .ball = {BallId{5}, BallId{6}}, .position = {{1.0, 2.0}, {3.0, 4.0}}, .skin = {0.5, 0.25}};
    return world;
}

}  // namespace

// The numbers are those of the carom that kept all this in lists of the world.
TEST_CASE("solver memory: fingerprints are what recordings were marked with") {
    World on_cloth = with_trajectories();
    on_cloth.edit_definition().model.cloth = Cloth{};
    struct Row {
        World world;
        std::uint64_t version_1;
        std::uint64_t version_2;
    };
    const std::vector<Row> rows{
        {World{}, 0x3e735917a86f0a98u, 0x6d2dc4f5b87c6b6bu},
        {with_trajectories(), 0x67abf799312707e6u, 0xc900bf1ca2906ee7u},
        {on_cloth, 0xf59b140661c57731u, 0xc900bf1ca2906ee7u},
        {with_reference_positions(), 0x3ca792a171ed0e54u, 0x6bb0903d7bf7c3e5u},
    };
    for (const Row& row : rows) {
        CHECK(fingerprint(row.world, 1) == row.version_1);
        CHECK(fingerprint(row.world, 2) == row.version_2);
        const World copied = row.world;
        CHECK(fingerprint(copied, 2) == row.version_2);
    }
}

TEST_CASE("solver memory: a copy has a memory of its own, and a world knows its size") {
    const World world = with_trajectories();
    World copied;
    copied = world;
    CHECK(event_memory(copied).trajectories == event_memory(world).trajectories);
    CHECK(bytes_of(copied) == bytes_of(world));
    edit_event_memory(copied).clustered.clear();
    CHECK(event_memory(world).clustered.size() == 2);
    CHECK(bytes_of(world) >= bytes_of(World{}) + sizeof(EventMemory) +
                                 2 * sizeof(StoredLinearPart) + 2 * sizeof(StoredCurvedPart) +
                                 2 * sizeof(StoredSpin));
    forget_trajectories(copied);
    CHECK(event_memory(copied).trajectories.lines.empty());
    CHECK(event_memory(copied).contacts.size() == 1);
}

TEST_CASE("solver memory: whoever uses a memory drops that of another solver") {
    World world = with_reference_positions();
    CHECK(event_memory(world).contacts.empty());
    edit_event_memory(world);
    CHECK(contact_memory(world).reference.ball.empty());
    // The memory of `event` is also one of `contact`, which moves its clusters.
    world = with_trajectories();
    CHECK(edit_contact_memory(world).contacts.size() == 1);
    CHECK(event_memory(world).clustered.size() == 2);
}

TEST_CASE("solver memory: each solver takes over what it can use and drops the rest") {
    World start = scenes::bucket(20, 0.5);
    EventMemory& left = edit_event_memory(start);
    left.clustered = {BallId{0}};
    left.trajectories.lines.resize(3);
    for (const SolverKind kind : solvers_available()) {
        CAPTURE(name(kind));
        World world = start;
        Solver({.kind = kind}).tick(world);
        CHECK((world.memory().find<EventMemory>() != nullptr) == (kind == SolverKind::event));
        CHECK(world.memory().is_empty() ==
              (kind != SolverKind::event && kind != SolverKind::contact));
    }
}
