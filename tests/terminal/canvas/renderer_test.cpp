#include "terminal/canvas/renderer.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace carom;

TEST_CASE(
    "every renderer has a unique name, samples that fit a cell, and a function to show them") {
    std::set<std::string_view> names;
    for (const Renderer& renderer : renderers()) {
        CAPTURE(renderer.name);
        CHECK(names.insert(renderer.name).second);
        CHECK(renderer_choice(renderer.name) == &renderer);
        CHECK(name_of(&renderer) == renderer.name);
        CHECK(renderer.across >= 1);
        CHECK(renderer.down >= 1);
        CHECK(static_cast<std::size_t>(renderer.across * renderer.down) <= most_samples);
        CHECK((renderer.show != nullptr));
    }
    CHECK(renderer_choice("auto") == RendererChoice{});
    CHECK(name_of(nullptr) == "auto");
    CHECK_FALSE(renderer_choice(""));
    CHECK_FALSE(renderer_choice("mosaic"));
    CHECK(renderer_choice_names().size() == renderers().size() + 1);
}

TEST_CASE("every renderer shows a full cell, in ASCII if it promises ASCII") {
    for (const Renderer& renderer : renderers()) {
        CAPTURE(renderer.name);
        CellSamples samples;
        samples.levels.fill(255);
        samples.colors.fill(3);
        const Cell cell = renderer.show(samples, {});
        CHECK(cell.glyph != U' ');
        CHECK(cell.foreground == 3);
        CHECK((renderer.needs_utf8 || cell.glyph < 0x7f));
    }
}

TEST_CASE("a choice resolves to a renderer that the terminal can show") {
    const Look plain_terminal{.colors = 0, .utf8 = false};
    const Look mono{.colors = 0, .utf8 = true};
    const Look full{.colors = 256, .utf8 = true};
    CHECK(&renderer_for(nullptr, full) == &half_block_renderer());
    CHECK(&renderer_for(nullptr, mono) == &braille_renderer());
    CHECK(&renderer_for(nullptr, plain_terminal) == &ascii_renderer());
    for (const Renderer& renderer : renderers()) {
        CHECK(&renderer_for(&renderer, full) == &renderer);
        CHECK_FALSE(renderer_for(&renderer, plain_terminal).needs_utf8);
    }
}

TEST_CASE("the next renderer cycles through all") {
    const Renderer* renderer = &renderers().front();
    for (std::size_t i = 1; i < renderers().size(); ++i) {
        renderer = &renderer_after(*renderer);
        CHECK(renderer == &renderers()[i]);
    }
    CHECK(&renderer_after(*renderer) == &renderers().front());
}
