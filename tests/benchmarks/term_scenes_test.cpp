#include "term_scenes.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

#include "level/load.h"

using namespace carom;
using namespace carom::bench;

namespace {

std::string gas() {
    std::ifstream file(std::string(CAROM_SOURCE_DIR) + "/benchmarks/scenes/gas.level");
    return {std::istreambuf_iterator<char>(file), {}};
}

World world_of(const CountedScene& scene) {
    LoadOptions options;
    options.overrides = scene.overrides;
    const LoadResult result = load_level(scene.text, "test.level", options);
    for (const Diagnostic& diagnostic : result.diagnostics)
        INFO(render(diagnostic));
    REQUIRE(result.scene);
    World world = result.scene->world;
    if (scene.prepare) scene.prepare(world);
    if (scene.before_tick) scene.before_tick(world);
    return world;
}

bool has_a_term(const World& world) {
    return world.model() != Model{} || !world.zones().empty() || !world.emitters().empty() ||
           !world.held_capsules().empty();
}

}  // namespace

TEST_CASE("the bare gas uses no term") {
    CHECK_FALSE(has_a_term(world_of(bare_scene(gas()))));
}

TEST_CASE("each scene uses its term, and without it the model of the bare gas") {
    const World bare = world_of(bare_scene(gas()));
    for (const TermScene& scene : term_scenes(gas())) {
        CAPTURE(scene.term);
        const World with = world_of(scene.with);
        CHECK(has_a_term(with));
        CHECK(with.balls().size() >= bare.balls().size());
        if (scene.without) CHECK(world_of(*scene.without).model() == Model{});
    }
}
