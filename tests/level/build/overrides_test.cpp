#include "level/build/overrides.h"

#include <doctest/doctest.h>

#include "level/support/files.h"

using namespace carom;
using namespace carom::test;

namespace {

LoadResult with(std::string_view lines, std::vector<std::string> overrides) {
    LoadOptions options;
    options.overrides = std::move(overrides);
    return load_lines(lines, options);
}

}  // namespace

TEST_CASE("--set replaces the statement of the same kind") {
    const LoadResult result = with(
        "use gravity 0,-9.81\nuse drag 1\nlet n=3\nrate 60\nkind bead r=2\nworld 0,0 9,9\n"
        "repeat n step=5,0\n ball a kind=bead at=2,2\nend\n",
        {"use gravity 0,-1.6", "let n=2", "rate 240", "kind bead r=1", "world 0,0 50,50",
         "solver swept substeps=4", "seed 4", "use limit 3"});
    CHECK(rendered(result) == "");
    REQUIRE(result.scene);
    const World& world = result.scene->world;
    CHECK(world.model().gravity == Vec2{0, -1.6});
    CHECK(world.model().drag == 1.0);
    CHECK(world.model().speed_limit == 3.0);
    CHECK(world.balls().size() == 2);
    CHECK(world.balls().radius[0] == 1.0);
    CHECK(world.rate() == 240.0);
    CHECK(world.seed() == 4);
    CHECK(result.scene->solver == SolverSettings{SolverKind::swept, 4, 15, 4});
    CHECK(result.scene->view.high == Vec2{50, 50});
    CHECK(result.scene->overridden);
}

TEST_CASE("--set sees the lets above the statement that it replaces") {
    const LoadResult result = with("let g=5\nuse gravity 0,-g\n", {"use gravity 0,-2*g"});
    REQUIRE(result.scene);
    CHECK(result.scene->world.model().gravity == Vec2{0, -10});
}

TEST_CASE("--set to 0 turns a term off") {
    const LoadResult result = with("use drag 3\n", {"use drag 0"});
    REQUIRE(result.scene);
    CHECK_FALSE(result.scene->world.model().drag);
}

TEST_CASE("diagnostics name --set as their source") {
    CHECK(rendered(with("let width=3\nedge 0,0 width,0\n", {"let widht=4"})) ==
          "--set:1:5: error: the level has no let 'widht'\n"
          "    1 | let widht=4\n"
          "      |     ^~~~~\n"
          "      = did you mean 'width'?\n");
    CHECK(rendered(with("", {"rate fast"})) ==
          "--set:1:6: error: 'fast' is not known\n"
          "    1 | rate fast\n"
          "      |      ^~~~\n"
          "      = give it a value above: let fast=...\n");
    CHECK(rendered(with("", {"ball a at=0,0"})) ==
          "--set:1:1: error: --set cannot change 'ball'\n"
          "    1 | ball a at=0,0\n"
          "      | ^~~~\n"
          "      = it changes: let use world solver rate seed game kind material observe\n");
    CHECK(with("", {""}).diagnostics.size() == 1);
    CHECK(with("", {"rate 5\nrate 6"}).diagnostics.size() == 1);
}

// They were ignored.
TEST_CASE("--set takes no let without a name or a value") {
    const auto codes = [](const std::string& statement) {
        std::vector<FaultCode> found;
        for (const Diagnostic& each : with("let a=3\nedge 0,0 a,0\n", {statement}).diagnostics)
            found.push_back(each.code);
        return found;
    };
    CHECK(codes("let a=4").empty());
    CHECK(codes("let") == std::vector<FaultCode>{"let-without-name"});
    for (const char* const statement : {"let a", "let a 4", "let a = 4", "let a=4 b"}) {
        CAPTURE(statement);
        CHECK(codes(statement) == std::vector<FaultCode>{"let-without-value"});
    }
}

TEST_CASE("options take precedence over the file, and count as overrides where they differ") {
    const auto overridden = [](const LoadOptions& options) {
        return load_lines("rate 60\nseed 5\nsolver discrete\n", options).scene.value().overridden;
    };
    LoadOptions same;
    same.rate = 60.0;
    same.seed = 5;
    same.solver = SolverSettings{SolverKind::discrete, 4, 15, 1};
    CHECK_FALSE(overridden(same));
    LoadOptions other = same;
    other.seed = 6;
    CHECK(overridden(other));
    other = same;
    other.rate = 61.0;
    CHECK(overridden(other));
    other = same;
    other.solver->kind = SolverKind::swept;
    CHECK(overridden(other));
    const Scene scene = load_lines("seed 5\n", other).scene.value();
    CHECK(scene.world.rate() == 60.0);
    CHECK(scene.solver->kind == SolverKind::swept);
}
