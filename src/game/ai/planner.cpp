#include "game/ai/planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/ai/pool_value.h"
#include "game/commands/aiming.h"
#include "game/referees/referee.h"
#include "geometry/unit.h"
#include "physics/world/random.h"

namespace carom {
namespace {

/// A shot is followed so long, s.
constexpr double foresight = 40.0;
/// For measuring how much a cut throws the object ball.
constexpr double short_foresight = 1.6;

constexpr std::size_t most_candidates = 150;
constexpr std::size_t most_finalists = 10;
constexpr int rounds = 14;
constexpr std::size_t most_lines = 8;
constexpr std::size_t most_placed_lines = 10;
constexpr double value_of_miss = -0.4;

// `v` turned as `from` would have to be to become `to`. Pre: both of length 1.
Vec2 turned(Vec2 v, Vec2 from, Vec2 to) {
    const double c = dot(from, to);
    const double s = cross(from, to);
    return {v.x * c - v.y * s, v.x * s + v.y * c};
}

}  // namespace

PoolThinker::PoolThinker(const Scene& scene, const World& world, const PoolPlay& play,
                         const SolverSettings& solver, const HandError& error, std::uint64_t seed)
    : scene_(scene),
      world_(world),
      play_(play),
      solver_(solver),
      error_(error),
      seed_(seed),
      cloth_(cloth_box(scene).value_or(scene.view)),
      most_speed_(scene.pool.cue->most_power) {
    propose();
}

World PoolThinker::world_with(const std::optional<Vec2>& place) const {
    World world = world_;
    if (place) world.balls.position[*index_of(world, *play_.balls[cue_ball])] = *place;
    return world;
}

bool PoolThinker::may_place(Vec2 place) const {
    return !refusal(scene_, world_, play_, command::PlaceBall{*play_.balls[cue_ball], place});
}

void PoolThinker::propose() {
    const Vec2 from = world_.balls.position[*index_of(world_, *play_.balls[cue_ball])];
    if (play_.rules.phase == PoolPhase::breaking) return propose_break();
    if (play_.rules.in_hand != CueInHand::no) propose_placed();
    if (play_.rules.in_hand == CueInHand::no || candidates_.empty()) {
        const auto lines =
            pot_lines(scene_, world_, cloth_, *play_.balls[cue_ball], from, legal_balls(play_));
        propose_pots(std::nullopt, lines);
    }
    propose_hits(from);
}

// Full on the ball in front, from the middle and from the sides, or a little off it.
void PoolThinker::propose_break() {
    const BallId cue = *play_.balls[cue_ball];
    const Vec2 head = head_spot(scene_);
    const Vec2 across{0.0, size(cloth_).y * 0.25};
    const Vec2 apex = rack_of(scene_).foot;
    for (const double aside : {0.0, 0.5, -0.5, 1.0, -1.0}) {
        const Vec2 place = head + across * aside;
        if (!may_place(place)) continue;
        for (const double share : {0.95, 0.8}) {
            Candidate candidate;
            candidate.thought.kind = PoolThought::Kind::break_off;
            candidate.thought.place = place;
            candidate.thought.strike = {cue, unit(apex - place) * (most_speed_ * share)};
            candidates_.push_back(candidate);
        }
    }
}

// Friction between balls turns the object ball a little out of the line of centres: how much shows
// a try, and the aim is turned back by it.
Vec2 PoolThinker::corrected(const PotLine& line, std::optional<Vec2> place, double speed) {
    if (line.way != PotLine::Way::direct || line.cut_cosine > 0.9995) return line.direction;
    const World world = world_with(place);
    const BallId cue = *play_.balls[cue_ball];
    const Vec2 from = world.balls.position[*index_of(world, cue)];
    const Vec2 object = world.balls.position[*index_of(world, line.object)];
    const double radius = world.balls.radius[*index_of(world, cue)];
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

void PoolThinker::add_pot(const PotLine& line, std::optional<Vec2> place, Vec2 direction,
                          double speed, double side, double follow) {
    if (candidates_.size() >= most_candidates) return;
    Candidate candidate;
    PoolThought& thought = candidate.thought;
    using enum PoolThought::Kind;
    thought.kind = line.way == PotLine::Way::bank   ? bank
                   : line.way == PotLine::Way::kick ? kick
                   : line.cut_cosine > 0.985        ? straight
                                                    : cut;
    thought.place = place;
    thought.ball = number_of(play_, line.object);
    thought.pocket = line.pocket;
    if (may_call_shots(play_.rules))
        thought.call = {PoolCall::Kind::pot, *thought.ball, line.pocket};
    thought.strike = {*play_.balls[cue_ball], direction * std::min(speed, most_speed_), side,
                      follow};
    candidate.chance = pot_chance(line, error_.bearing);
    candidates_.push_back(candidate);
}

void PoolThinker::propose_pots(std::optional<Vec2> place, std::span<const PotLine> lines) {
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
        // The thinner the cut and the longer the way, the more it takes.
        const double usual = (0.9 + 0.6 * line.distance) / std::max(0.5, line.cut_cosine);
        const Vec2 direction = corrected(line, place, usual);
        for (const double factor : {1.0, 1.5, 0.75})
            for (const double follow : {0.0, 0.3, -0.3})
                add_pot(line, place, direction, usual * factor, 0.0, follow);
        if (direct <= 2)
            for (const double side : {0.25, -0.25})
                add_pot(line, place, direction, usual, side, 0.0);
    }
}

void PoolThinker::propose_hits(Vec2 from) {
    const BallId cue = *play_.balls[cue_ball];
    const auto add = [&](PoolThought::Kind kind, PoolCall call, Vec2 velocity, BallId object) {
        if (candidates_.size() >= most_candidates + 40) return;
        Candidate candidate;
        candidate.thought.kind = kind;
        candidate.thought.call = call;
        candidate.thought.strike = {cue, velocity};
        candidate.thought.ball = number_of(play_, object);
        candidates_.push_back(candidate);
    };
    const bool calls = may_call_shots(play_.rules);
    const PoolCall safety{calls ? PoolCall::Kind::safety : PoolCall::Kind::none, 0, 0};
    for (const BallId object : legal_balls(play_))
        for (const Vec2 way : hit_directions(scene_, world_, cloth_, cue, from, object))
            for (const double speed : {0.7, 1.2, 2.2}) {
                add(PoolThought::Kind::safety, safety, way * speed, object);
                if (play_.rules.may_push_out && speed < 1.0)
                    add(PoolThought::Kind::push_out, {PoolCall::Kind::push_out, 0, 0}, way * speed,
                        object);
            }
    if (!candidates_.empty()) return;
    // Nothing can be met by a line that is seen: round the table in the hope of meeting something.
    for (const Vec2 way : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}, Vec2{-1.0, 0.0}, Vec2{0.0, -1.0},
                           Vec2{0.8, 0.6}, Vec2{-0.8, 0.6}, Vec2{-0.8, -0.6}, Vec2{0.8, -0.6}})
        for (const double speed : {2.0, 4.0})
            add(PoolThought::Kind::kick, {}, way * std::min(speed, most_speed_), cue);
}

// The ball in hand: behind the line into a pocket, near enough, and a little aside for the angle.
void PoolThinker::propose_placed() {
    const BallId cue = *play_.balls[cue_ball];
    const double radius = world_.balls.radius[*index_of(world_, cue)];
    struct Placed {
        Vec2 place;
        PotLine line;
    };
    std::vector<Placed> all;
    for (const BallId object : legal_balls(play_)) {
        const Vec2 at = world_.balls.position[*index_of(world_, object)];
        for (int pocket = 0; pocket < static_cast<int>(scene_.pool.pockets.size()); ++pocket) {
            const Vec2 target = mouth(scene_, cloth_, pocket);
            if (!(length(target - at) > 0.0)) continue;
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

Forecast PoolThinker::try_out(const Candidate& candidate, const command::Strike& strike) {
    PoolPlay play = play_;
    play.call = candidate.thought.call;
    return forecast(scene_, world_with(candidate.thought.place), play, solver_, strike, foresight,
                    Tracks::none);
}

double PoolThinker::value_of(const Forecast& ahead) const {
    const auto& play = std::get<PoolPlay>(ahead.game);
    if (play.is_shooting) return 0.0;  // it did not come to rest
    return value_to(play_.rules.player, scene_, ahead.world, play, cloth_, error_.bearing);
}

bool PoolThinker::goes_on(const Forecast& ahead) const {
    const auto& play = std::get<PoolPlay>(ahead.game);
    return play.rules.winner == std::optional(play_.rules.player) ||
           (!play.rules.winner && play.rules.player == play_.rules.player);
}

void PoolThinker::work(int tries) {
    for (; tries > 0 && stage_ != Stage::done; --tries) {
        if (stage_ == Stage::trying)
            try_next();
        else
            test_next();
    }
}

// Each once, as it is meant. What geometry says of how likely it is counts, for here it cannot miss
// by the hand's error.
void PoolThinker::try_next() {
    Candidate& candidate = candidates_[next_++];
    const Forecast ahead = try_out(candidate, candidate.thought.strike);
    const double value = value_of(ahead);
    const double chance = goes_on(ahead) ? candidate.chance : 1.0;
    candidate.first_value = chance * value + (1.0 - chance) * value_of_miss;
    const auto& play = std::get<PoolPlay>(ahead.game);
    if (goes_on(ahead) && !play.rules.winner)
        candidate.thought.leaves =
            outlook(scene_, ahead.world, play, cloth_, error_.bearing).easiest;
    if (next_ == candidates_.size()) begin_testing();
}

// The best of them again and again, with the errors of the hand: the same errors for all.
void PoolThinker::begin_testing() {
    std::ranges::stable_sort(candidates_, [](const Candidate& a, const Candidate& b) {
        return a.first_value > b.first_value;
    });
    if (candidates_.size() > most_finalists) candidates_.resize(most_finalists);
    stage_ = Stage::testing;
    next_ = 0;
    round_ = 0;
}

void PoolThinker::test_next() {
    Candidate& candidate = candidates_[next_];
    const command::Strike off = with_error(candidate.thought.strike, error_, most_speed_, seed_,
                                           static_cast<std::uint64_t>(round_));
    const Forecast ahead = try_out(candidate, off);
    candidate.sum += value_of(ahead);
    if (goes_on(ahead)) ++candidate.went_on;
    if (++next_ < candidates_.size()) return;
    next_ = 0;
    if (++round_ == rounds) finish();
}

void PoolThinker::finish() {
    stage_ = Stage::done;
    for (Candidate& candidate : candidates_) {
        candidate.thought.value = candidate.sum / rounds;
        candidate.thought.success = static_cast<double>(candidate.went_on) / rounds;
    }
    std::ranges::stable_sort(candidates_, [](const Candidate& a, const Candidate& b) {
        return a.thought.value > b.thought.value;
    });
    // Three that differ in more than speed and spin, where there are three.
    for (const Candidate& candidate : candidates_) {
        const auto is_same = [&](const PoolThought& other) {
            return other.kind == candidate.thought.kind && other.ball == candidate.thought.ball &&
                   other.pocket == candidate.thought.pocket;
        };
        if (best_.size() < 3 && std::ranges::none_of(best_, is_same))
            best_.push_back(candidate.thought);
    }
    candidates_.clear();
}

}  // namespace carom
