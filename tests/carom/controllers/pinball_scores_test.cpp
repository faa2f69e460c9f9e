#include "carom/controllers/pinball_scores.h"

#include <doctest/doctest.h>

#include <string_view>

using namespace carom;

namespace {

PinballState game_over(std::initializer_list<std::int64_t> scores) {
    PinballState state;
    state.phase = PinballState::Phase::over;
    state.games = 1;
    state.players = static_cast<std::uint32_t>(scores.size());
    state.rules.player = 0;
    state.score = *scores.begin();
    for (const std::int64_t score : scores) {
        state.parked.emplace_back();
        state.parked.back().score = score;
    }
    if (scores.size() == 1) state.parked.clear();
    return state;
}

void type(PinballScores& scores, std::u32string_view keys) {
    for (const char32_t key : keys) {
        InputEvent event;
        event.key = key;
        scores.type(event);
    }
}

}  // namespace

TEST_CASE("initials: every player who makes the list is asked, the best first") {
    PinballScores scores;
    scores.set({.lines = {{"OLD", 500}}, .most = 3});
    scores.follow(game_over({100, 900, 300, 50}), false, false);
    REQUIRE(scores.initials());
    CHECK(scores.player() == 2);
    type(scores, U"bob");
    type(scores, {&key::enter, 1});
    CHECK(scores.take() == HighScore{"BOB", 900});
    REQUIRE(scores.initials());
    CHECK(scores.player() == 3);
    // Whoever does not want to is passed over, and makes room for the next.
    type(scores, {&key::escape, 1});
    REQUIRE(scores.initials());
    CHECK(scores.player() == 1);
    type(scores, U"al");
    type(scores, {&key::enter, 1});
    CHECK(scores.take() == HighScore{"AL-", 100});
    // The list is full of better scores now.
    CHECK_FALSE(scores.initials());
    CHECK(scores.scores().lines.size() == 3);
}

TEST_CASE("initials: one player has no number, and a game of the demo asks nobody") {
    PinballScores scores;
    scores.follow(game_over({100}), false, false);
    REQUIRE(scores.initials());
    CHECK(scores.player() == 0);
    PinballScores demo;
    demo.follow(game_over({100, 200}), true, false);
    CHECK_FALSE(demo.initials());
}

TEST_CASE("initials: a minute after the last key, what has been typed counts") {
    PinballScores scores;
    scores.follow(game_over({100, 200}), false, false);
    CHECK_FALSE(scores.pass(59.0));
    type(scores, U"al");
    CHECK_FALSE(scores.pass(59.0));
    REQUIRE(scores.initials() == "AL");
    CHECK(scores.pass(2.0));
    CHECK(scores.take() == HighScore{"AL-", 200});
    // The next player has a minute too.
    CHECK(scores.player() == 1);
    CHECK_FALSE(scores.pass(59.0));
    CHECK(scores.pass(2.0));
    CHECK(scores.take() == HighScore{"---", 100});
    CHECK_FALSE(scores.initials());
    CHECK_FALSE(scores.pass(100.0));
}
