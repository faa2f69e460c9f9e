#include "carom/options/options.h"

#include <doctest/doctest.h>

#include <variant>
#include <vector>

using namespace carom;

namespace {

Request parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "carom");
    return parse_options(static_cast<int>(arguments.size()), arguments.data());
}

template <class Options>
Options parse_as(const std::vector<const char*>& arguments) {
    const Request request = parse(arguments);
    REQUIRE(std::holds_alternative<Options>(request));
    return std::get<Options>(request);
}

}  // namespace

TEST_CASE("no command, or play without a level, opens the menu") {
    for (const std::vector<const char*>& arguments :
         {std::vector<const char*>{}, std::vector<const char*>{"play"}}) {
        const PlayOptions options = parse_as<PlayOptions>(arguments);
        CHECK(options.level.empty());
        CHECK_FALSE(options.solver.has_value());
        CHECK_FALSE(options.renderer.has_value());
        CHECK_FALSE(options.mouse.has_value());
        CHECK(options.rewind_bytes == std::size_t{64} << 20);
    }
}

TEST_CASE("the options of play") {
    const auto options = parse_as<PlayOptions>({"play",
                                                "gas",
                                                "--solver=substep",
                                                "--rate",
                                                "240",
                                                "--seed",
                                                "18446744073709551615",
                                                "--set",
                                                "use gravity 0,-1",
                                                "--set",
                                                "let n=3",
                                                "--renderer",
                                                "half",
                                                "--colors",
                                                "16",
                                                "--fps",
                                                "30",
                                                "--no-mouse",
                                                "--low-bandwidth",
                                                "--watch",
                                                "--paused",
                                                "--resume",
                                                "--opponent",
                                                "3",
                                                "--rewind",
                                                "0.5"});
    CHECK(options.level == "gas");
    CHECK(options.solver->kind == SolverKind::substep);
    CHECK(*options.rate == 240.0);
    CHECK(*options.seed == 18446744073709551615u);
    CHECK(options.overrides == std::vector<std::string>{"use gravity 0,-1", "let n=3"});
    CHECK(*options.renderer == &half_block_renderer());
    CHECK(*options.colors == ColorChoice::c16);
    CHECK(*options.fps == 30.0);
    CHECK(*options.mouse == false);
    CHECK(options.low_bandwidth);
    CHECK(options.watch);
    CHECK(options.paused);
    CHECK(options.resume);
    CHECK(options.opponent == 3);
    CHECK(options.rewind_bytes == std::size_t{1} << 19);
}

TEST_CASE("the options of run, before and after the level") {
    const auto options = parse_as<RunOptions>({"run", "--time", "2.5", "pi", "--report", "-",
                                               "--events=e.jsonl", "--log", "l.txt", "--trace",
                                               "t.csv", "--explain", "--solver", "auto"});
    CHECK(options.level == "pi");
    CHECK(*options.time == 2.5);
    CHECK_FALSE(options.ticks.has_value());
    CHECK(options.report == "-");
    CHECK(options.events == "e.jsonl");
    CHECK(options.log == "l.txt");
    CHECK(options.trace == "t.csv");
    CHECK(options.explain);
    CHECK_FALSE(options.solver.has_value());
}

TEST_CASE("check takes several levels, and statements") {
    const auto options = parse_as<CheckOptions>({"check", "a", "b", "--set", "seed 3", "c"});
    CHECK(options.levels == std::vector<std::string>{"a", "b", "c"});
    CHECK(options.overrides == std::vector<std::string>{"seed 3"});
}

TEST_CASE("an error is an answer, and the first one counts") {
    const auto answer = parse_as<UsageAnswer>({"run", "pi", "--rate", "fast", "--seed", "slow"});
    CHECK(answer.exit_code == 2);
    CHECK(answer.text.find("--rate") != std::string::npos);
    CHECK(answer.text.find("--seed") == std::string::npos);
}

TEST_CASE("recordings are made, watched and verified") {
    CHECK(parse_as<PlayOptions>({"play", "gas", "--record", "a.replay"}).record == "a.replay");
    CHECK(parse_as<RunOptions>({"run", "gas", "--record", "a.replay"}).record == "a.replay");
    CHECK(parse_as<VerifyOptions>({"verify", "a.replay"}).file == "a.replay");
    const auto watch = parse_as<PlayOptions>({"replay", "a.replay", "--paused", "--fps", "30"});
    CHECK(watch.replay == "a.replay");
    CHECK(watch.level.empty());
    CHECK(watch.paused);
    CHECK(watch.fps == 30.0);
    // It would be unclear which game.
    CHECK(parse_as<UsageAnswer>({"play", "--record", "a.replay"}).exit_code == 2);
    CHECK(parse_as<PlayOptions>({"play", "--resume", "--record", "a"}).record == "a");
    CHECK(parse_as<PlayOptions>({"play", "--cast", "a.cast"}).cast == "a.cast");
    CHECK(parse_as<PlayOptions>({"replay", "a.replay", "--cast", "a.cast"}).cast == "a.cast");
    CHECK(parse_as<UsageAnswer>({"verify"}).exit_code == 2);
    CHECK(parse_as<UsageAnswer>({"replay", "a", "--solver", "swept"}).exit_code == 2);
}
