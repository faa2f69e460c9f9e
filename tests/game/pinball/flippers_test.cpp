#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "game/support/flipper_bench.h"
#include "level/load.h"
#include "support/sanitizers.h"

// What players do with flippers, on every table that ships and on the manual's example: inlanes
// feed, cradles hold, cradled balls can be aimed, and the moves that players have names for work.

using namespace carom;
using namespace carom::test;

namespace {

struct Table {
    std::string name;
    Scene scene;
    std::vector<Inlane> lanes;
};

std::vector<Table> load_tables() {
    const std::filesystem::path source(CAROM_SOURCE_DIR);
    std::vector<std::filesystem::path> files{source / "docs" / "first-table.level"};
    for (const auto& file : std::filesystem::directory_iterator(source / "levels"))
        if (file.path().extension() == ".level") files.push_back(file.path());
    std::ranges::sort(files);
    std::vector<Table> tables;
    for (const std::filesystem::path& file : files) {
        std::stringstream text;
        text << std::ifstream(file).rdbuf();
        if (text.str().find("\ngame pinball") == std::string::npos) continue;
        LoadResult loaded = load_level(text.str(), file.filename().string(), {});
        REQUIRE(loaded.scene.has_value());
        tables.push_back({file.stem().string(), std::move(*loaded.scene), {}});
        tables.back().lanes = inlanes_of(tables.back().scene);
    }
    return tables;
}

const std::vector<Table>& tables() {
    static const std::vector<Table> loaded = load_tables();
    return loaded;
}

template <typename Test>
void on_each_lane(Test&& test) {
    for (const Table& table : tables()) {
        CAPTURE(table.name);
        for (const Inlane& lane : table.lanes) {
            CAPTURE(lane.flipper);
            test(table.scene, lane);
        }
    }
}

/// A ball that lies in the cradle of the raised flipper.
FlipperBench cradled(const Scene& scene, const Inlane& lane) {
    FlipperBench bench(scene, lane, lane.starts.front());
    bench.settle_flipper(true);
    bench.run(3.0);
    REQUIRE(length(bench.velocity()) < 0.005);
    REQUIRE(bench.gap() < 0.001);
    return bench;
}

/// How a ball leaves a flipper that is pressed now.
struct Shot {
    double speed = 0.0;      // m/s
    double direction = 0.0;  // degrees from straight up to the far side
};

Shot shoot(FlipperBench& bench, const Inlane& lane) {
    bench.press(true);
    for (int i = 0; i < 100 && bench.world().flippers()[lane.flipper].progress < 1.0; ++i)
        bench.tick();
    return {length(bench.velocity()), bench.direction()};
}

// From the pivot to the tip, all shots are usable, and turn steadily to the far side, by 30 degrees
// at least. A quarter of a degree is the scatter of a rolling ball's last hop.
void check_shots(const std::vector<Shot>& shots) {
    for (std::size_t i = 0; i < shots.size(); ++i) {
        CAPTURE(i);
        CHECK(shots[i].speed > 2.0);
        CHECK(shots[i].speed < 7.0);
        if (i > 0) CHECK(shots[i].direction > shots[i - 1].direction - 0.25);
    }
    CHECK(shots.back().direction - shots.front().direction > 30.0);
}

/// How fast a ball leaves a flipper on which it falls at 1.5 m/s, at most, away from the raised
/// flipper's face, in the 0.05 s after it has touched it, m/s; `play` works the button each tick,
/// told the seconds until the ball lands.
template <typename Play>
double rebound(const Scene& scene, const Inlane& lane, bool is_up, Play&& play) {
    const auto falling = [&] {
        FlipperBench bench(scene, lane, {});
        bench.settle_flipper(true);
        bench.place(bench.flipper_at(0.6) + Vec2{0.0, 0.1}, {0.0, -1.5});
        return bench;
    };
    FlipperBench held = falling();
    const Vec2 along = held.flipper_at(1.0) - held.flipper_at(0.0);
    const Vec2 face =
        perpendicular(along) * (along.x > 0.0 ? 1.0 / length(along) : -1.0 / length(along));
    while (held.gap() > 0.0005 && held.time() < 1.0)
        held.tick();
    const double lands = held.time();
    FlipperBench bench = falling();
    bench.settle_flipper(is_up);
    double touched = -1.0;
    double fastest = -1e9;
    while (bench.time() < (touched < 0.0 ? lands + 0.3 : touched + 0.05)) {
        play(bench, lands - bench.time());
        bench.tick();
        if (touched < 0.0 && bench.gap() < 0.0005) touched = bench.time();
        if (touched >= 0.0 && bench.time() > touched + 0.002)
            fastest = std::max(fastest, dot(bench.velocity(), face));
    }
    return touched < 0.0 ? 1e9 : fastest;
}

double held_rebound(const Scene& scene, const Inlane& lane) {
    return rebound(scene, lane, true, [](FlipperBench&, double) {});
}

/// Where a ball from the cradle is after the button was let go for `rolls` s and pressed for
/// `taps`.
struct Pass {
    bool arrives = false;  // on the other flipper, without a flip there
    double highest = 0.0;  // above the pivot on its way, m
    double turned = 0.0;   // time after the tap at which something but the flipper turned it, s
};

Pass pass(const Scene& scene, const Inlane& lane, const FlipperBench& cradle, double rolls,
          double taps) {
    FlipperBench bench = cradle.fork();
    const double pivot =
        scene.world.capsules()
            .shape[*index_of(scene.world, scene.world.flippers()[lane.flipper].capsule)]
            .start.y;
    bench.press(false);
    bench.run(rolls);
    bench.press(true);
    bench.run(taps);
    bench.press(false);
    Pass result;
    const double tapped = bench.time();
    Vec2 before = bench.velocity();
    while (bench.time() < tapped + 1.2 && bench.at().y > pivot - 0.08) {
        bench.tick();
        result.highest = std::max(result.highest, bench.at().y - pivot);
        if (length(bench.velocity() - before) > 0.05 && bench.gap() > 0.002 && result.turned == 0.0)
            result.turned = bench.time() - tapped;
        before = bench.velocity();
        if (!bench.is_on_other()) continue;
        result.arrives = true;
        break;
    }
    return result;
}

bool has_slingshots(const Scene& scene) {
    return std::ranges::count(scene.table.devices, DeviceKind::slingshot, &Device::kind) > 0;
}

}  // namespace

TEST_CASE("every table that ships has two inlanes") {
    CHECK(tables().size() >= 4);
    for (const Table& table : tables()) {
        CAPTURE(table.name);
        CHECK(table.lanes.size() == 2);
        for (const Inlane& lane : table.lanes)
            CHECK(lane.starts.size() >= 10);
    }
}

TEST_CASE("a ball let go in an inlane rolls down guide and flipper to its tip, without a jump") {
    on_each_lane([](const Scene& scene, const Inlane& lane) {
        double farthest = 0.0;
        for (std::size_t i = 0; i < lane.starts.size(); i += has_sanitizers ? 4 : 1) {
            FlipperBench bench(scene, lane, lane.starts[i]);
            bool has_touched = false;
            while (bench.time() < 4.0 && bench.along() < 1.0) {
                bench.tick();
                has_touched = has_touched || bench.gap_to_lane() < 0.0002;
                if (has_touched) farthest = std::max(farthest, bench.gap_to_lane());
            }
            CHECK(bench.along() >= 1.0);
        }
        CHECK(farthest < 0.003);
    });
}

TEST_CASE("trap: a raised flipper holds a ball from the inlane, and lets it roll off") {
    on_each_lane([](const Scene& scene, const Inlane& lane) {
        double slowest = 0.0;
        for (std::size_t i = 0; i < lane.starts.size(); i += has_sanitizers ? 6 : 3) {
            FlipperBench bench(scene, lane, lane.starts[i]);
            bench.settle_flipper(true);
            double touched = -1.0;
            double moved = 0.0;
            while (bench.time() < 3.0) {
                bench.tick();
                if (touched < 0.0 && bench.gap() < 0.0002) touched = bench.time();
                if (length(bench.velocity()) > 0.005) moved = bench.time();
            }
            REQUIRE(touched > 0.0);
            slowest = std::max(slowest, moved - touched);
            CHECK(bench.gap() < 0.0005);
            bench.press(false);
            bench.run(1.5);
            CHECK(bench.along() > 1.0);
        }
        CHECK(slowest < 1.5);
    });
}

TEST_CASE("a ball at rest on a flipper is aimed by where it lies") {
    on_each_lane([](const Scene& scene, const Inlane& lane) {
        std::vector<Shot> shots;
        for (int i = 0; i < 8; ++i) {
            FlipperBench bench(scene, lane, {});
            bench.place(bench.rest_at(i / 7.0));
            shots.push_back(shoot(bench, lane));
        }
        check_shots(shots);
    });
}

TEST_CASE("a ball that rolls down from the inlane is aimed by when the button is pressed") {
    on_each_lane([](const Scene& scene, const Inlane& lane) {
        std::vector<Shot> shots;
        for (int i = 0; i < 8; ++i) {
            FlipperBench bench(scene, lane, lane.starts.back());
            while (bench.time() < 4.0 && bench.along() < 0.98 * i / 7.0)
                bench.tick();
            shots.push_back(shoot(bench, lane));
        }
        check_shots(shots);
    });
}

TEST_CASE("drop catch: a flipper let go just before the ball lands takes its speed") {
    on_each_lane([](const Scene& scene, const Inlane& lane) {
        double best = 1e9;
        for (int early = 0; early <= 60; early += 4)
            best =
                std::min(best, rebound(scene, lane, true, [&](FlipperBench& bench, double lands) {
                             bench.press(lands > early * 0.001);
                         }));
        CHECK(best < 0.4 * held_rebound(scene, lane));
    });
}

TEST_CASE(
    "live catch: a flipper that reaches its stop just before the ball lands takes its speed") {
    on_each_lane([](const Scene& scene, const Inlane& lane) {
        double best = 1e9;
        for (int early = 20; early <= 45; ++early)
            best =
                std::min(best, rebound(scene, lane, false, [&](FlipperBench& bench, double lands) {
                             bench.press(lands < early * 0.001);
                         }));
        CHECK(best < 0.4 * held_rebound(scene, lane));
    });
}

TEST_CASE("post pass: a tap near the pivot sends the ball across, off the slingshot's post") {
    on_each_lane([](const Scene& scene, const Inlane& lane) {
        if (!has_slingshots(scene)) return;
        const FlipperBench cradle = cradled(scene, lane);
        int made = 0;
        for (int rolls = 100; rolls <= 220 && made < 1; rolls += 5)
            for (int taps = 8; taps <= 20 && made < 1; taps += 3) {
                const Pass passed = pass(scene, lane, cradle, rolls * 0.001, taps * 0.001);
                if (passed.arrives && passed.turned > 0.0 && passed.turned < 0.12) ++made;
            }
        CHECK(made >= 1);
    });
}

TEST_CASE("tap pass: a short tap under a ball near the tip lifts it across to the other flipper") {
    on_each_lane([](const Scene& scene, const Inlane& lane) {
        const FlipperBench cradle = cradled(scene, lane);
        int made = 0;
        for (int rolls = 260; rolls <= 500 && made < 3; rolls += 20)
            for (int taps = 2; taps <= 7 && made < 3; ++taps) {
                const Pass passed = pass(scene, lane, cradle, rolls * 0.001, taps * 0.001);
                if (passed.arrives && passed.turned == 0.0 && passed.highest < 0.12) ++made;
            }
        CHECK(made >= 3);
    });
}

// With both buttons down, the tips close in on a ball that falls between them.
TEST_CASE("flippers that jam on a ball between them stall, and time goes on") {
    for (const Table& table : tables()) {
        CAPTURE(table.name);
        const Scene& scene = table.scene;
        for (double height = -0.03; height < 0.03; height += has_sanitizers ? 0.008 : 0.002) {
            CAPTURE(height);
            World world = scene.world;
            Solver solver(pick_solver(world).settings);
            FlipperBench bench(scene, table.lanes.front(), {});
            const Vec2 tip = bench.flipper_at(1.0);
            const Vec2 pivot = bench.flipper_at(0.0);
            // The pivot of the other flipper is as far from its own lane.
            const double middle = 0.5 * (pivot.x + table.lanes.back().starts.front().x +
                                         (pivot.x - table.lanes.front().starts.front().x));
            while (world.balls().size() > 1)
                remove_ball(world, world.balls().id[1]);
            world.edit_balls().position[0] = {middle, tip.y + height};
            world.edit_balls().velocity[0] = {0.0, -0.5};
            int stood = 0;
            for (int tick = 0; tick < 400; ++tick) {
                for (Flipper& flipper : world.edit_flippers())
                    flipper.is_pressed = tick < 200;
                if (solver.tick(world) == TickOutcome::stood_still) ++stood;
            }
            CHECK(stood <= 4);
        }
    }
}
