#include "terminal/draw/overlays.h"

#include <doctest/doctest.h>

#include <set>

#include "level/load.h"
#include "terminal/draw/draw.h"

using namespace carom;

namespace {

// Two balls that collide within the first tick, with everything an overlay may need.
std::string picture_with(const OverlaySet& shown) {
    const LoadResult loaded = load_level(
        "carom 1 \"Two balls\"\n"
        "kind disc r=1\n"
        "box r=0 -8,-4 8,4\n"
        "ball a kind=disc at=-1.1,0 v=9,2\n"
        "ball b kind=disc at=1.1,0 v=-9,1\n"
        "rate 30\n",
        "two-balls");
    REQUIRE(loaded.scene);
    const Scene& scene = *loaded.scene;
    World world = scene.world;
    Solver solver(pick_solver(world).settings);
    solver.tick(world);
    REQUIRE_FALSE(solver.contacts().empty());
    Canvas canvas(60, 20);
    ViewOptions options;
    options.overlays = shown;
    Annotations annotations;
    annotations.broad_phase = CellGrid{{0.25, 0.25}, 2.0};
    ViewMemory memory;
    draw_world(canvas, fit_camera({{-8, -4}, {8, 4}}, {0, 0, 60, 20}, 2.0), scene, world,
               solver.contacts(), annotations, options, memory);
    return canvas.text();
}

}  // namespace

TEST_CASE("every overlay has a unique name, and shows something that no other shows") {
    std::set<std::string_view> names;
    std::set<std::string> pictures{picture_with({})};
    for (std::size_t i = 0; i < overlays().size(); ++i) {
        CAPTURE(overlays()[i].name);
        CHECK(names.insert(overlays()[i].name).second);
        CHECK(overlay_named(overlays()[i].name) == i);
        OverlaySet shown;
        shown[i] = true;
        CHECK(pictures.insert(picture_with(shown)).second);
    }
}
