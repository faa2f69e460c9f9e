#include "game/ai/planner.h"

#include <algorithm>
#include <array>
#include <utility>

#include "game/ai/pool_value.h"
#include "game/pool/table_places.h"

namespace carom {
namespace {

/// How far ahead a shot is simulated, s.
constexpr double foresight = 40.0;

constexpr std::size_t most_finalists = 10;
constexpr int rounds = 14;
/// After so many rounds only so many of the finalists remain: the others are behind.
struct Cut {
    int after;
    std::size_t remain;
};
constexpr std::array cuts{Cut{4, 5}, Cut{8, 3}};
constexpr double value_of_miss = -0.4;
/// Of a foul that does not give the opponent ball in hand, beyond the points that it costs: a limit
/// of fouls in a row comes nearer, and two players who foul in turn play a frame without end.
constexpr double value_of_foul = -0.15;

}  // namespace

ShotPlanner::ShotPlanner(const Scene& scene, const World& world, const PoolPlay& play,
                         const SolverSettings& solver, const ShotNoise& error, std::uint64_t seed,
                         const PlayStyle& style)
    : scene_(scene),
      world_(world),
      play_(play),
      solver_(solver),
      error_(error),
      style_(style),
      seed_(seed),
      cloth_(cloth_box(scene).value_or(scene.view)),
      most_speed_(scene.pool.cue->most_power) {
    propose();
}

World ShotPlanner::world_with(const std::optional<Vec2>& place) const {
    World world = world_;
    if (place) world.edit_balls().position[*index_of(world, *play_.balls[cue_ball])] = *place;
    return world;
}

bool ShotPlanner::may_place(Vec2 place) const {
    return !refusal(scene_, world_, play_, command::PlaceBall{*play_.balls[cue_ball], place});
}

Forecast ShotPlanner::try_out(const Trial& trial, const command::Strike& strike) {
    PoolPlay play = play_;
    play.call = trial.shot.call;
    return forecast(scene_, world_with(trial.shot.place), play, solver_, strike, foresight,
                    Tracks::none);
}

double ShotPlanner::value_of(const Forecast& ahead) const {
    const auto& play = std::get<PoolPlay>(ahead.game);
    if (play.is_shooting) return 0.0;  // the balls did not come to rest in time
    double value = value_to(play_.rules.player, scene_, ahead.world, play, cloth_, error_.bearing);
    if (play.last_foul != PoolFoul::none && play.rules.in_hand == CueInHand::no)
        value += value_of_foul;
    // A weak opening may have to be repeated without end: its points are not all that it costs.
    return play.last_foul == PoolFoul::weak_opening ? std::min(value, value_of_miss) : value;
}

bool ShotPlanner::continues_turn(const Forecast& ahead) const {
    const auto& play = std::get<PoolPlay>(ahead.game);
    return play.rules.winner == std::optional(play_.rules.player) ||
           (!play.rules.winner && play.rules.player == play_.rules.player);
}

// What the player's style adds to the value of a shot that succeeds so often.
double ShotPlanner::liking_for(const CandidateShot& shot, double success) const {
    using enum CandidateShot::Kind;
    if (shot.kind == safety || shot.kind == push_out) return style_.safety;
    if (shot.kind == break_off) return 0.0;
    return style_.risk * (1.0 - success) + style_.pace * length(shot.strike.velocity) +
           (shot.leaves ? style_.position * success : 0.0);
}

void ShotPlanner::work(int tries) {
    for (; tries > 0 && stage_ != Stage::done; --tries) {
        if (stage_ == Stage::trying)
            try_next();
        else
            test_next();
    }
}

// Simulates the next shot once without noise. Without noise it cannot miss, so its value is
// weighted by the chance of success that geometry predicts.
void ShotPlanner::try_next() {
    Trial& trial = trials_[next_++];
    const Forecast ahead = try_out(trial, trial.shot.strike);
    const double value = value_of(ahead);
    const double chance = continues_turn(ahead) ? trial.chance : 1.0;
    trial.first_value = chance * value + (1.0 - chance) * value_of_miss;
    const auto& play = std::get<PoolPlay>(ahead.game);
    if (continues_turn(ahead) && !play.rules.winner)
        trial.shot.leaves = outlook(scene_, ahead.world, play, cloth_, error_.bearing).easiest;
    trial.first_value += liking_for(trial.shot, trial.chance);
    if (next_ == trials_.size()) begin_testing();
}

// Keeps the best shots, to be simulated repeatedly with noise: the same noise for each.
void ShotPlanner::begin_testing() {
    std::ranges::stable_sort(
        trials_, [](const Trial& a, const Trial& b) { return a.first_value > b.first_value; });
    if (trials_.size() > most_finalists) trials_.resize(most_finalists);
    stage_ = Stage::testing;
    next_ = 0;
    round_ = 0;
    finalists_ = trials_.size();
}

// Ranks the shots that are still tested, by what the trials with noise have shown so far.
void ShotPlanner::rank_finalists() {
    for (std::size_t i = 0; i < finalists_; ++i) {
        Trial& trial = trials_[i];
        trial.shot.success = static_cast<double>(trial.continued) / round_;
        trial.shot.value = trial.sum / round_ + liking_for(trial.shot, trial.shot.success);
    }
    std::stable_sort(trials_.begin(), trials_.begin() + static_cast<std::ptrdiff_t>(finalists_),
                     [](const Trial& a, const Trial& b) { return a.shot.value > b.shot.value; });
}

void ShotPlanner::test_next() {
    Trial& trial = trials_[next_];
    const command::Strike off = with_noise(trial.shot.strike, error_, most_speed_, seed_,
                                           static_cast<std::uint64_t>(round_));
    const Forecast ahead = try_out(trial, off);
    trial.sum += value_of(ahead);
    if (continues_turn(ahead)) ++trial.continued;
    if (++next_ < finalists_) return;
    next_ = 0;
    ++round_;
    const auto cut = std::ranges::find(cuts, round_, &Cut::after);
    if (cut == cuts.end() && round_ < rounds) return;
    rank_finalists();
    if (round_ == rounds) return finish();
    finalists_ = std::min(finalists_, cut->remain);
}

void ShotPlanner::finish() {
    stage_ = Stage::done;
    // Up to three shots that differ in more than speed and spin.
    for (const Trial& trial : trials_) {
        const auto is_same = [&](const CandidateShot& other) {
            return other.kind == trial.shot.kind && other.ball == trial.shot.ball &&
                   other.pocket == trial.shot.pocket;
        };
        if (best_.size() < 3 && std::ranges::none_of(best_, is_same)) best_.push_back(trial.shot);
    }
    trials_.clear();
}

}  // namespace carom
