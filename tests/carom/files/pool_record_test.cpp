#include "carom/files/pool_record.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <fstream>

#include "carom/pool/shot_tally.h"
#include "carom/support/home.h"

using namespace carom;
using carom::test::Home;

namespace {

PoolRecord some() {
    PoolRecord record{.shots = 12, .pots = 7, .safeties = 2, .fouls = 1, .best_run = 4};
    record.seconds = 120.0;
    record.frames[1] = {3, 1};
    record.frames[4] = {2, 1};
    record.matches[4] = {1, 0};
    record.attempts = 9;
    record.made = 5;
    record.turns = 4;
    record.breaks_and_runs = 1;
    return record;
}

PoolPlay at_the_table() {
    PoolPlay pool;
    pool.rules.phase = PoolPhase::playing;
    return pool;
}

/// A shot of the player: balls that fall, and whether the turn passes.
void shoot(ShotTally& tally, PoolPlay& pool, int player, std::vector<int> balls, bool passes,
           PoolFoul foul = PoolFoul::none) {
    pool.shooter = player;
    ++pool.shots;
    pool.is_shooting = true;
    tally.look(pool, 2);
    pool.is_shooting = false;
    pool.call = {};
    pool.shot = {};
    for (const int ball : balls)
        pool.shot.pocketed.push_back({ball, 0});
    pool.last_foul = foul;
    if (passes) pool.rules.player = 1 - player;
    tally.look(pool, 2);
}

}  // namespace

TEST_CASE("the record of pool is kept, and reads back") {
    const Home home;
    CHECK(load_pool_record().record == PoolRecord{});
    CHECK_FALSE(keep_pool_record(some()).problem);
    PoolRecord more{.shots = 1, .best_run = 2};
    const PoolRecordText kept = keep_pool_record(more);
    CHECK_FALSE(kept.problem);
    CHECK(kept.record.shots == 13);
    CHECK(kept.record.best_run == 4);
    CHECK(load_pool_record().record == kept.record);
    CHECK(read_pool_record(text_of(some()), "f").record == some());
}

TEST_CASE("a record of pool that is not understood is left alone") {
    for (const char* const text :
         {"something else\n", "carom pool record 1\nshots many\n",
          "carom pool record 1\nopponent 5 1 1\n", "carom pool record 1\nmatch nobody 1 1\n",
          "carom pool record 1\nshots -3\n"})
        CHECK(read_pool_record(text, "f").problem);
    CHECK(read_pool_record("carom pool record 1\nshots x\n", "f").problem->find("f:2") == 0);
}

TEST_CASE("shots of the person count, and those of carom do not") {
    ShotTally tally;
    PoolPlay pool = at_the_table();
    tally.look(pool, 2);
    tally.pass(6.0);
    shoot(tally, pool, 0, {3}, false);
    shoot(tally, pool, 0, {4, 5}, false);
    shoot(tally, pool, 0, {}, true);
    shoot(tally, pool, 1, {9, 10}, true);
    // The opponent's ball, or one that was not called: the turn passes.
    shoot(tally, pool, 0, {11}, true);
    shoot(tally, pool, 1, {}, true);
    pool.call.kind = PoolCall::Kind::safety;
    shoot(tally, pool, 0, {}, true);
    shoot(tally, pool, 1, {}, true);
    shoot(tally, pool, 0, {0, 6}, true, PoolFoul::scratch);
    CHECK_FALSE(tally.has_ended());
    pool.rules.phase = PoolPhase::over;
    pool.rules.winner = 1;
    tally.look(pool, 2);
    tally.look(pool, 2);
    CHECK(tally.has_ended());
    const PoolRecord record = tally.take();
    CHECK(record.shots == 6);
    CHECK(record.pots == 3);
    CHECK(record.best_run == 3);
    CHECK(record.safeties == 1);
    CHECK(record.fouls == 1);
    CHECK(record.seconds == 6.0);
    CHECK(record.frames[1] == PoolRecord::Results{0, 1});
    CHECK(record.matches[1] == PoolRecord::Results{});
    CHECK(record.attempts == 5);
    CHECK(record.made == 2);
    CHECK(record.turns == 4);
    CHECK(tally.take() == PoolRecord{});
}

// "Press r again to lose this frame and restart", and nothing was lost.
TEST_CASE("a frame or a match that is given up counts as lost") {
    PoolPlay pool = at_the_table();
    for (const std::uint32_t race : {0u, 3u}) {
        CAPTURE(race);
        ShotTally tally;
        pool.race = race;
        pool.shooter = 1;
        tally.look(pool, 2);
        tally.give_up(pool, 2);
        CHECK(tally.has_ended());
        CHECK(tally.since().frames[1] == PoolRecord::Results{0, 1});
        CHECK(tally.since().matches[1] == PoolRecord::Results{0, race > 0 ? 1u : 0u});
        tally.take();
        tally.give_up(pool, 0);
        CHECK(tally.since() == PoolRecord{});
        // Between two frames only the match is lost.
        pool.rules.phase = PoolPhase::over;
        tally.give_up(pool, 2);
        CHECK(tally.since().frames[1] == PoolRecord::Results{});
        CHECK(tally.since().matches[1] == PoolRecord::Results{0, race > 0 ? 1u : 0u});
        pool.rules.phase = PoolPhase::playing;
    }
}

TEST_CASE("a match, and a frame that is won from the break in one turn") {
    ShotTally tally;
    PoolPlay pool = at_the_table();
    pool.race = 1;
    pool.rules.phase = PoolPhase::breaking;
    tally.look(pool, 5);
    pool.shooter = 0;
    for (const int ball : {1, 9}) {
        ++pool.shots;
        pool.is_shooting = true;
        tally.look(pool, 5);
        pool.is_shooting = false;
        pool.shot = {};
        pool.shot.pocketed.push_back({ball, 0});
        pool.rules.phase = ball == 9 ? PoolPhase::over : PoolPhase::playing;
        if (ball == 9) {
            pool.rules.winner = 0;
            pool.frames[0] = 1;
        }
        tally.look(pool, 5);
    }
    const PoolRecord record = tally.take();
    CHECK(record.breaks_and_runs == 1);
    CHECK(record.attempts == 1);
    CHECK(record.made == 1);
    CHECK(record.frames[4] == PoolRecord::Results{1, 0});
    CHECK(record.matches[4] == PoolRecord::Results{1, 0});
    CHECK(rungs_climbed(record) == 1);
}

TEST_CASE("without an opponent nothing counts, nor does a shot that was under way before") {
    ShotTally tally;
    PoolPlay pool = at_the_table();
    pool.is_shooting = true;
    pool.shooter = 0;
    tally.look(pool, 2);
    tally.look(pool, 2);
    pool.is_shooting = false;
    tally.look(pool, 2);
    CHECK(tally.take() == PoolRecord{});
}
