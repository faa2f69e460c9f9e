#include "lab/observe/observer.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "lab/support/load.h"
#include "physics/solver.h"

using namespace carom;

namespace {

// A level as it runs under an observer.
struct Observed {
    explicit Observed(const std::string& statements, SolverKind kind = SolverKind::event)
        : scene(test::load(statements)),
          world(scene.world),
          solver({.kind = kind}),
          observer(scene, {.kind = kind}, observed_of(scene), world) {}

    void run(double seconds) {
        const double ticks = std::round(seconds * world.rate());
        for (double tick = 0; tick < ticks; ++tick) {
            solver.tick(world);
            observer.note_tick(scene, world, solver.contacts());
        }
    }
    // None: it has no value.
    std::optional<double> value(std::string_view name) const {
        for (const ObservableRow& row : observables()) {
            if (!observer.what().has(row.what)) continue;
            for (const auto& [known, value] : observer.values(row.what, world))
                if (known == name) return value;
        }
        return std::nullopt;
    }

    Scene scene;
    World world;
    Solver solver;
    Observer observer;
};

// Largest difference of a curve from a function of x, relative to `size`.
template <class Function>
double misfit(const Curve& curve, double size, const Function& expected) {
    double worst = 0.0;
    for (const CurvePoint& point : curve.points)
        worst = std::max(worst, std::fabs(point.y - expected(point.x)) / size);
    return worst;
}

// 400 hard discs of radius 1 on a torus.
std::string discs(double packing, int count, const std::string& more) {
    const double side = std::sqrt(count * 3.14159265358979323846 / packing);
    return fmt::format(
        "world 0,0 {0},{0}\nuse wrap\nfill count={1} box=0,0,{0},{0} r=1 m=1 rms=10\n{2}", side,
        count, more);
}

constexpr double henderson_contact(double packing) {
    return (1.0 - 7.0 * packing / 16.0) / ((1.0 - packing) * (1.0 - packing));
}

}  // namespace

TEST_CASE("only what a level asks for is observed") {
    CHECK(observed_of(test::load("ball a at=0,0\nexpect energy 0 within 1\n")).is_empty());
    const ObservableSet what =
        observed_of(test::load("ball a at=0,0\nobserve pairs\nshow msd\n"
                               "expect speed_distance < 1 at=1s\n"));
    CHECK(what.has(Observable::pairs));
    CHECK(what.has(Observable::msd));
    CHECK(what.has(Observable::speeds));
    CHECK_FALSE(what.has(Observable::pressure));
    CHECK_FALSE(what.has(Observable::lyapunov));
}

TEST_CASE("pressure: one ball between two walls is the impulse by time and length, exactly") {
    // It hits each wall every 20 s / 4 = 5 s, with 2 m v = 24.
    Observed run(
        "edge name=left 0,0 0,10\nedge name=right 22,0 22,10\n"
        "ball at=11,5 v=4,0 m=3\nexpect pressure(right) 1 within 1\n"
        "expect pressure(left) 1 within 1\n");
    run.run(40.0);
    for (const Expect& expect : run.scene.expects)
        CHECK(*run.observer.value(expect.what, run.world) == doctest::Approx(24.0 / 10.0 / 10.0));
    CHECK_FALSE(run.value("pressure"));  // two edges enclose no area
}

TEST_CASE("pressure: balls that never meet are an ideal gas, P A = N kT") {
    Observed run(
        "collide ball edge\nworld 0,0 60,40\nbox name=wall 0,0 62,42\n"
        "fill count=300 box=0,0,62,42 rms=7 m=2\nexpect pressure(wall) 1 within 1\n"
        "observe pressure\n");
    CHECK_FALSE(run.value("pressure"));  // before the first tick
    run.run(60.0);
    const double ideal = 300 * 2.0 * 49.0 / 2.0 / (60.0 * 40.0);
    CHECK(*run.value("pressure") == doctest::Approx(ideal).epsilon(1e-12));
    CHECK(*run.value("kinetic_part") == doctest::Approx(ideal).epsilon(1e-12));
    // On the walls, in each direction, once all balls have been back and forth many times.
    double along_x = 0.0;
    double along_y = 0.0;
    for (const Vec2 v : run.world.balls().velocity) {
        along_x += 2.0 * v.x * v.x / (60.0 * 40.0);
        along_y += 2.0 * v.y * v.y / (60.0 * 40.0);
    }
    const double on_walls = *run.observer.value(run.scene.expects[0].what, run.world);
    CHECK(on_walls * 208.0 ==
          doctest::Approx(2.0 * 40.0 * along_x + 2.0 * 60.0 * along_y).epsilon(0.01));
}

TEST_CASE("pressure: of hard discs is that of Henderson, from the virial and from the walls") {
    // Walls and virial are independent: the impulses on walls do not enter into the virial.
    Observed run(
        "box name=wall 0,0 66,66\nfill count=400 box=0,0,66,66 r=1 m=1 rms=10\n"
        "expect pressure(wall) 1 within 1\nobserve pressure from=1s\n");
    run.run(21.0);
    const double virial = *run.value("pressure");
    const double on_walls = *run.observer.value(run.scene.expects[0].what, run.world);
    CHECK(on_walls * 66.0 / 64.0 == doctest::Approx(virial).epsilon(0.02));

    Observed torus(discs(0.3, 400, "observe pressure pairs from=1s\n"));
    torus.run(21.0);
    const double factor = *torus.value("pressure") / *torus.value("kinetic_part");
    CHECK(factor == doctest::Approx(1.0 + 0.6 * henderson_contact(0.3)).epsilon(0.01));
}

TEST_CASE("pressure: the weight of a gas of elastic balls rests on the floor") {
    Observed run(
        "use gravity 0,-10\nedge name=floor 0,0 40,0\nedge 0,0 0,400\nedge 40,0 40,400\n"
        "fill count=30 box=0,0,40,60 rms=9 m=2\nexpect pressure(floor) 15 within 1\n");
    run.run(60.0);
    const double measured = *run.observer.value(run.scene.expects[0].what, run.world);
    CHECK(measured == doctest::Approx(30 * 2 * 10 / 40.0).epsilon(0.02));
}

TEST_CASE("pressure: there is none where balls may rest, and none outside of an outline") {
    for (const std::string loss : {"material soft e=0.5\n", "material soft e=1\nuse drag 0.5\n"}) {
        CAPTURE(loss);
        Observed resting("use gravity 0,-10\n" + loss +
                         "box soft wall 0,0 9,9\n"
                         "ball at=3,3\nexpect pressure(wall) 1 within 1\nobserve pressure\n");
        resting.run(0.5);
        CHECK_FALSE(resting.value("pressure"));
        CHECK_FALSE(resting.observer.value(resting.scene.expects[0].what, resting.world));
    }
    Observed outside("box name=wall 0,0 9,9\nball at=30,3\nobserve pressure\n");
    outside.run(0.5);
    CHECK_FALSE(outside.value("pressure"));
    Observed empty("box name=wall 0,0 9,9\nobserve pressure msd vacf speeds pairs lyapunov\n");
    empty.run(0.5);
    CHECK(empty.value("pressure") == 0.0);
    for (const std::string_view name :
         {"msd", "vacf", "speed_distance", "speed_kurtosis", "contact_value", "lyapunov_time"})
        CHECK_FALSE(empty.value(name));
}

TEST_CASE("msd and vacf: free balls have v^2 t^2 and 1, also across a torus") {
    for (const std::string walls : {"", "world 0,0 20,15\nuse wrap\n"}) {
        CAPTURE(walls);
        Observed run(walls +
                     "collide ball edge\nball at=5,5 v=3,4\nball at=9,9 v=0,-2\n"
                     "observe msd vacf\n");
        CHECK(run.value("msd") == 0.0);
        CHECK(run.value("vacf") == 1.0);
        run.run(30.0);
        CHECK(*run.value("msd") == doctest::Approx((25.0 + 4.0) / 2.0 * 900.0));
        CHECK(*run.value("vacf") == doctest::Approx(1.0));
        const Curve curve = run.observer.curve(Observable::msd);
        CHECK(curve.points.size() > 200);
        CHECK(misfit(curve, 13050.0, [](double t) { return 14.5 * t * t; }) < 1e-12);
    }
}

// Back and forth in 20/7 s. Seen from one time origin, the ball flies either there or back; over
// origins 2 s apart, which meet all phases of its motion, the correlation is a triangle.
TEST_CASE("msd and vacf: the curves are means over time origins") {
    Observed run(
        "rate 16\nedge r=0 0,-5 0,5\nedge r=0 12,-5 12,5\nball at=2,0 v=7,0 r=1\n"
        "observe msd vacf\n");
    run.run(31.0);
    CHECK(std::fabs(*run.value("vacf")) == doctest::Approx(1.0));
    const double period = 20.0 / 7.0;
    int quarter = 0;
    for (const CurvePoint& point : run.observer.curve(Observable::vacf).points) {
        if (point.x > period / 2.0) continue;
        CHECK(std::fabs(point.y - (1.0 - 4.0 * point.x / period)) < 0.3);
        ++quarter;
    }
    CHECK(quarter == 23);
    for (const CurvePoint& point : run.observer.curve(Observable::msd).points)
        if (point.x == 2.75)        // nearly a whole period, for every origin
            CHECK(point.y < 0.57);  // 7 m/s for the rest of it
    // Every second lag goes after 512 ticks, and the mean over origins stays.
    run.run(3.0);
    const Curve later = run.observer.curve(Observable::vacf);
    CHECK(later.points.size() == 273);
    CHECK(later.points[1].x == 2.0 / 16.0);
    CHECK(std::fabs(later.points[5].y - (1.0 - 4.0 * 0.625 / period)) < 0.25);
}

// In an equilibrium of hard discs the velocity of a disc decays at first at the rate of Enskog:
// each impact takes, on average, as much as it would at random.
TEST_CASE("vacf: that of hard discs begins as Enskog says") {
    constexpr double packing = 0.2;
    Observed run(discs(packing, 400, "observe vacf from=2s"));
    run.run(10.0);
    const double pi = 3.14159265358979323846;
    const double rate =
        2.0 * std::sqrt(pi) * (packing / pi) * 2.0 * henderson_contact(packing) * std::sqrt(50.0);
    int checked = 0;
    for (const CurvePoint& point : run.observer.curve(Observable::vacf).points) {
        if (point.x * rate > 1.0) break;
        CAPTURE(point.x);
        CHECK(std::fabs(point.y - std::exp(-point.x * rate)) < 0.03);
        ++checked;
    }
    CHECK(checked > 10);
}

TEST_CASE("vacf: a ball that a wall sends back has -1") {
    Observed run("edge 10,-5 10,5\nball at=5,0 v=2,0\nobserve vacf msd\n");
    run.run(4.0);
    CHECK(*run.value("vacf") == doctest::Approx(-1.0));
    CHECK(*run.value("msd") == doctest::Approx(0.0).epsilon(1e-9));  // 4 there, 4 back
}

TEST_CASE("msd: removed balls no longer count, and later ones never do") {
    Observed run(
        "kind drop r=0.5\ncollide drop edge\nspawn drop at=0,50 v=9,0 every=10ms count=3\n"
        "ball a at=0,0 kind=drop v=1,0\nball b at=9,-20 kind=drop v=0,5\n"
        "zone out 9,0 9,0 r=1 sink\nobserve msd\n");
    run.run(7.0);
    CHECK(run.world.ledger().removed.size() == 1);
    CHECK(*run.value("msd") == doctest::Approx(49.0));
}

TEST_CASE("speeds: those of a Gaussian fill are Maxwell-Boltzmann, equal ones are not") {
    const Observed gas(
        "collide ball edge\nfill count=2000 box=0,0,200,200 r=1 rms=5\n"
        "observe speeds\n");
    CHECK(*gas.value("speed_distance") < 1.63 / std::sqrt(2000.0));
    CHECK(*gas.value("speed_kurtosis") == doctest::Approx(2.0).epsilon(0.1));
    // All at the speed of the mean energy: u = 1, where 1 - exp(-1) = 0.632 should be.
    const Observed equal(
        "fill count=50 box=0,0,90,90 r=1 speed=5 m=1..4\ncollide ball edge\n"
        "observe speeds\n");
    CHECK(*equal.value("speed_distance") > 0.1);
    const Observed same("ball at=0,0 v=5,0\nball at=9,0 v=0,5\nobserve speeds\n");
    CHECK(*same.value("speed_distance") == doctest::Approx(1.0 - std::exp(-1.0)));
    CHECK(*same.value("speed_kurtosis") == doctest::Approx(1.0));
    const Observed still("ball at=0,0\nobserve speeds\n");
    CHECK_FALSE(still.value("speed_distance"));
}

TEST_CASE("speeds: balls that start equally fast relax to Maxwell and Boltzmann, by mass too") {
    Observed run(
        "world 0,0 80,80\nuse wrap\nfill count=500 box=0,0,80,80 m=1..6 r=sqrt(m)*0.5 "
        "speed=10\nobserve speeds from=4s\n");
    const double at_start = *speed_distance(run.world);
    run.run(14.0);
    CHECK(at_start > 0.2);
    CHECK(*run.value("speed_distance") < 1.63 / std::sqrt(500.0));
    const Curve curve = run.observer.curve(Observable::speeds);
    REQUIRE(curve.points.size() == SpeedMeter::bins);
    for (const CurvePoint& point : curve.points)
        CHECK(std::fabs(point.y - *point.expected) < 0.1);
}

TEST_CASE("pairs: points at random have g = 1, on a torus and in a box") {
    for (const std::string walls : {"world 0,0 50,70\nuse wrap\n", "box name=wall -1,-1 51,71\n"}) {
        CAPTURE(walls);
        // They do not meet, and start anywhere.
        Observed run(walls +
                     "use overlap\nkind a r=1\ncollide a edge\n"
                     "fill a count=400 box=0,0,50,70 rms=50\nobserve pairs\n");
        run.run(10.0);
        const Curve curve = run.observer.curve(Observable::pairs);
        REQUIRE(curve.points.size() == 200);
        double low = 0.0;
        double sum = 0.0;
        for (std::size_t i = 20; i < 200; ++i) {
            sum += curve.points[i].y / 180.0;
            low = std::max(low, std::fabs(curve.points[i].y - 1.0));
        }
        CHECK(sum == doctest::Approx(1.0).epsilon(0.01));
        CHECK(low < 0.1);
    }
}

TEST_CASE("pairs: as counted by testing every pair, on a torus and in a box") {
    for (const std::string walls : {"world 0,0 31,40\nuse wrap\n", "box name=wall -1,-1 32,41\n"}) {
        CAPTURE(walls);
        Observed run(walls + "fill count=120 box=0,0,31,40 r=1 rms=9\nobserve pairs\n");
        run.run(1.0 / 120.0);
        const Curve curve = run.observer.curve(Observable::pairs);
        const auto& place = run.world.balls().position;
        const bool is_torus = run.world.model().wrap.has_value();
        const double reach = static_cast<double>(curve.points.size()) * PairMeter::bin_width * 2.0;
        std::vector<double> counts(curve.points.size(), 0.0);
        double within = 0.0;
        for (std::size_t i = 0; i < place.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                Vec2 apart = place[i] - place[j];
                if (is_torus)
                    apart = {std::remainder(apart.x, 31.0), std::remainder(apart.y, 40.0)};
                const double distance = length(apart);
                if (distance >= reach) continue;
                ++counts[static_cast<std::size_t>(distance / PairMeter::bin_width / 2.0)];
                ++within;
            }
        }
        CHECK(within > 900.0);
        const double all = 120.0 * 119.0 / 2.0;
        const double a = 31.0;
        const double b = 40.0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            // The share of pairs in the bin, by the midpoint rule.
            double share = 0.0;
            for (int part = 0; part < 10; ++part) {
                const double r =
                    (static_cast<double>(i) + (part + 0.5) / 10.0) * PairMeter::bin_width * 2.0;
                const double density =
                    is_torus ? 2.0 * 3.14159265358979 * r / (a * b)
                             : 2.0 * r / (a * a * b * b) *
                                   (3.14159265358979 * a * b - 2.0 * (a + b) * r + r * r);
                share += density * PairMeter::bin_width * 2.0 / 10.0;
            }
            CHECK(curve.points[i].y == doctest::Approx(counts[i] / all / share).epsilon(1e-3));
        }
    }
}

TEST_CASE("pairs: hard discs have Henderson's contact value, and nothing nearer") {
    Observed run(discs(0.3, 400, "observe pairs from=1s\n"));
    run.run(16.0);
    CHECK(*run.value("contact_value") == doctest::Approx(henderson_contact(0.3)).epsilon(0.03));
    for (const CurvePoint& point : run.observer.curve(Observable::pairs).points)
        if (point.x < 1.0) CHECK(point.y == 0.0);
    const Observed mixed(
        "world 0,0 40,40\nuse wrap\nfill count=20 box=0,0,40,40 r=1..2 rms=1\n"
        "observe pairs\n");
    CHECK_FALSE(mixed.value("contact_value"));
}

TEST_CASE("lyapunov: the orbit between two discs has the closed form") {
    // Between discs of radius a whose centres are R apart, a difference grows in each flight by
    // R/a - 1 + sqrt(R/a (R/a - 2)) (Gaspard and Rice, J. Chem. Phys. 90, 1989). Here a = 1, R = 6,
    // and a flight takes 4 s: at an exact multiple of the tick, so that impacts are at its end.
    Observed run(
        "peg at=-3,0 r=0.5\npeg at=3,0 r=0.5\nball at=0,0 r=0.5 v=1,0\n"
        "observe lyapunov from=10s\n");
    run.run(110.0);
    const double exact = std::log(5.0 + std::sqrt(24.0)) / 4.0;
    CHECK(*run.value("lyapunov_exponent") == doctest::Approx(exact).epsilon(1e-4));
    CHECK(*run.value("lyapunov_time") == doctest::Approx(1.0 / exact).epsilon(1e-4));
}

TEST_CASE("lyapunov: a ball between parallel walls forgets nothing") {
    Observed run("edge 0,-50 0,50\nedge 20,-50 20,50\nball at=10,0 v=7,0\nobserve lyapunov\n");
    run.run(100.0);
    CHECK(std::fabs(*run.value("lyapunov_exponent")) < 1e-4);
}

TEST_CASE("lyapunov: of a gas does not depend on the solver, and the gas is not disturbed") {
    const std::string gas = discs(0.2, 60, "seed 3\nobserve lyapunov from=2s\n");
    std::vector<double> exponents;
    for (const SolverKind kind : {SolverKind::event, SolverKind::swept}) {
        Observed run(gas, kind);
        run.run(60.0);
        exponents.push_back(*run.value("lyapunov_exponent"));
        if (kind != SolverKind::event) continue;
        World alone = run.scene.world;
        Solver solver({.kind = kind});
        while (alone.tick() < run.world.tick())
            solver.tick(alone);
        CHECK(alone.balls().position == run.world.balls().position);
    }
    CHECK(exponents[0] > 1.0);
    CHECK(exponents[1] == doctest::Approx(exponents[0]).epsilon(0.1));
}

TEST_CASE("observations begin at `from`, at its tick") {
    Observed run("collide ball edge\nball at=0,0 v=1,0\nobserve msd speeds from=2s\n");
    run.run(1.0);
    CHECK_FALSE(run.observer.has_begun());
    CHECK_FALSE(run.value("msd"));
    CHECK(run.observer.curve(Observable::speeds).points.empty());
    run.run(4.0);
    CHECK(*run.value("msd") == doctest::Approx(9.0));
}

TEST_CASE("observations are written as JSON and as CSV") {
    Observed run("collide ball edge\nball at=0,0 v=2,0\nrate 10\nobserve msd pressure\n");
    run.run(0.2);
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::lines);
    write_observed(json, &run.observer, run.world);
    json.end_object();
    const std::string text = std::move(json).text();
    CHECK(text.find(R"("pressure": {"pressure": null, "kinetic_part": null, "curve": []})") !=
          std::string::npos);
    CHECK(text.find(R"("msd": {"msd": 0.16000000000000003, "curve": [[0.0, 0.0], [0.1, )") !=
          std::string::npos);
    const std::string csv = curves_csv(run.observer);
    CHECK(csv.starts_with("observable,x,y,expected\nmsd,0,0,\nmsd,0.1,"));
    CHECK(observed_text(run.observer, run.world).starts_with("pressure          no value\n"));
}
