#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "carom/options/options.h"
#include "carom/support/process.h"

using namespace carom;
using namespace carom::test;

namespace {

const char* const crowd =
    "carom 1 \"Crowd\"\n"
    "rate 60\n"
    "kind disc r=1\n"
    "box 0,0 20,20\n"
    "fill disc count=20 box=0,0,20,20 speed=10\n";

Request parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "carom");
    return parse_options(static_cast<int>(arguments.size()), arguments.data());
}

// The lines that do not depend on the clock.
std::string without_cost(const std::string& json) {
    std::string kept;
    std::size_t from = 0;
    while (from < json.size()) {
        const std::size_t end = json.find('\n', from) + 1;
        const std::string line = json.substr(from, end - from);
        if (!has(line, "\"cost\": ")) kept += line;
        from = end;
    }
    return kept;
}

}  // namespace

TEST_CASE("the options of measure") {
    const Request request =
        parse({"measure",   "gas",     "--time",      "0.5",       "--repeats",
               "7",         "--rates", "60,120.5",    "--solvers", "swept,discrete",
               "--horizon", "0.25",    "--tolerance", "1e-6",      "--budget",
               "500us",     "--rate",  "90",          "--seed",    "3",
               "--csv",     "a",       "--json",      "-"});
    REQUIRE(std::holds_alternative<MeasureOptions>(request));
    const auto& options = std::get<MeasureOptions>(request);
    CHECK(options.level == "gas");
    CHECK(options.time == 0.5);
    CHECK(options.repeats == 7);
    CHECK(options.rates == std::vector<double>{60, 120.5});
    CHECK(options.solvers == std::vector{SolverKind::swept, SolverKind::discrete});
    CHECK(options.horizon == 0.25);
    CHECK(options.tolerance == 1e-6);
    CHECK(*options.budget == doctest::Approx(5e-4));
    CHECK(options.rate == 90.0);
    CHECK(options.seed == 3u);
    CHECK(options.csv == "a");
    CHECK(options.json == "-");
}

TEST_CASE("a budget has a unit") {
    struct Row {
        const char* text;
        double seconds;
    };
    for (const Row& row : {Row{"2ms", 2e-3}, Row{"0.5us", 5e-7}, Row{"80ns", 8e-8}, Row{"1s", 1}}) {
        const Request request = parse({"measure", "gas", "--budget", row.text});
        REQUIRE(std::holds_alternative<MeasureOptions>(request));
        CHECK(*std::get<MeasureOptions>(request).budget == doctest::Approx(row.seconds));
    }
}

TEST_CASE("the options of compare") {
    const Request request = parse({"compare", "gas", "--solvers", "swept,discrete@480", "--time",
                                   "3", "--tolerance", "0.1", "--nudge", "1e-9", "--json", "x"});
    REQUIRE(std::holds_alternative<CompareOptions>(request));
    const auto& options = std::get<CompareOptions>(request);
    REQUIRE(options.solvers.size() == 2);
    CHECK(options.solvers[0].kind == SolverKind::swept);
    CHECK_FALSE(options.solvers[0].rate.has_value());
    CHECK(options.solvers[1].kind == SolverKind::discrete);
    CHECK(options.solvers[1].rate == 480.0);
    CHECK(options.time == 3.0);
    CHECK(options.tolerance == 0.1);
    CHECK(options.nudge == 1e-9);
    CHECK(options.json == "x");
}

TEST_CASE("invalid options of measure and compare are reported") {
    struct Row {
        std::vector<const char*> arguments;
        std::string message;
    };
    const Row rows[] = {
        {{"measure"}, "LEVEL is required"},
        {{"measure", "gas", "--budget", "2"}, "such as 2ms or 500us, but is '2'"},
        {{"measure", "gas", "--budget", "-1ms"}, "but is '-1ms'"},
        {{"measure", "gas", "--budget", "ms"}, "but is 'ms'"},
        {{"measure", "gas", "--budget", "infs"}, "but is 'infs'"},
        {{"measure", "gas", "--tolerance", "0"}, "--tolerance must be a number from 1e-15"},
        {{"measure", "gas", "--time", "0"}, "--time must be a number from 1e-06"},
        {{"measure", "gas", "--repeats", "0"},
         "--repeats must be a whole number from 1 to 1000, but is '0'"},
        {{"measure", "gas", "--repeats", "2.5"}, "--repeats must be a whole number"},
        {{"measure", "gas", "--rates", "60,,5"}, "--rates must be numbers with commas between"},
        {{"measure", "gas", "--rates", "60,x"}, "--rates must be a number from 0.001"},
        {{"measure", "gas", "--solvers", "swept,evnt"}, "there is no solver 'evnt'"},
        {{"measure", "gas", "--solvers", "swept@60"}, "rates: they come from --rates"},
        {{"measure", "gas", "--solver", "swept"}, "did you mean '--solvers'?"},
        {{"compare", "gas"}, "--solvers is required"},
        {{"compare", "gas", "--solvers", "swept"}, "--solvers must name two"},
        {{"compare", "gas", "--solvers", "swept,swept,swept"}, "--solvers must name two"},
        {{"compare", "gas", "--solvers", "swept,discrete@"}, "a rate must follow the @"},
        {{"compare", "gas", "--solvers", "swept,discrete@x"}, "the rate after @ must be a number"},
        {{"compare", "gas", "--solvers", "swept,swept", "--nudge", "-1"}, "--nudge must be"},
        {{"mesure", "gas"}, "did you mean 'measure'?"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.message);
        const Request request = parse(row.arguments);
        REQUIRE(std::holds_alternative<UsageAnswer>(request));
        CHECK(std::get<UsageAnswer>(request).exit_code == 2);
        CAPTURE(std::get<UsageAnswer>(request).text);
        CHECK(has(std::get<UsageAnswer>(request).text, row.message));
    }
}

TEST_CASE("measure prints tables, or writes files, and all but the cost is reproducible") {
    const TemporaryFolder folder;
    const std::string level = folder.file("crowd.level", crowd);
    const std::vector<std::string> call{"measure",  level, "--time",      "0.3",
                                        "--rates",  "60",  "--repeats",   "1",
                                        "--budget", "1s",  "--tolerance", "1e-6"};
    const Finished text = run_carom(call);
    CHECK(text.exit_code == 0);
    CHECK(text.err.empty());
    CHECK(text.out.starts_with("Crowd: 20 balls, 0.3 s at 60 ticks a second"));
    CHECK(has(text.out, "one run of each\n"));
    CHECK(has(text.out, "\nAs it is: "));
    CHECK(has(text.out, "\nWithin 1e+03 ms a tick: "));
    CHECK(has(text.out, "\nWithin 1e-06 radii: "));

    std::vector<std::string> to_files = call;
    to_files.insert(to_files.end(), {"--csv", folder.path("a.csv"), "--json", "-"});
    const Finished first = run_carom(to_files);
    CHECK(first.exit_code == 0);
    CHECK(first.out.starts_with("{\n  \"level\": "));
    CHECK(content(folder.path("a.csv")).starts_with("solver,"));
    const std::string kept = without_cost(first.out);
    CHECK(kept.size() < first.out.size());
    const std::size_t picks = kept.find("\"picks\"");
    CHECK(kept.substr(0, picks) == without_cost(run_carom(to_files).out).substr(0, picks));
}

TEST_CASE("measure takes a recording, so that a game can be judged") {
    const TemporaryFolder folder;
    const std::string level = folder.file("crowd.level", crowd);
    const std::string replay = folder.path("a.replay");
    const std::string script = folder.file("a.txt", "at 3 remove-ball 0\n");
    REQUIRE(run_carom({"run", level, "--ticks", "12", "--commands", script, "--record", replay})
                .exit_code == 0);
    const Finished measured = run_carom({"measure", replay, "--rates", "60", "--solvers",
                                         "swept,event", "--repeats", "1", "--json", "-"});
    CHECK(measured.exit_code == 0);
    CHECK(has(measured.out, "\"time\": 0.2,"));
    CHECK(has(measured.out, "\"refused\": 0,"));
    const Finished refused = run_carom({"measure", replay, "--rate", "90"});
    CHECK(refused.exit_code == 2);
    CHECK(has(refused.err, "is a recording, which leaves no choice of --rate"));
}

TEST_CASE("measure does not start if its output cannot be written") {
    const TemporaryFolder folder;
    const std::string level = folder.file("crowd.level", crowd);
    const Finished finished =
        run_carom({"measure", level, "--time", "1e6", "--csv", folder.path("no/such/folder")});
    CHECK(finished.exit_code == 2);
    CHECK(has(finished.err, "cannot write"));
    const Finished twice = run_carom({"measure", level, "--csv", "x", "--json", "x"});
    CHECK(twice.exit_code == 2);
    CHECK(has(twice.err, "two outputs cannot both go to 'x'"));
    CHECK(folder.names() == std::vector<std::string>{"crowd.level"});
}

TEST_CASE("compare answers with its exit code") {
    const TemporaryFolder folder;
    const std::string level = folder.file("crowd.level", crowd);
    const Finished same =
        run_carom({"compare", level, "--solvers", "swept,swept@120", "--time", "0.2"});
    CHECK(same.exit_code == 0);
    CHECK(has(same.out, "They do not part within 0.2 s"));
    const Finished parted = run_carom(
        {"compare", level, "--solvers", "swept,discrete", "--json", folder.path("parted.json")});
    CHECK(parted.exit_code == 1);
    CHECK(has(parted.out, "They part after "));
    CHECK(has(content(folder.path("parted.json")), "\"parting\": {\"time\": "));
    CHECK(run_carom({"compare", folder.path("none"), "--solvers", "swept,swept"}).exit_code == 2);
}
