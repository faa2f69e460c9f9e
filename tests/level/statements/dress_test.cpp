#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "level/load.h"
#include "level/values/color_names.h"
#include "physics/world/fingerprint.h"

using namespace carom;

namespace {

Scene loaded(const std::string& text) {
    LoadResult result = load_level("carom 1 \"t\"\n" + text, "test.level");
    std::string problems;
    for (const Diagnostic& diagnostic : result.diagnostics)
        if (diagnostic.severity == Severity::error) problems += render(diagnostic);
    REQUIRE(problems == "");
    REQUIRE(result.scene);
    return std::move(*result.scene);
}

}  // namespace

TEST_CASE("dress: a colour is a name or #rrggbb, and no comment") {
    CHECK(color_of("red") == color_named("red"));
    CHECK(color_of("#12AbfF") == Rgb24{0x12abff});
    CHECK(color_text(0x00ab0f) == "#00ab0f");
    for (const auto* text : {"#12345", "#1234567", "#12345g", "12345", "", "Red"})
        CHECK_FALSE(color_of(text));
    const Scene scene = loaded("ball a at=0,0 color=#102030 r=2# color=red\n");
    CHECK(color_in(scene.dress.balls, 0) == Rgb24{0x102030});
    CHECK(scene.world.balls().radius[0] == 2.0);
}

TEST_CASE("dress: a ball named red is red unless color= says otherwise") {
    const Scene scene = loaded(
        "kind blue\nkind plain color=gold\n"
        "repeat 2 step=5,0\nball red at=0,0\nend\n"
        "ball green at=20,0 color=pink\nball at=30,0 kind=blue\nball at=40,0 kind=plain\n"
        "ball other at=50,0\n");
    const Dress& dress = scene.dress;
    CHECK(color_in(dress.balls, 0) == color_named("red"));
    CHECK(scene.ball_names[1] == "red.2");
    CHECK(color_in(dress.balls, 1) == color_named("red"));
    CHECK(color_in(dress.balls, 2) == color_named("pink"));
    CHECK_FALSE(color_in(dress.balls, 3));
    CHECK(color_in(dress.kinds, 0) == color_named("blue"));
    CHECK(color_in(dress.kinds, 1) == color_named("gold"));
    CHECK_FALSE(color_in(dress.balls, 5));
    CHECK_FALSE(color_in(dress.balls, 1000));
}

TEST_CASE("dress: colours of edges, materials and zones; copies on other layers share theirs") {
    const Scene scene = loaded(
        "kind k color=teal\nmaterial wood\nmaterial rail layer=1 color=red\n"
        "edge wood 0,0 9,0\nedge wood 0,5 9,5 color=navy\nedge rail 0,9 9,9\n"
        "zone far 90,9 91,9 r=1\nzone near 80,9 81,9 r=1 color=lime\nball a at=2,2 kind=k r=0.5\n");
    CHECK(color_in(scene.dress.materials, 0) == color_named("wood"));
    CHECK(color_in(scene.dress.materials, 1) == color_named("red"));
    CHECK_FALSE(color_in(scene.dress.edges, 0));
    CHECK(color_in(scene.dress.edges, 1) == color_named("navy"));
    CHECK(scene.dress.layers == std::vector<std::uint8_t>{0, 1});
    REQUIRE(scene.world.kinds().size() == 2);
    CHECK(color_in(scene.dress.kinds, 1) == color_named("teal"));
    const auto near = std::ranges::find(scene.zone_names, "near.1") - scene.zone_names.begin();
    for (std::size_t i = 0; i < 2; ++i)
        CHECK(color_in(scene.dress.zones, i).has_value() == (static_cast<long>(i) == near));
}

TEST_CASE("dress: paint and labels follow mirror, and theme is kept") {
    const Scene scene = loaded(
        "theme board=navy rail=wood\nball a at=0,0\n"
        "mirror x=10\npaint rect 0,0 4,2 color=red\nlabel \"A b\" at=1,1 align=left\nend\n"
        "paint circle at=5,5 r=2 color=blue\npaint polygon 0,0 1,0 0,1 color=gold\n");
    const Dress& dress = scene.dress;
    REQUIRE(dress.areas.size() == 4);
    CHECK(dress.areas[1].corners[0] == Vec2{20.0, 0.0});
    CHECK(dress.areas[1].corners[2] == Vec2{16.0, 2.0});
    CHECK(dress.areas[2].disc == Disc{{5.0, 5.0}, 2.0});
    CHECK(dress.areas[3].color == color_named("gold"));
    REQUIRE(dress.labels.size() == 2);
    CHECK(dress.labels[0].text == "A b");
    CHECK(dress.labels[1].at == Vec2{19.0, 1.0});
    CHECK(dress.labels[1].align == BoardLabel::Align::left);
    CHECK(dress.theme.board == color_named("navy"));
    CHECK_FALSE(dress.theme.edge);
}

TEST_CASE("dress: an insert is a lamp that rules light") {
    const Scene scene = loaded(
        "ball a at=0,0\ndrain out 0,-50 9,-50\ntarget t 20,0 20,9 color=lime\n"
        "insert jackpot \"JACK POT\" at=5,5 at=6,6 shape=arrow turn=0 r=2 color=red\nlamp plain "
        "at=9,9\n"
        "game pinball\non t hit light jackpot\n");
    REQUIRE(scene.table.devices.size() == scene.dress.devices.size());
    REQUIRE(scene.table.devices.size() == 5);
    CHECK(scene.dress.devices[1].color == color_named("lime"));
    const DeviceDress& insert = scene.dress.devices[2];
    CHECK(scene.table.devices[2].kind == DeviceKind::lamp);
    CHECK(scene.table.devices[3].place == Vec2{6.0, 6.0});
    CHECK(insert.is_insert);
    CHECK(insert.shape == InsertShape::arrow);
    CHECK(insert.direction == Vec2{1.0, 0.0});
    CHECK(insert.text == "");
    CHECK(scene.dress.devices[3].text == "JACK POT");  // once for both
    CHECK(insert.radius == 2.0);
    CHECK_FALSE(scene.dress.devices[4].is_insert);
}

TEST_CASE("dress: no colour, paint or label changes the fingerprint of a world") {
    const std::string plain = "kind k\nmaterial m e=0.5\nedge m 0,0 9,0\nball a at=3,3 kind=k\n";
    const std::string dressed =
        "theme board=red edge=gold\nkind k color=red\nmaterial m e=0.5 color=blue\n"
        "edge m 0,0 9,0 color=gold\nball a at=3,3 kind=k color=pink\n"
        "paint rect 0,0 9,9 color=navy\nlabel \"x\" at=1,1\n";
    CHECK(fingerprint(loaded(plain).world) == fingerprint(loaded(dressed).world));
}

TEST_CASE("dress: the strings of a cradle end above the places where its balls rest") {
    const Scene scene = loaded(
        "ball other at=90,90 r=1\n"
        "repeat 2 step=0,30\ncradle five at=50,30 count=5 in=2 v=10 r=3 swing=12\nend\n");
    const std::vector<CradleString>& strings = scene.dress.strings;
    REQUIRE(strings.size() == 10);
    for (std::size_t i = 0; i < strings.size(); ++i) {
        CHECK(strings[i].is_first == (i % 5 == 0));
        CHECK(strings[i].pivot.y == doctest::Approx((i < 5 ? 30.0 : 60.0) + 7.5));
        CHECK(scene.ball_names[strings[i].ball].starts_with("five."));
        if (i % 5 > 0) CHECK(strings[i].pivot.x - strings[i - 1].pivot.x == doctest::Approx(6.0));
    }
}
