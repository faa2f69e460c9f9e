#include <algorithm>
#include <cmath>
#include <utility>

#include "carom/controllers/pool_controller.h"

/// How a shot comes about: by a key or with the mouse; in a match by a stroke that may fail.
namespace carom {
namespace {

/// A shorter pull, in radii of the ball, does not shoot.
constexpr double least_pull = 1.5;

/// Different for each shot of a session: the draws of a stroke that may fail depend on it.
std::uint64_t shot_number(const Session& session) {
    if (const ShotsState* const shots = shots_of(session))
        return std::uint64_t{shots->games} << 32 | shots->shots;
    const PoolPlay* const pool = pool_of(session);
    return pool ? pool->shots : 0;
}

}  // namespace

// In a match the past is only looked at: a shot from there would take back what came after.
bool PoolController::is_striking(const PlayContext& play) const {
    const Session& session = play.session;
    return !play.page.is_open() && !players_.is_opponents_turn(session) && aim_.may_aim(session) &&
           !(players_.is_match(session) && session.world().tick() < session.latest());
}

void PoolController::look(PlayContext& play) {
    aim_.set_match(players_.is_match(play.session));
    aim_.look(play.session);
}

void PoolController::pass(PlayContext& play, double seconds) {
    aim_.set_match(players_.is_match(play.session));
    if (play.terminal.key_repeat) stroke_.remember(*play.terminal.key_repeat);
    if (stroke_.meter()) play.needs_draw = true;
    if (stroke_.meter() && !is_striking(play)) stroke_.end();
    if (!stroke_.pass(seconds)) say(play, "No stroke: too late.");
    if (aim_.work(play.session)) play.needs_draw = true;
    players_.pass(play, seconds);
    hear_coach(play);
}

// While the meter runs, a repeat of the key that started it does not strike.
bool PoolController::takes_key(PlayContext& play, const InputEvent& event) {
    using enum InputEvent::Action;
    if (event.action == release) return false;
    const bool repeats = play.terminal.tells_key_release ? event.action == repeat
                                                         : stroke_.repeats(event.key, event.after);
    if (!play.terminal.tells_key_release && stroke_.key_repeat())
        play.terminal.key_repeat = stroke_.key_repeat();
    return repeats && stroke_.meter();
}

void PoolController::point(PlayContext& play) {
    const bool pulls = play.pointer.tool.has_cue();
    if (!aims_by_mouse_ && !pulls) return;
    play.needs_draw = true;
    if (aims_by_mouse_) aim_.aim_at(play.session, play.pointer.at);
    if (!pulls) return;
    if (!players_.is_match(play.session)) {
        const Pull pull = pull_.value_or(Pull{});
        return aim_.pull(play.session, hand_at_cue(play, pull), pull.slack);
    }
    if (!is_striking(play)) return;
    MouseStroke* const push = stroke_.push();
    const auto stroke =
        push ? push->move(play.pointer.at, stroke_.time(after_)) : std::optional<Stroke>{};
    if (!stroke) return;
    play.pointer.tool.forget();
    shoot(play, stroke);
}

void PoolController::start_push(PlayContext& play) {
    const Session& session = play.session;
    const Camera& camera = play.view.camera;
    const Vec2 velocity = aim_.strike(session).velocity;
    const Vec2 way = velocity / length(velocity);
    const Vec2 cell = to_world(camera, {1.0, 1.0}) - to_world(camera, {0.0, 0.0});
    const double grain = 0.5 * (std::abs(way.x * cell.y) + std::abs(way.y * cell.x));
    const World& world = session.world();
    const double radius = world.balls().radius[*index_of(world, *aim_.cue_ball(session))];
    stroke_.start_push(
        MouseStroke(play.pointer.at, way, least_pull * radius, grain, stroke_.time(after_)));
}

// The left button takes the cue at the stick, of which the part at the tip is the hand's then. A
// pull from there turns the cue little, so it keeps the aim.
std::optional<PoolController::Pull> PoolController::grip_of_cue(const PlayContext& play) const {
    const PoolAnnotations::Line stick = aim_.stick(play.session);
    const double long_ = length(stick.to - stick.from);
    const Vec2 back = (stick.to - stick.from) / long_;
    const double along = dot(play.pointer.at - stick.from, back);
    if (along < 0.0 || along > long_) return std::nullopt;
    const Vec2 at = stick.from + back * along;
    if (distance(at, play.pointer.at) > slack(play)) return std::nullopt;
    const World& world = play.session.world();
    const Vec2 ball = world.balls().position[*index_of(world, *aim_.cue_ball(play.session))];
    return Pull{at - play.pointer.at, distance(at, ball), aim_.setup()};
}

// The right button takes the cue wherever the pointer is: near the edge of the window there would
// be no room to pull it back. The way of the shot stays, and only what is pulled along it counts.
PoolController::Pull PoolController::grip_from_anywhere(const PlayContext& play) const {
    const World& world = play.session.world();
    const auto ball = *index_of(world, *aim_.cue_ball(play.session));
    const Vec2 velocity = aim_.strike(play.session).velocity;
    const Vec2 way = velocity / length(velocity);
    const double slack = world.balls().radius[ball];
    const Vec2 hand = world.balls().position[ball] - way * slack;
    return Pull{hand - play.pointer.at, slack, aim_.setup(), way};
}

Vec2 PoolController::hand_at_cue(const PlayContext& play, const Pull& pull) const {
    const Vec2 hand = play.pointer.at + pull.shift;
    const auto cue = aim_.cue_ball(play.session);
    if (pull.way == Vec2{} || !cue) return hand;
    const World& world = play.session.world();
    const Vec2 ball = world.balls().position[*index_of(world, *cue)];
    return ball - pull.way * std::max(pull.slack, dot(ball - hand, pull.way));
}

bool PoolController::take_press(PlayContext& play, const InputEvent& event) {
    if (event.button == middle_button) return false;
    const bool has_game = has_turns(play.session);
    const auto cue = aim_.cue_ball(play.session);
    const auto at_pointer = ball_at_pointer(play);
    const bool is_left = event.button == left_button && !(event.modifiers & (shift | control));
    if (is_left && at_pointer && !has_game) return false;
    Pointer& pointer = play.pointer;
    if (is_left && at_pointer && is_aiming(play) && at_pointer != cue &&
        aim_.choose(play.session, *at_pointer)) {
        play.needs_draw = true;
        return true;
    }
    if (is_left && at_pointer && at_pointer == cue && is_aiming(play) &&
        aim_.may_place(play.session)) {
        pointer.tool.grab_to_place(play.session.world(), *cue, pointer.at);
        pointer.pressed = event.button;
        return true;
    }
    if (!is_aiming(play)) {
        if (players_.is_opponents_turn(play.session)) say(play, players_.opponent_text());
        const PoolPlay* const pool = pool_of(play.session);
        const ShotsState* const shots = shots_of(play.session);
        const auto why_not = pool && cue ? refusal_to_shoot(*pool, *cue)
                             : shots     ? refusal_to_shoot(play.session.world(), *shots)
                                         : std::nullopt;
        if (why_not) say(play, *why_not);
        return has_game || !is_left;
    }
    pointer.pressed = event.button;
    pull_.reset();
    if (at_pointer == cue)
        pull_ = Pull{{}, 0.0, aim_.setup()};
    else if (!is_left)
        pull_ = grip_from_anywhere(play);
    else if (aim_.call_pocket(play.session, pointer.at))
        return true;
    else
        pull_ = grip_of_cue(play);
    if (pull_) {
        pointer.cue_is_armed = false;
        pointer.tool.take_cue(*cue, pointer.at);
        if (players_.is_match(play.session)) start_push(play);
    } else {
        aims_by_mouse_ = true;
        aim_.aim_at(play.session, pointer.at);
    }
    return true;
}

bool PoolController::take_release(PlayContext& play) {
    if (std::exchange(aims_by_mouse_, false)) return true;
    const auto pull = std::exchange(pull_, std::nullopt);
    if (!play.pointer.tool.has_cue()) return stroke_.push() != nullptr;
    play.pointer.tool.forget();
    if (players_.is_match(play.session)) {
        stroke_.end();
        say(play, "Pull the cue back, then push it through where you took it.");
        return true;
    }
    const World& world = play.session.world();
    const auto cue = aim_.cue_ball(play.session);
    const auto index = cue ? index_of(world, *cue) : std::nullopt;
    if (!index || !is_aiming(play)) return true;
    const Pull from = pull.value_or(Pull{{}, 0.0, aim_.setup()});
    const Vec2 hand = hand_at_cue(play, from);
    const double pulled = distance(hand, world.balls().position[*index]) - from.slack;
    if (pulled > least_pull * world.balls().radius[*index])
        shoot(play);
    else
        aim_.set_up(play.session, from.before);
    return true;
}

void PoolController::shoot(PlayContext& play, const std::optional<Stroke>& stroke) {
    stroke_.end();
    const Session& session = play.session;
    stroke_.set_last(has_turns(session) ? stroke : std::nullopt, players_.hand());
    const double most = cue_in_turn(session).most_power;
    const double scatter = cue_in_turn(session).scatter;
    const std::uint64_t seed = session.world().seed();
    for (Command command : aim_.shot(session)) {
        auto* const strike = std::get_if<command::Strike>(&command);
        if (strike && stroke && has_turns(session))
            *strike = struck(*strike, *stroke, players_.hand(), most, seed, shot_number(session));
        if (strike && scatter > 0.0)
            *strike = scattered(*strike, scatter, most, seed, shot_number(session));
        if (const auto why_not = play.session.apply(command)) return complain(play, *why_not);
    }
    set_reference(play);
}

bool PoolController::shoot_with_key(PlayContext& play) {
    if (is_striking(play) && stroke_.meter()) {
        shoot(play, stroke_.meter()->strike(after_));
        return true;
    }
    if (aims_with_keys(play)) {
        const double speed = length(aim_.strike(play.session).velocity);
        if (players_.is_match(play.session))
            stroke_.start_meter(speed, cue_in_turn(play.session).most_power);
        else
            shoot(play);
        return true;
    }
    return false;
}

}  // namespace carom
