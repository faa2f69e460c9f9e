#include <algorithm>
#include <array>
#include <cmath>

#include "game/ai/planner.h"
#include "game/ai/pool_value.h"
#include "game/commands/aiming.h"
#include "game/pool/table_places.h"
#include "game/referees/referee.h"
#include "geometry/unit.h"

/// The shots that the planner tries: breaks, pots, safeties, and places for a ball in hand.
namespace carom {
namespace {

/// How far ahead to simulate when measuring the throw of a cut, s.
constexpr double short_foresight = 1.6;

constexpr std::size_t most_trials = 150;
constexpr std::size_t most_lines = 8;
constexpr std::size_t most_placed_lines = 10;
/// Safeties are on the nearest balls only, and on none where a pot is as certain as this.
constexpr std::size_t most_safe_balls = 6;
constexpr double certain = 0.9;

// `v` rotated by the angle from `from` to `to`. Pre: both are unit vectors.
Vec2 turned(Vec2 v, Vec2 from, Vec2 to) {
    const double c = dot(from, to);
    const double s = cross(from, to);
    return {v.x * c - v.y * s, v.x * s + v.y * c};
}

}  // namespace

void ShotPlanner::propose() {
    const Vec2 from = world_.balls().position[*index_of(world_, *play_.balls[cue_ball])];
    const PoolState& rules = play_.rules;
    if (rules.phase == PoolPhase::breaking)
        return rules.referee->breaks_hard() ? propose_break() : propose_opening(from);
    if (rules.in_hand != CueInHand::no) propose_placed();
    if (rules.in_hand == CueInHand::no || trials_.empty()) {
        const auto lines = useful_lines(scene_, world_, play_, cloth_, from, legal_balls(play_));
        propose_pots(std::nullopt, lines);
    }
    const bool is_certain =
        std::ranges::any_of(trials_, [](const Trial& trial) { return trial.chance >= certain; });
    if (!is_certain || rules.may_push_out || style_.safety > 0.0) propose_hits(from, std::nullopt);
}

// Thin and full hits on the rack from three places: the safest that the simulation finds.
void ShotPlanner::propose_opening(Vec2 from) {
    const Vec2 across{0.0, size(cloth_).y * 0.25};
    for (const double aside : {0.0, 1.0, -1.0}) {
        const Vec2 place = from + across * aside;
        if (may_place(place)) propose_hits(place, place);
    }
    if (trials_.empty()) propose_hits(from, std::nullopt);
}

// Full hits on the apex ball, with the cue ball at the centre or to the sides.
void ShotPlanner::propose_break() {
    const BallId cue = *play_.balls[cue_ball];
    const Vec2 head = head_spot(scene_);
    const Vec2 across{0.0, size(cloth_).y * 0.25};
    const Vec2 apex = rack_of(scene_).foot;
    for (const double aside : {0.0, 0.5, -0.5, 1.0, -1.0}) {
        const Vec2 place = head + across * aside;
        if (!may_place(place)) continue;
        for (const double share : {0.95, 0.8}) {
            Trial trial;
            trial.shot.kind = CandidateShot::Kind::break_off;
            trial.shot.place = place;
            trial.shot.strike = {cue, unit(apex - place) * (most_speed_ * share)};
            trials_.push_back(trial);
        }
    }
}

// Throw: friction between the balls turns the object ball slightly off the line of centres. One
// simulation measures the throw, and the aim is turned back by as much.
Vec2 ShotPlanner::corrected(const PotLine& line, std::optional<Vec2> place, double speed) {
    if (line.way != PotLine::Way::direct || line.cut_cosine > 0.9995) return line.direction;
    const World world = world_with(place);
    const BallId cue = *play_.balls[cue_ball];
    const Vec2 from = world.balls().position[*index_of(world, cue)];
    const Vec2 object = world.balls().position[*index_of(world, line.object)];
    const double radius = world.balls().radius[*index_of(world, cue)];
    const Vec2 wanted = unit(object - line.ghost);
    const Forecast ahead = forecast(scene_, world, play_, solver_, {cue, line.direction * speed},
                                    short_foresight, Tracks::all);
    const auto track = std::ranges::find(ahead.tracks, line.object, &Forecast::Track::ball);
    if (track == ahead.tracks.end() || ahead.first_hit != line.object) return line.direction;
    const auto moved = std::ranges::find_if(
        track->way, [&](Vec2 at) { return length(at - object) > 0.5 * radius; });
    if (moved == track->way.end()) return line.direction;
    const Vec2 aimed = turned(wanted, unit(*moved - object), wanted);
    const Vec2 ghost = object - aimed * length(object - line.ghost);
    return length(ghost - from) > 0.0 ? unit(ghost - from) : line.direction;
}

void ShotPlanner::add_pot(const PotLine& line, std::optional<Vec2> place, Vec2 direction,
                          double speed, double side, double follow) {
    if (trials_.size() >= most_trials) return;
    Trial trial;
    CandidateShot& shot = trial.shot;
    using enum CandidateShot::Kind;
    shot.kind = line.way == PotLine::Way::bank   ? bank
                : line.way == PotLine::Way::kick ? kick
                : line.cut_cosine > 0.985        ? straight
                                                 : cut;
    shot.place = place;
    shot.ball = number_of(play_, line.object);
    shot.pocket = line.pocket;
    if (may_call(play_.rules, PoolCall::Kind::pot))
        shot.call = {PoolCall::Kind::pot, *shot.ball, line.pocket};
    shot.strike = {*play_.balls[cue_ball], direction * std::min(speed, most_speed_), side, follow};
    trial.chance = pot_chance(line, error_.bearing);
    trials_.push_back(trial);
}

void ShotPlanner::propose_pots(std::optional<Vec2> place, std::span<const PotLine> lines) {
    std::size_t direct = 0;
    std::size_t banks = 0;
    std::size_t kicks = 0;
    for (const PotLine& line : lines) {
        if (line.way == PotLine::Way::bank && ++banks > 3) continue;
        if (line.way == PotLine::Way::kick && ++kicks > 2) continue;
        if (line.way != PotLine::Way::direct) {
            for (const double speed : {2.0, 3.0})
                add_pot(line, place, line.direction, speed, 0.0, 0.0);
            continue;
        }
        if (++direct > most_lines) continue;
        // Thinner cuts and longer distances need more speed.
        const double usual = (0.9 + 0.6 * line.distance) / std::max(0.5, line.cut_cosine);
        const Vec2 direction = corrected(line, place, usual);
        for (const double factor : {1.0, 1.5, 0.75})
            for (const double follow : {0.0, 0.3, -0.3})
                add_pot(line, place, direction, usual * factor, 0.0, follow);
        if (direct <= 2)
            for (const double side : {0.25, -0.25})
                add_pot(line, place, direction, usual, side, 0.0);
        // Hard shots, which send the cue ball into a cluster.
        if (direct <= 2)
            for (const double follow : {0.0, 0.3, -0.3})
                add_pot(line, place, direction, usual * 2.2, 0.0, follow);
    }
}

// The legal balls that lie nearest to `from`, the nearest first.
std::vector<BallId> ShotPlanner::nearest_balls(Vec2 from) const {
    std::vector<BallId> balls = legal_balls(play_);
    std::ranges::stable_sort(balls, {}, [&](BallId ball) {
        return length(world_.balls().position[*index_of(world_, ball)] - from);
    });
    if (balls.size() > most_safe_balls) balls.resize(most_safe_balls);
    return balls;
}

// Safeties. Where none can be called, but a ball has to be named, it is the one that is hit.
void ShotPlanner::propose_hits(Vec2 from, std::optional<Vec2> place) {
    const BallId cue = *play_.balls[cue_ball];
    const auto add = [&](CandidateShot::Kind kind, PoolCall call, Vec2 velocity, BallId object) {
        if (trials_.size() >= most_trials + 40) return;
        Trial trial;
        trial.shot.kind = kind;
        trial.shot.place = place;
        trial.shot.call = call;
        trial.shot.strike = {cue, velocity};
        trial.shot.ball = number_of(play_, object);
        trials_.push_back(trial);
    };
    const auto call_of = [&](BallId object) -> PoolCall {
        if (may_call(play_.rules, PoolCall::Kind::safety)) return {PoolCall::Kind::safety, 0, 0};
        if (may_call(play_.rules, PoolCall::Kind::pot))
            return {PoolCall::Kind::pot, number_of(play_, object).value_or(0), 0};
        return {};
    };
    // A longer table takes faster shots.
    constexpr double usual_length = 2.54;
    const double pace = std::max(1.0, std::sqrt(size(cloth_).x / usual_length));
    // A rack has to be driven to cushions.
    const bool is_break = play_.rules.phase == PoolPhase::breaking;
    const std::array speeds = is_break ? std::array{1.6, 2.4, 3.4} : std::array{0.7, 1.2, 2.2};
    for (const BallId object : is_break ? legal_balls(play_) : nearest_balls(from))
        for (const Vec2 way : hit_directions(scene_, world_, cloth_, cue, from, object))
            for (const double speed : speeds) {
                add(CandidateShot::Kind::safety, call_of(object), way * (speed * pace), object);
                if (play_.rules.may_push_out && speed < 1.0)
                    add(CandidateShot::Kind::push_out, {PoolCall::Kind::push_out, 0, 0},
                        way * speed, object);
            }
    if (!trials_.empty()) return;
    // No line that geometry finds reaches a legal ball: shoot in all directions.
    for (const Vec2 way : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}, Vec2{-1.0, 0.0}, Vec2{0.0, -1.0},
                           Vec2{0.8, 0.6}, Vec2{-0.8, 0.6}, Vec2{-0.8, -0.6}, Vec2{0.8, -0.6}})
        for (const double speed : {2.0, 4.0})
            add(CandidateShot::Kind::kick, {}, way * std::min(speed, most_speed_), cue);
}

// Ball in hand: positions on the line to a pocket and a little beside it, for an angle.
void ShotPlanner::propose_placed() {
    const BallId cue = *play_.balls[cue_ball];
    const double radius = world_.balls().radius[*index_of(world_, cue)];
    struct Placed {
        Vec2 place;
        PotLine line;
    };
    std::vector<Placed> all;
    for (const BallId object : legal_balls(play_)) {
        const Vec2 at = world_.balls().position[*index_of(world_, object)];
        for (int pocket = 0; pocket < static_cast<int>(scene_.pool.pockets.size()); ++pocket) {
            const Vec2 target = mouth(scene_, cloth_, pocket);
            if (!(length(target - at) > 0.0)) continue;
            if (!play_.rules.referee->may_pocket(play_.rules, pocket)) continue;
            const Vec2 way = unit(target - at);
            for (const double apart : {8.0, 16.0})
                for (const double aside : {0.0, 0.35, -0.35}) {
                    const Vec2 back = unit(-way + perpendicular(way) * aside);
                    const Vec2 place = at - way * (2.0 * radius) + back * (apart * radius);
                    if (!may_place(place)) continue;
                    for (const PotLine& line :
                         pot_lines(scene_, world_, cloth_, cue, place, std::span(&object, 1)))
                        if (line.pocket == pocket && line.way == PotLine::Way::direct)
                            all.push_back({place, line});
                }
        }
    }
    std::ranges::stable_sort(
        all, [](const Placed& a, const Placed& b) { return a.line.tolerance > b.line.tolerance; });
    if (all.size() > most_placed_lines) all.resize(most_placed_lines);
    for (const Placed& placed : all)
        propose_pots(placed.place, std::span(&placed.line, 1));
}

}  // namespace carom
