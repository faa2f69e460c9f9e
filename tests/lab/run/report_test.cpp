#include "lab/run/report.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "lab/run/streams.h"
#include "lab/support/load.h"

using namespace carom;
using test::load;

namespace {

struct Finished {
    Scene scene;
    World world;
    RunRecord record;
    std::string report;
};

Finished run(const std::string& statements, std::uint64_t ticks) {
    Finished run{.scene = load(statements),
                 .world = {},
                 .record = {.watch = {Scene{}, RunWatch::Conservation::ignored}},
                 .report = {}};
    run.world = run.scene.world;
    Solver solver(solver_for(run.scene));
    run.record = begin_record(run.scene, solver.settings());
    while (run.world.tick() < ticks) {
        solver.tick(run.world);
        note_tick(run.record, run.scene, run.world, solver);
    }
    note_end(run.record, run.scene, run.world);
    run.report = report_json("test", run.scene, run.world, run.record, 0.25);
    return run;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the report has its keys, in order") {
    const std::string report = run("ball a at=0,0 v=1,0\n", 3).report;
    const std::vector<std::string> keys{"level",      "solver",      "settings",     "rate",
                                        "seed",       "ticks",       "time",         "model",
                                        "balls",      "removed",     "totals_start", "totals",
                                        "collisions", "max_overlap", "escaped",      "counters",
                                        "expects",    "cost",        "fingerprint"};
    std::size_t from = 0;
    for (const std::string& key : keys) {
        CAPTURE(key);
        const std::size_t at = report.find("\n  \"" + key + "\": ", from);
        REQUIRE(at != std::string::npos);
        from = at + 1;
    }
    CHECK(report.starts_with("{\n"));
    CHECK(report.ends_with("\n}\n"));
}

TEST_CASE("the report has the results of a run") {
    const std::string report = run("solver substep updates=2\n"
                                   "seed 7\n"
                                   "kind heavy r=2 m=49\n"
                                   "ball a at=0,0 v=1,0\n"
                                   "ball b kind=heavy at=9,0\n",
                                   60)
                                   .report;
    CHECK(has(report, "\"solver\": \"substep\",\n  \"settings\": {\"updates\": 2, \"steps\": 15}"));
    CHECK(has(report, "\"rate\": 120.0,\n  \"seed\": 7,\n  \"ticks\": 60,\n  \"time\": 0.5,"));
    CHECK(has(report,
              "{\"id\": 1, \"name\": \"b\", \"kind\": \"heavy\", \"x\": 9.0, \"y\": 0.0, "
              "\"vx\": 0.0, \"vy\": 0.0, \"w\": 0.0, \"radius\": 2.0, \"mass\": 49.0}"));
    CHECK(has(report, "\"collisions\": {\"ball_ball\": 0, \"ball_edge\": 0}"));
    CHECK(has(report, "\"cost\": {\"seconds\": 0.25, \"ns_per_ball_tick\": 2083333.3333333333}"));
}

TEST_CASE("everything in the report but the cost is reproducible") {
    const std::string level =
        "use gravity 0,-9.81\nworld 0,0 20,20\nbox r=0.5 1,1 19,19\n"
        "fill count=20 box=2,2,18,18 speed=3\n";
    const auto without_cost = [](const std::string& report) {
        return report.substr(0, report.find("\"cost\"")) +
               report.substr(report.find("\"fingerprint\""));
    };
    CHECK(without_cost(run(level, 200).report) == without_cost(run(level, 200).report));
}

TEST_CASE("counters are listed under the name of their group") {
    const std::string report = run("use gravity 0,-10\n"
                                   "bins cups count=3 width=4 at=0,0 depth=5 sink\n"
                                   "ball a at=0,9 r=0.5\n",
                                   240)
                                   .report;
    CHECK(has(report, "\"counters\": {\n    \"cups\": [0, 1, 0]\n  }"));
    CHECK(has(report, "\"by\": \"cups.2\""));
}

TEST_CASE("events are JSON lines, with the normal from b to a") {
    const Contact contact{.time = 0.5,
                          .kind = ContactKind::ball_edge,
                          .a = 3,
                          .b = 4,
                          .point = {1, -2},
                          .normal = {0, 1},
                          .approach = 2.5,
                          .impulse = 10};
    CHECK(event_lines(std::vector{contact, contact}, 60) ==
          "{\"t\": 0.5, \"tick\": 60, \"kind\": \"ball_edge\", \"a\": 3, \"b\": 4, \"x\": 1.0, "
          "\"y\": -2.0, \"nx\": 0.0, \"ny\": 1.0, \"approach\": 2.5, \"impulse\": 10.0}\n"
          "{\"t\": 0.5, \"tick\": 60, \"kind\": \"ball_edge\", \"a\": 3, \"b\": 4, \"x\": 1.0, "
          "\"y\": -2.0, \"nx\": 0.0, \"ny\": 1.0, \"approach\": 2.5, \"impulse\": 10.0}\n");
    CHECK(event_lines({}, 1).empty());
}

TEST_CASE("a trace has one row per ball") {
    Scene scene = load("rate 4\nball a at=1,2 v=0.1,0\nball b at=9,9\n");
    Solver solver({.kind = SolverKind::swept});
    CHECK(trace_header(scene.world) == "tick,time,id,x,y,vx,vy\n");
    CHECK(trace_rows(scene.world) == "0,0,0,1,2,0.1,0\n0,0,1,9,9,0,0\n");
    solver.tick(scene.world);
    CHECK(trace_rows(scene.world) == "1,0.25,0,1.025,2,0.1,0\n1,0.25,1,9,9,0,0\n");
}

TEST_CASE("in a model with spin, report and trace include it") {
    Scene scene = load("use spin\nball a at=1,2 w=-2.5\nexpect a.w -2.5 within 0\n");
    CHECK(trace_header(scene.world) == "tick,time,id,x,y,vx,vy,w\n");
    CHECK(trace_rows(scene.world) == "0,0,0,1,2,0,0,-2.5\n");
    const RunWatch watch(scene, RunWatch::Conservation::ignored);
    Judgement judgement;
    judge(scene.expects.at(0), scene.world, watch, true, judgement);
    CHECK(judgement.verdict == Verdict::holds);
}

TEST_CASE("the summary and the verdicts read well") {
    const Finished finished =
        run("rate 64\n"
            "ball a at=0,0 v=1,0\n"
            "expect a.x 0.5 within 1e-12\n"
            "expect a.x 3 within 0.25\n"
            "expect a.x 1 within 0 at=5\n"
            "expect a.x < 0.25 always by=1s\n"
            "expect a.x > 3 by=0.5s\n"
            "expect a.x -1 within 0.5 by=0.5s\n"
            "expect a.x < -2 by=0.25s\n",
            32);
    const std::string text = summary(finished.scene, finished.world, finished.record, 0.25);
    CHECK(has(text, "A test\n0.5 s simulated in 32 ticks by event"));
    CHECK(verdicts(finished.scene, finished.record, Verdict::holds) ==
          "test.level:4: holds: expect a.x 0.5 within 1e-12: it is 0.5\n");
    CHECK(
        verdicts(finished.scene, finished.record, Verdict::fails) ==
        "test.level:5: error: expect a.x 3 within 0.25: it is 0.5\n"
        "test.level:7: error: expect a.x < 0.25 always by 1s: it is 0.25 at 0.25 s\n"
        "test.level:8: error: expect a.x > 3 by 0.5s: it is 0.5 at 0.5 s, nearest 0.5 at 0.5 s\n"
        "test.level:9: error: expect a.x -1 within 0.5 by 0.5s: it is 0.5 at 0.5 s, nearest 0 at 0 "
        "s\n"
        "test.level:10: error: expect a.x < -2 by 0.25s: it is 0.25 at 0.25 s, nearest 0 at 0 "
        "s\n");
    CHECK(verdicts(finished.scene, finished.record, Verdict::not_judged) ==
          "test.level:6: not judged: expect a.x 1 within 0: the run ended before its time\n");
}

TEST_CASE("the explanation names the terms and the solver") {
    const std::string picked = explanation(load("ball a at=0,0\n"));
    CHECK(picked.starts_with("model   elastic, frictionless"));
    CHECK(has(picked, " (chosen automatically)\nreason  "));
    CHECK(has(picked, "rate    120 ticks a second\n"));
    const std::string text =
        explanation(load("solver discrete\nuse gravity 0,-2\nuse drag 1\nball a at=0,0\n"));
    CHECK(has(text, "model   gravity 0,-2\n        drag 1\n"));
    CHECK(has(text, "solver  discrete (chosen by you)\nauto    would choose "));
    const std::string heaps =
        "heaps   too dense for events, they go over to contact, and come back\n";
    const std::string falls = "use gravity 0,-2\nkind soft r=1 e=0.5\nball a at=0,0 kind=soft\n";
    CHECK(has(explanation(load("solver event\n" + falls)), heaps + "auto    "));
    CHECK_FALSE(has(explanation(load("solver contact\n" + falls)), heaps));
    CHECK_FALSE(has(explanation(load("solver event\nuse gravity 0,-2\nball a at=0,0\n")), heaps));
}

TEST_CASE("report: balls that are too small for the solver are noted") {
    struct Row {
        const char* solver;
        const char* small;
        const char* held;
    };
    // 10 / 100^2 = 1e-3 over 1,024, 670,000 and 1.6e12
    const Row rows[] = {{"contact", "9.7e-7", "9.8e-7"},
                        {"swept", "1.4e-9", "1.6e-9"},
                        {"event", "6.3e-16", "6.5e-16"}};
    for (const Row& row : rows) {
        CAPTURE(std::string(row.solver));
        const auto with = [&](const std::string& radius) {
            return run("rate 100\nuse gravity 0,-10\nball at=0,0 r=" + radius +
                           "\nball at=5,5 r=1\nsolver " + row.solver + "\n",
                       3);
        };
        const Finished small = with(row.small);
        CHECK(small.record.notes.of(NoteKind::not_held).count == 3);
        CHECK(small.record.notes.of(NoteKind::not_held).first == 1);
        CHECK(small.record.notes.of(NoteKind::not_held).most.balls == 1);
        CHECK(has(small.report,
                  R"("kind": "not_held", "ticks": 3, "first_tick": 1, "most_balls": 1)"));
        CHECK(
            has(notes_text(small.record.notes, 100.0), "note: gravity moves small balls too far"));
        const Finished held = with(row.held);
        CHECK_FALSE(has(held.report, "not_held"));
        CHECK_FALSE(has(notes_text(held.record.notes, 100.0), "small balls"));
    }
}
