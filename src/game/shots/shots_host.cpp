#include <fmt/format.h>

#include <algorithm>

#include "game/pool/pool.h"
#include "game/pool/table_places.h"
#include "game/shots/shots.h"
#include "game/shots/shots_play.h"
#include "geometry/closest.h"

// What the rules ask of a game of shots, and do to it.
namespace carom {
namespace {

using What = RuleAction::What;
using Verdict = ShotsState::Verdict;

void respot(ShotsPlay& play, const RuleAction& action) {
    const RuleBalls& balls = play.scene.rules.balls[action.index];
    const RulePlace* const place =
        action.place < 0 ? nullptr
                         : &play.scene.rules.places[static_cast<std::size_t>(action.place)];
    std::vector<std::uint32_t> meant;
    for (std::uint32_t ball = 0; ball < play.state.balls.size(); ++ball)
        if (play.is_meant(balls, ball)) meant.push_back(ball);
    // None of them is in the way of another.
    for (const std::uint32_t ball : meant)
        if (std::optional<BallId>& id = play.state.balls[ball]) {
            remove_ball(play.world, *id);
            id.reset();
        }
    for (const std::uint32_t ball : meant) {
        if (!place) {
            put(play, ball, start_of(play.scene, ball));
            continue;
        }
        const Capsule& shape = play.world.zones()[place->zones.front()].shape;
        put(play, ball, (shape.start + shape.end) * 0.5);
    }
}

// Balls leave the table: all of them, or those inside or outside of a place.
void remove(ShotsPlay& play, const RuleAction& action) {
    const RuleBalls& balls = play.scene.rules.balls[action.index];
    for (std::uint32_t ball = 0; ball < play.state.balls.size(); ++ball) {
        std::optional<BallId>& id = play.state.balls[ball];
        if (!id || !play.is_meant(balls, ball)) continue;
        const bool is_kept =
            action.place >= 0 &&
            play.lies_in(play.scene.rules.places[static_cast<std::size_t>(action.place)], ball) ==
                action.is_outside;
        if (is_kept) continue;
        remove_ball(play.world, *id);
        id.reset();
    }
}

void say(ShotsPlay& play, const std::string& text, bool is_foul) {
    ShotsState& state = play.state;
    if (!state.message.empty()) state.message += "; ";
    state.message += text;
    state.is_foul = state.is_foul || is_foul;
}

}  // namespace

bool is_among(const Scene& scene, const ShotsState& state, const RuleBalls& balls,
              std::uint32_t ball) {
    const auto cue_of_player = [&](std::uint32_t player) {
        const std::vector<Cue>& cues = scene.pool.cues;
        return std::ranges::count(cues[player % cues.size()].balls, scene.world.balls().id[ball]) >
               0;
    };
    switch (balls.who) {
        case RuleBalls::Who::any:
            return true;
        case RuleBalls::Who::cue:
            return cue_of(scene, state) == ball;
        case RuleBalls::Who::it:
            return false;  // ShotsAnswers::is_meant knows it
        case RuleBalls::Who::opponent:
            return cue_of_player((state.rules.player + 1) % scene.rules.players) &&
                   !cue_of_player(state.rules.player);
        case RuleBalls::Who::listed:
            break;
    }
    return std::ranges::binary_search(balls.balls, scene.world.balls().id[ball]);
}

std::optional<std::uint32_t> number_of(const ShotsState& state, BallId ball) {
    const auto found = std::ranges::find(state.balls, std::optional(ball));
    if (found == state.balls.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - state.balls.begin());
}

Vec2 start_of(const Scene& scene, std::uint32_t ball) {
    return scene.world.balls().position[ball];
}

void put(ShotsPlay& play, std::uint32_t ball, Vec2 place) {
    std::optional<BallId>& id = play.state.balls[ball];
    if (id) remove_ball(play.world, *id);
    const double radius = play.scene.world.balls().radius[ball];
    const Vec2 free = free_place(play.world, place, {1.0, 0.0}, radius);
    id = add_ball(play.world, spec_at_rest(play.scene.world, ball, free));
}

std::int64_t ShotsAnswers::quantity(RuleQuantity what) const {
    const ShotsState::Player& player = state_.players[state_.rules.player];
    switch (what) {
        case RuleQuantity::score:
            return player.score;
        case RuleQuantity::player:
            return std::int64_t{state_.rules.player} + 1;
        case RuleQuantity::players:
            return std::ssize(state_.players);
        case RuleQuantity::innings:
            return player.innings;
        case RuleQuantity::shots:
            return player.shots;
        case RuleQuantity::fouls:
            return player.fouls;
        case RuleQuantity::best:
            return std::ranges::max(state_.players, {}, &ShotsState::Player::score).score;
        case RuleQuantity::rest:
            return is_at_rest(world_) ? 1 : 0;
        default:
            return 0;
    }
}

bool ShotsAnswers::is_meant(const RuleBalls& balls, std::uint32_t ball) const {
    return balls.who == RuleBalls::Who::it ? it == ball : is_among(scene_, state_, balls, ball);
}

bool ShotsAnswers::lies_in(const RulePlace& place, std::uint32_t ball) const {
    const auto index = state_.balls[ball] ? index_of(world_, *state_.balls[ball]) : std::nullopt;
    return index && std::ranges::any_of(place.zones, [&](std::uint32_t zone) {
               return is_inside(world_.zones()[zone].shape, world_.balls().position[*index]);
           });
}

std::int64_t ShotsAnswers::count(const RuleBalls& balls, const RulePlace* place) const {
    std::int64_t there = 0;
    for (std::uint32_t ball = 0; ball < state_.balls.size(); ++ball)
        if (state_.balls[ball] && is_meant(balls, ball) && (!place || lies_in(*place, ball)))
            ++there;
    return there;
}

void ShotsPlay::act(const RuleAction& action, std::int64_t value, int) {
    ShotsState::Player& player = state.players[state.rules.player];
    const auto text = [&] { return text_of(scene.rules, state.rules, *this, action.text); };
    switch (action.what) {
        case What::score:
            player.score = saturating_sum(player.score, value);
            break;
        case What::message:
            say(*this, text(), false);
            break;
        case What::foul:
            ++player.fouls;
            say(*this, "foul: " + text(), true);
            break;
        case What::turn:
            state.verdict = std::max(state.verdict, Verdict::turn);
            break;
        case What::win:
            state.verdict = std::max(state.verdict, Verdict::win);
            break;
        case What::lose:
            state.verdict = std::max(state.verdict, Verdict::lose);
            break;
        case What::end:
            state.verdict = std::max(state.verdict, Verdict::end);
            break;
        case What::respot:
            respot(*this, action);
            break;
        case What::remove:
            remove(*this, action);
            break;
        case What::look:
            state.look = action.place;
            break;
        case What::inhand:
            state.is_in_hand = true;
            state.hand_place = action.place;
            break;
        case What::start_motion:
        case What::stop_motion:
            world.edit_movers()[action.index].runs = action.what == What::start_motion;
            break;
        default:
            break;  // actions of other games, which the loader refuses
    }
}

}  // namespace carom
