#include "physics/world/columns.h"

#include <doctest/doctest.h>

#include "physics/event/motion/event_memory.h"
#include "physics/solver.h"
#include "physics/support/scenes.h"
#include "physics/tick/emitters_and_sinks.h"
#include "physics/tick/undo.h"
#include "physics/world/world.h"

using namespace carom;

namespace {

// The entry of a column in row `row`: different in each row, never the default.
void set(BallId& value, std::uint32_t row) {
    value = BallId{10 * row + 3};
}
void set(CapsuleId& value, std::uint32_t row) {
    value = CapsuleId{10 * row + 3};
}
void set(Vec2& value, std::uint32_t row) {
    value = {row + 0.25, row + 0.5};
}
void set(double& value, std::uint32_t row) {
    value = row + 0.125;
}
void set(ClassIndex& value, std::uint32_t row) {
    value = static_cast<ClassIndex>(row + 1);
}
void set(std::uint32_t& value, std::uint32_t row) {
    value = row + 7;
}
void set(Joints& value, std::uint32_t row) {
    value = {CapsuleId{2 * row}, CapsuleId{2 * row + 1}};
}
void set(Side& value, std::uint32_t row) {
    value = static_cast<Side>(1 + row % 3);
}
void set(Capsule& value, std::uint32_t row) {
    value = {{row + 1.0, 0.0}, {0.0, row + 2.0}, 0.5};
}

// A table with `rows` rows in which every column is in use.
template <typename Table>
Table filled(std::uint32_t rows) {
    Table table;
    Table::for_each_column([&](const auto& column) {
        auto& values = table.*column.values;
        values.resize(rows);
        for (std::uint32_t row = 0; row < rows; ++row)
            set(values[row], row);
    });
    return table;
}

// Checks that the rows of `part` are the rows `rows` of `whole`, in every column.
template <typename Table>
void check_rows(const Table& part, const Table& whole, const std::vector<std::uint32_t>& rows) {
    Table::for_each_column([&](const auto& column) {
        CAPTURE(column.name);
        const auto& some = part.*column.values;
        const auto& all = whole.*column.values;
        REQUIRE(some.size() == rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            CHECK(some[i] == all[rows[i]]);
    });
}

// A world of three balls in which every column is in use, far apart, with a sink around one.
World full() {
    World world = scenes::empty();
    world.edit_definition().model.inelastic = true;
    world.edit_definition().model.scatter = 0.1;
    world.edit_definition().model.spin = 0.4;
    world.edit_definition().model.cloth = Cloth{};
    for (int i = 0; i < 3; ++i)
        add_ball(world, {.position = {9.0 * i, 1.0}});
    const std::vector<BallId> ids = world.balls().id;
    world.edit_balls() = filled<Balls>(3);
    world.edit_balls().id = ids;
    world.edit_balls().kind.assign(3, 0);
    for (std::uint32_t i = 0; i < 3; ++i)
        world.edit_balls().position[i] = {9.0 * i, 1.0};
    return world;
}

}  // namespace

TEST_CASE_TEMPLATE("every column goes through each operation on rows", Table, Balls, Capsules) {
    const Table whole = filled<Table>(5);
    Table table = whole;
    erase_row(table, 1);
    check_rows(table, whole, {0, 2, 3, 4});

    table = whole;
    erase_rows(table, std::vector<std::uint8_t>{1, 0, 0, 1, 0});
    check_rows(table, whole, {1, 2, 4});

    Table part = filled<Table>(9);
    const std::vector<std::uint32_t> rows{4, 0, 2};
    copy_rows(whole, rows, part);
    check_rows(part, whole, {4, 0, 2});

    const Table other = filled<Table>(9);
    copy_rows(other, std::vector<std::uint32_t>{6, 7, 8}, part);
    table = whole;
    write_rows(part, rows, table);
    check_rows(table, other, {7, 1, 8, 3, 6});
}

TEST_CASE("unused columns stay empty through each operation on rows") {
    Balls balls = filled<Balls>(3);
    balls.spin.clear();
    Balls part;
    copy_rows(balls, std::vector<std::uint32_t>{2, 1}, part);
    CHECK(part.spin.empty());
    write_rows(part, std::vector<std::uint32_t>{0, 1}, balls);
    erase_row(balls, 0);
    erase_rows(balls, std::vector<std::uint8_t>{1, 0});
    CHECK(balls.spin.empty());
    CHECK(balls.size() == 1);
}

TEST_CASE("the size of a table is the sum of all its columns") {
    const Balls balls = filled<Balls>(4);
    CHECK(bytes_in_columns(balls) == 4 * (4 + 16 + 16 + 8 + 8 + 2 + 8 + 4 + 8 + 16));
}

TEST_CASE("a new ball has an entry in every column that its scene uses, and in no other") {
    World world = full();
    add_ball(world, {.position = {30.0, 1.0}, .spin = 2.0, .roll = Vec2{1.0, 2.0}});
    Balls::for_each_column([&](const auto& column) {
        CAPTURE(column.name);
        CHECK((world.balls().*column.values).size() == 4);
    });
    World plain = scenes::empty();
    add_ball(plain, {});
    Balls::for_each_column([&](const auto& column) {
        CAPTURE(column.name);
        CHECK((plain.balls().*column.values).size() == (column.is_used(plain.model()) ? 1 : 0));
    });
}

TEST_CASE("a ball made from the spec of another is like it in every column but id and contacts") {
    World world = full();
    world.edit_balls().inverse_mass[2] = 0.25;
    const std::size_t last = world.balls().size() - 1;
    add_ball(world, spec_of(world, last));
    Balls::for_each_column([&](const auto& column) {
        if (column.name == "id" || column.name == "edge_contacts") return;
        CAPTURE(column.name);
        const auto& values = world.balls().*column.values;
        CHECK(values[last + 1] == values[last]);
    });
}

TEST_CASE("a ball made from the spec of another at rest has neither speed, spin nor roll") {
    World world = full();
    const BallId added = add_ball(world, spec_at_rest(world, 0, {40.0, 41.0}));
    const std::size_t i = *index_of(world, added);
    CHECK(world.balls().position[i] == Vec2{40.0, 41.0});
    CHECK(world.balls().velocity[i] == Vec2{});
    CHECK(world.balls().spin[i] == 0.0);
    CHECK(world.balls().roll[i] == Vec2{});
    CHECK(world.balls().radius[i] == world.balls().radius[0]);
    CHECK(world.balls().restitution[i] == world.balls().restitution[0]);
}

TEST_CASE("removing a ball, by a player or in a sink, keeps every column of the others") {
    const World start = full();
    World world = start;
    remove_ball(world, BallId{1});
    check_rows(world.balls(), start.balls(), {0, 2});

    world = start;
    world.edit_ledger().counters = {0};
    world.edit_definition().zones.push_back(
        {.shape = {{0.0, 1.0}, {0.0, 1.0}, 1.0}, .effect = Zone::Effect::sink});
    SinkDrain().drain(world);
    check_rows(world.balls(), start.balls(), {1, 2});
}

TEST_CASE("undoing a tick restores every column") {
    const World start = full();
    World world = start;
    TickUndo undo;
    undo.note(world);
    world.edit_balls() = filled<Balls>(7);
    undo.take_back(world);
    check_rows(world.balls(), start.balls(), {0, 1, 2});
}

TEST_CASE("a hybrid step moves every column of a ball there and back") {
    World start = full();
    start.edit_definition().model.gravity = Vec2{0.0, -1.0};
    start.edit_definition().rate = 240.0;
    start.edit_balls().radius.assign(3, 1.0);
    start.edit_balls().edge_contacts = {5, 6, 7};
    start.edit_balls().position = {{0.0, 0.0}, {1.9, 0.0}, {50.0, 0.0}};
    World world = start;
    edit_event_memory(world).clustered = {BallId{0}};
    REQUIRE(Solver({.kind = SolverKind::event}).tick(world) == TickOutcome::done);
    // Each part moves as it would alone.
    World cluster = start;
    remove_ball(cluster, BallId{2});
    edit_event_memory(cluster).clustered = {BallId{0}};
    Solver({.kind = SolverKind::event}).tick(cluster);
    World free = start;
    remove_ball(free, BallId{0});
    remove_ball(free, BallId{1});
    Solver({.kind = SolverKind::event}).tick(free);
    Balls::for_each_column([&](const auto& column) {
        CAPTURE(column.name);
        const auto& values = world.balls().*column.values;
        REQUIRE(values.size() == 3);
        CHECK(values[0] == (cluster.balls().*column.values)[0]);
        CHECK(values[1] == (cluster.balls().*column.values)[1]);
        CHECK(values[2] == (free.balls().*column.values)[0]);
    });
    CHECK_FALSE(world.balls().velocity[2] == start.balls().velocity[2]);
}
