#include "carom/play/challenge.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "carom/files/high_scores.h"
#include "carom/pool/record_page.h"
#include "carom/support/home.h"
#include "terminal/canvas/character_width.h"

using namespace carom;
using carom::test::Home;

namespace {

const std::vector<LevelEntry> shipped{{"eight-ball", "/l/eight-ball.level", "8-ball"},
                                      {"nine-ball", "/l/nine-ball.level", "9-ball"},
                                      {"shot-of-the-day", "/l/shot-of-the-day.level", "Shot"},
                                      {"ten-ball", "/l/ten-ball.level", "10-ball"}};

const Challenge& called(const std::vector<Challenge>& all, std::string_view title) {
    const auto found = std::ranges::find_if(
        all, [&](const Challenge& one) { return one.title.find(title) != std::string::npos; });
    REQUIRE(found != all.end());
    return *found;
}

PoolRecord after_beating(int rungs) {
    PoolRecord record;
    record.shots = 20;
    for (int rung = 0; rung < rungs; ++rung)
        record.matches[static_cast<std::size_t>(ladder()[static_cast<std::size_t>(rung)].opponent -
                                                1)] = {1, 2};
    return record;
}

}  // namespace

TEST_CASE("the ladder is climbed rung by rung") {
    const Home home;
    std::vector<Challenge> all = challenges(shipped, {}, 20260131);
    CHECK(called(all, "Nell").badge == "next");
    CHECK(called(all, "Nell").obstacle.empty());
    CHECK(called(all, "Bo").badge == "locked");
    CHECK(called(all, "Bo").obstacle == "Bo plays you once you have beaten Nell.");
    all = challenges(shipped, after_beating(2), 20260131);
    CHECK(called(all, "Nell").badge == "beaten");
    CHECK(called(all, "Nell").goal == "Win the match: 8-ball to 2. So far 1:2.");
    CHECK(called(all, "Ida").badge == "next");
    CHECK(called(all, "Ida").amendments == std::vector<std::string>{"game eightball race=3"});
    CHECK(called(all, "Viv").badge == "locked");
    CHECK(climb_text(after_beating(2)) == "Bo is beaten. Next on the ladder: Ida, 8-ball to 3.");
    CHECK(climb_text(after_beating(7)) == "Viv is beaten, and nobody is left on the ladder.");
    CHECK(next_challenge(after_beating(7)).empty());
    CHECK(next_challenge(after_beating(1)) == called(all, "Bo").name);
    // A rung above one that is not beaten does not count.
    PoolRecord odd;
    odd.matches[static_cast<std::size_t>(ladder()[3].opponent - 1)] = {1, 0};
    CHECK(rungs_climbed(odd) == 0);
}

TEST_CASE("the shot of the day keeps its stars by the date") {
    const Home home;
    CHECK(called(challenges(shipped, {}, 20260131), "day").badge == "new");
    CHECK(called(challenges(shipped, {}, 20260131), "day").line.find("2026-01-31") == 0);
    CHECK_FALSE(keep_stars(daily_name(20260131), 2));
    CHECK(called(challenges(shipped, {}, 20260131), "day").badge == "**.");
    CHECK(called(challenges(shipped, {}, 20260201), "day").badge == "new");
    CHECK(today() > 20200101);
}

TEST_CASE("challenges are there only with their levels") {
    const Home home;
    CHECK(challenges({}, {}, 20260131).empty());
}

TEST_CASE("the record fits into 80 columns, also when much was played") {
    PoolRecord record = after_beating(7);
    record.attempts = 123'456;
    record.made = 100'000;
    record.pots = 101'000;
    record.shots = 130'000;
    record.turns = 40'000;
    record.best_run = 15;
    record.seconds = 1'560'000.0;
    record.frames[1] = {1000, 999};
    const std::vector<std::string> lines = record_lines(record, {});
    bool says_pots = false;
    for (const std::string& line : lines) {
        CHECK(columns_of(line) < 78);
        says_pots = says_pots || line.find("81 %") != std::string::npos;
    }
    CHECK(says_pots);
    CHECK(lines.size() <= 22);
    CHECK(record_lines({}, {}).front().find("No shot") == 0);
}
