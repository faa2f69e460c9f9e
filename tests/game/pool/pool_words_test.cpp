#include "game/pool/pool_words.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "game/referees/referee.h"
#include "game/support/shipped.h"

using namespace carom;

namespace {

/// A game after its referee has judged the shot of the player in turn.
PoolPlay after(PoolState state, const PoolShot& shot, const PoolCall& call = {}) {
    const PoolRuling ruling = judge(state, call, shot);
    PoolPlay play;
    play.rules = ruling.next;
    play.shot = shot;
    play.called = call;
    play.shooter = state.player;
    play.last_foul = ruling.foul;
    play.last_penalty = ruling.penalty;
    return play;
}

std::string told(const PoolPlay& play) {
    return outcome_text(play, {"player 1", "player 2"});
}

PoolState rack(std::string_view game) {
    return begin_rack(*referee_of(game), 0);
}

/// 8-ball: player 1 has the solids, of which these are left.
PoolState solids_left(const std::vector<int>& balls) {
    PoolState state = rack("eightball");
    state.phase = PoolPhase::playing;
    state.in_hand = CueInHand::no;
    state.group = PoolGroup::solids;
    state.down = 0xfe;
    for (const int ball : balls)
        state.down &= ~(1u << ball);
    return state;
}

constexpr PoolCall eight_in_pocket_2{PoolCall::Kind::pot, 8, 2};

}  // namespace

TEST_CASE("a break that leaves a choice says why") {
    PoolShot weak{.first_hit = 1, .rail_after_hit = true, .railed = 1u << 5};
    CHECK(told(after(rack("eightball"), weak)) ==
          "Weak break: fewer than four balls hit a cushion. Player 2 chooses.");
    weak.pocketed = {{cue_ball, 0}};
    CHECK(told(after(rack("eightball"), weak)) ==
          "Foul: the cue ball fell. Weak break: fewer than four balls hit a cushion. "
          "Player 2 chooses.");
    const PoolShot eight{.first_hit = 1, .pocketed = {{8, 3}}};
    CHECK(told(after(rack("eightball"), eight)) ==
          "Pocketed: 8. The 8 fell on the break. Player 1 chooses.");
}

TEST_CASE("a player who loses on the 8 reads why") {
    const PoolShot eight{.first_hit = 8, .pocketed = {{8, 3}}};
    CHECK(told(after(solids_left({}), eight, eight_in_pocket_2)) ==
          "Pocketed: 8. The 8 fell, but not as called. Player 2 wins the frame.");
    const PoolShot early{.first_hit = 3, .pocketed = {{8, 2}}};
    CHECK(told(after(solids_left({3}), early)) ==
          "Pocketed: 8. The 8 fell too early. Player 2 wins the frame.");
    // The last solid and the 8 in one shot: the 8 was not on when the player shot.
    const PoolShot both{.first_hit = 3, .pocketed = {{3, 1}, {8, 2}}};
    CHECK(told(after(solids_left({3}), both)) ==
          "Pocketed: 3, 8. The 8 fell too early. Player 2 wins the frame.");
    const PoolShot scratch{.first_hit = 8, .pocketed = {{8, 2}, {cue_ball, 0}}};
    CHECK(told(after(solids_left({}), scratch, eight_in_pocket_2)) ==
          "Pocketed: 8. Foul: the cue ball fell. Player 2 wins the frame.");
    const PoolShot won{.first_hit = 8, .pocketed = {{8, 2}}};
    CHECK(told(after(solids_left({}), won, eight_in_pocket_2)) ==
          "Pocketed: 8. Player 1 wins the frame.");
}

TEST_CASE("after a push-out, or a pot that was not called, the choice says so") {
    for (const std::string_view game : {"nineball", "tenball"}) {
        CAPTURE(game);
        PoolState state = rack(game);
        state.phase = PoolPhase::playing;
        state.in_hand = CueInHand::no;
        state.may_push_out = true;
        CHECK(told(after(state, {}, {PoolCall::Kind::push_out})) ==
              "A push-out. Player 2 chooses.");
    }
    PoolState state = rack("tenball");
    state.phase = PoolPhase::playing;
    state.in_hand = CueInHand::no;
    const PoolShot lucky{.first_hit = 1, .pocketed = {{4, 0}}};
    CHECK(told(after(state, lucky, {PoolCall::Kind::pot, 1, 0})) ==
          "Pocketed: 4. Not a called pot. Player 2 chooses.");
}

// A choice that the opponent made at once replaced the foul by "No ball fell".
TEST_CASE("after a choice the words tell the foul, and what was chosen") {
    const Scene scene = test::shipped_level("snooker");
    const PoolShot pink{.first_hit = 20, .rail_after_hit = true};
    // The miss is announced, for the balls may be put back after it.
    const auto chosen = [&](PoolChoice choice) {
        World world = scene.world;
        PoolPlay play = *begin_pool(scene);
        const PoolPlay fouled = after(play.rules, pink);
        play.rules = fouled.rules;
        play.shot = fouled.shot;
        play.shooter = 0;
        play.last_foul = fouled.last_foul;
        play.last_penalty = fouled.last_penalty;
        REQUIRE(told(play) ==
                "Foul and a miss, 6: the wrong ball was hit first. Player 2 chooses.");
        make_choice(scene, world, play, choice);
        return told(play);
    };
    CHECK(chosen(PoolChoice::take_table) ==
          "Foul and a miss, 6: the wrong ball was hit first. Player 2 shoots from here.");
    CHECK(chosen(PoolChoice::return_push) ==
          "Foul and a miss, 6: the wrong ball was hit first. Player 1 shoots again.");
    CHECK(chosen(PoolChoice::replace) ==
          "Foul and a miss, 6: the wrong ball was hit first. The balls are put back. "
          "Player 1 shoots again.");
}

// "Shoot from here" was offered with the cue ball in hand, and who had not broken broke "again".
TEST_CASE("after a scratch on the break the choice is of ball in hand, or a first break") {
    const Scene scene = test::shipped_level("eight-ball");
    const PoolShot scratch{.pocketed = {{cue_ball, 0}}};
    const auto chosen = [&](PoolChoice choice) {
        World world = scene.world;
        PoolPlay play = *begin_pool(scene);
        const PoolPlay fouled = after(play.rules, scratch);
        play.rules = fouled.rules;
        play.shot = fouled.shot;
        play.shooter = 0;
        play.last_foul = fouled.last_foul;
        CHECK(choice_text(play.rules, PoolChoice::take_table) == "take ball in hand");
        make_choice(scene, world, play, choice);
        return told(play);
    };
    CHECK(chosen(PoolChoice::take_table) == "Foul: the cue ball fell. Player 2: ball in hand.");
    CHECK(chosen(PoolChoice::break_again) == "Foul: the cue ball fell. Player 2 breaks.");
    CHECK(chosen(PoolChoice::let_break) == "Foul: the cue ball fell. Player 1 breaks again.");
}

TEST_CASE("all choices of a game fit into the last line of 80 columns") {
    using enum PoolChoice;
    for (const std::vector<PoolChoice>& choices : {std::vector{take_table, return_push, replace},
                                                   {take_table, break_again, let_break},
                                                   {spot_eight, break_again},
                                                   {take_table, let_break}}) {
        std::string line;
        PoolState in_hand;
        in_hand.in_hand = CueInHand::behind_head_string;
        for (const PoolChoice choice : choices)
            line += " 1 " + std::string(choice_text(in_hand, choice)) + " ";
        CHECK(line.size() + std::string("? keys").size() <= 78);
    }
}

TEST_CASE("a ball that falls without being called passes the turn, and the message says so") {
    const PoolShot lucky{.first_hit = 1, .pocketed = {{4, 0}}};
    const PoolCall other{PoolCall::Kind::pot, 1, 0};
    CHECK(told(after(solids_left({1, 4}), lucky, other)) ==
          "Pocketed: 4. Not a called pot. Player 2 shoots.");
    CHECK(told(after(solids_left({1, 4}), lucky, {PoolCall::Kind::pot, 4, 0})) ==
          "Pocketed: 4. Player 1 continues.");
    CHECK(told(after(solids_left({1, 4}), lucky, {PoolCall::Kind::pot, 4, 3})) ==
          "Pocketed: 4. Another pocket was called. Player 2 shoots.");
    CHECK(told(after(solids_left({1, 4}), lucky, {PoolCall::Kind::safety})) ==
          "Pocketed: 4. A safety was called. Player 2 shoots.");
    const PoolShot scratch{.first_hit = 1, .pocketed = {{4, 0}, {cue_ball, 1}}};
    CHECK(told(after(solids_left({1, 4}), scratch, other)) ==
          "Pocketed: 4. Foul: the cue ball fell. Player 2: ball in hand.");
    PoolState state = rack("straightpool");
    state.phase = PoolPhase::playing;
    state.in_hand = CueInHand::no;
    CHECK(told(after(state, lucky, other)) == "Pocketed: 4. Not a called pot. Player 2 shoots.");
}

TEST_CASE("a turn that passes without a foul says that no ball fell") {
    const PoolShot miss{.first_hit = 1, .rail_after_hit = true};
    CHECK(told(after(solids_left({1, 4}), miss)) == "No ball fell. Player 2 shoots.");
}

TEST_CASE("the ruling names the third foul in a row in straight pool") {
    PoolState state = rack("straightpool");
    state.phase = PoolPhase::playing;
    state.in_hand = CueInHand::no;
    state.fouls = {1, 0};
    CHECK(told(after(state, {})) ==
          "Foul, 1: no ball was hit. Player 1: the next foul costs 16. Player 2 shoots.");
    state.fouls = {2, 0};
    CHECK(told(after(state, {})) ==
          "Foul, 16: no ball was hit. 3 fouls in a row. Player 1 breaks again.");
}

TEST_CASE("a frame lost by fouls in a row says how many they were") {
    PoolState state = rack("nineball");
    state.phase = PoolPhase::playing;
    state.in_hand = CueInHand::no;
    state.fouls = {1, 0};
    CHECK(told(after(state, {})) ==
          "Foul: no ball was hit. Player 1: the next foul loses. Player 2: ball in hand.");
    state.fouls = {2, 0};
    CHECK(told(after(state, {})) ==
          "Foul: no ball was hit. 3 fouls in a row. Player 2 wins the frame.");
}

TEST_CASE("one-pocket names the player's pocket as a shot names it") {
    const Scene scene = test::shipped_level("one-pocket");
    PoolPlay play = *begin_pool(scene);
    play.rules.phase = PoolPhase::playing;
    play.rules.in_hand = CueInHand::no;
    const auto turn_of = [&](int player) {
        play.rules.player = player;
        return turn_text(scene, play, {"you", "carom"});
    };
    // The breaker has the pocket on the right, as seen from the head of the table.
    CHECK(turn_of(play.rules.breaker) == "you (0:0), 8 to go in the bottom right: to shoot");
    CHECK(turn_of(1 - play.rules.breaker) == "carom (0:0), 8 to go in the top right: to shoot");
}
