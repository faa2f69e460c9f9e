#include "carom/pool/pool_aim.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "carom/pool/pool_status.h"
#include "game/ai/pool_shots.h"
#include "geometry/elementary.h"

namespace carom {
namespace {

// The speed is gentle at first, so that soft shots can be measured out, and full within the room
// that a window of 80 columns leaves behind a cue ball in the middle of the table.
constexpr double pull_gain = 3.0;     // ball speed per length of pull, 1/s
constexpr double pull_growth = 0.34;  // the gain's growth for each radius of pull, 1/s
constexpr double least_speed = 0.1;
constexpr double finest_turn = 0.05;  // degrees
constexpr double break_speed = 8.0;
constexpr double usual_speed = 2.0;
constexpr double opening_pace = 1.57;  // as aim_at_corner() needs it; see speed_of_opening()

Vec2 place_of(const World& world, BallId ball) {
    return world.balls().position[*index_of(world, ball)];
}

// The pull that gives a ball of this radius the speed.
double pull_for(double speed, double radius) {
    const double growth = pull_growth / radius;
    return (std::sqrt(pull_gain * pull_gain + 4.0 * growth * speed) - pull_gain) / (2.0 * growth);
}

// The cloth takes energy by the length of the way, so the speed that brings the cue ball back grows
// with the root of the table's length. In tenths of a m/s: 2.5 on a 9-ft table, 3.0 at snooker.
double speed_of_opening(const Scene& scene) {
    const auto cloth = cloth_box(scene);
    const Vec2 table = size(cloth ? *cloth : scene.view);
    return std::round(10.0 * opening_pace * std::sqrt(std::max(table.x, table.y))) / 10.0;
}

double bearing_of(Vec2 way) {
    return std::atan2(way.y, way.x) * 180.0 / pi;
}

}  // namespace

PoolAim::PoolAim(const Session& session) {
    begin_turn(session);
}

std::optional<BallId> PoolAim::cue_ball(const Session& session) const {
    const ShotsState* const shots = shots_of(session);
    if (shots && chosen_) {
        const std::vector<BallId> balls = cue_balls_of(session.scene(), *shots);
        if (std::ranges::count(balls, *chosen_) > 0) return chosen_;
    }
    const auto ball = shots              ? cue_ball_of(session.scene(), *shots)
                      : pool_of(session) ? pool_of(session)->balls[0]
                                         : std::optional(session.scene().pool.cue->ball);
    if (!ball || !index_of(session.world(), *ball)) return std::nullopt;
    return ball;
}

bool PoolAim::may_aim(const Session& session) const {
    const auto ball = cue_ball(session);
    if (!ball) return false;
    if (const PoolPlay* game = pool_of(session)) return !refusal_to_shoot(*game, *ball);
    if (const ShotsState* shots = shots_of(session))
        return !refusal_to_shoot(session.world(), *shots);
    return is_at_rest(session.world());
}

bool PoolAim::may_place(const Session& session) const {
    if (const ShotsState* shots = shots_of(session)) return shots->is_in_hand && may_aim(session);
    const PoolPlay* game = pool_of(session);
    return may_aim(session) && (!game || game->rules.in_hand != CueInHand::no);
}

const Cue& cue_in_turn(const Session& session) {
    if (const ShotsState* shots = shots_of(session)) return cue_in_turn(session.scene(), *shots);
    return *session.scene().pool.cue;
}

void PoolAim::begin_turn(const Session& session) {
    const double speed = is_safe_opening(session) ? speed_of_opening(session.scene())
                         : is_break(session)      ? break_speed
                                                  : usual_speed;
    setup_ = {.bearing = setup_.bearing,
              .speed = std::min(speed, cue_in_turn(session).most_power),
              .aids = setup_.aids};
    pot_ = 0;
    pot_text_.clear();
    has_aimed_ = false;
    chosen_.reset();
    if (!aim_as_before(session)) aim_first(session);
}

bool PoolAim::aim_as_before(const Session& session) {
    if (!played_ || played_->places != places_of_balls(session)) return false;
    const Aids aids = setup_.aids;
    setup_ = played_->setup;
    setup_.aids = aids;
    has_aimed_ = true;
    return true;
}

void PoolAim::set_up(const Session& session, const ShotSetup& setup) {
    look(session);  // so that the start of a turn does not reset it
    setup_ = setup;
    has_aimed_ = true;
    constexpr double most = command::Strike::most_offset;
    if (!(setup.side * setup.side + setup.follow * setup.follow <= most * most))
        setup_.side = setup_.follow = 0.0;
    setup_.speed = std::clamp(setup.speed, least_speed, cue_in_turn(session).most_power);
    const auto pockets = static_cast<int>(session.scene().pool.pockets.size());
    if (setup.pocket < 0 || setup.pocket >= pockets) {
        setup_.pocket = 0;
        setup_.intent = Intent::automatic;
    }
    is_seen_ = false;
}

void PoolAim::turn(double degrees) {
    // Rounded to multiples of the finest turn, so that exactly straight aims can be reached.
    const double bearing = std::round((setup_.bearing + degrees) / finest_turn) * finest_turn;
    setup_.bearing = std::remainder(bearing, 360.0);
    has_aimed_ = true;
}

void PoolAim::change_speed(double by) {
    setup_.speed = std::max(least_speed, std::round((setup_.speed + by) * 1000.0) / 1000.0);
}

void PoolAim::move_tip(double side, double follow) {
    constexpr double most = command::Strike::most_offset;
    const double to_side = setup_.side + side;
    const double to_follow = setup_.follow + follow;
    const auto tidy = [](double value) { return std::round(value * 1000.0) / 1000.0; };
    if (to_side * to_side + to_follow * to_follow > most * most + 1e-9) return;
    setup_.side = tidy(to_side);
    setup_.follow = tidy(to_follow);
}

void PoolAim::aim_at(const Session& session, Vec2 place) {
    const auto cue = cue_ball(session);
    if (!cue) return;
    const Vec2 way = place - place_of(session.world(), *cue);
    if (!(length(way) > 0.0)) return;
    setup_.bearing = bearing_of(way);
    has_aimed_ = true;
}

// Where the room is short, what it lacks is added to the pull by the square of its share of the
// room, so soft shots can still be measured out.
void PoolAim::pull(const Session& session, double pulled, double room) {
    const auto cue = cue_ball(session);
    if (!cue) return;
    has_aimed_ = true;
    const World& world = session.world();
    const double radius = world.balls().radius[*index_of(world, *cue)];
    const double most = cue_in_turn(session).most_power;
    const double share = room > 0.0 ? pulled / room : 0.0;
    const double lacking = std::max(0.0, pull_for(most, radius) - room);
    const double counted = pulled + lacking * share * share;
    setup_.speed =
        std::clamp(counted * (pull_gain + pull_growth * counted / radius), least_speed, most);
}

void PoolAim::set_match(bool is_match) {
    if (std::exchange(is_match_, is_match) != is_match) is_seen_ = false;
}

Aids PoolAim::shown_aids() const {
    return is_match_ ? Aids::ghost : setup_.aids;
}

void PoolAim::take(const Session& session, const CandidateShot& candidate) {
    look(session);  // so that the start of a turn does not reset the aim
    const Vec2 velocity = candidate.strike.velocity;
    setup_ = {.bearing = bearing_of(velocity),
              .speed = length(velocity),
              .side = candidate.strike.side,
              .follow = candidate.strike.follow,
              .aids = setup_.aids,
              .pocket = candidate.call.pocket};
    has_aimed_ = true;
    using enum PoolCall::Kind;
    setup_.intent = candidate.call.kind == pot        ? Intent::pocket
                    : candidate.call.kind == safety   ? Intent::safety
                    : candidate.call.kind == push_out ? Intent::push_out
                                                      : Intent::automatic;
}

// The picture shows a ball in two or three cells, so that a ghost ball alone does not tell the way
// of the object ball. Drills teach to see it.
bool PoolAim::shows_object_line(const Session& session) const {
    if (!is_match_) return setup_.aids == Aids::ghost;
    return setup_.aids != Aids::none && pool_of(session);
}

std::string PoolAim::next_aids(const Session& session) {
    if (is_match_) {
        if (!pool_of(session)) return "For real, only the ghost ball is shown.";
        setup_.aids = setup_.aids == Aids::none ? Aids::ghost : Aids::none;
        return setup_.aids == Aids::none ? "aid: the ghost ball alone"
                                         : "aid: ghost ball and line of the ball";
    }
    constexpr std::string_view texts[] = {"aid: off", "aid: ghost ball and lines",
                                          "aid: the whole shot",
                                          "aid: dots are 20 imperfect shots"};
    setup_.aids = static_cast<Aids>((static_cast<int>(setup_.aids) + 1) % 4);
    is_seen_ = false;
    return std::string(texts[static_cast<std::size_t>(setup_.aids)]);
}

command::Strike PoolAim::strike(const Session& session) const {
    const double angle = setup_.bearing * pi / 180.0;
    const double speed = std::min(setup_.speed, cue_in_turn(session).most_power);
    command::Strike strike;
    strike.ball = cue_ball(session).value_or(BallId{});
    strike.velocity = {speed * std::cos(angle), speed * std::sin(angle)};
    if (session.world().model().spin) strike.side = setup_.side;
    if (session.world().model().cloth) strike.follow = setup_.follow;
    return strike;
}

std::vector<Vec2> places_of_balls(const Session& session) {
    std::vector<Vec2> places = session.world().balls().position;
    std::ranges::sort(places,
                      [](Vec2 a, Vec2 b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
    return places;
}

}  // namespace carom
