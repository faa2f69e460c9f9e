#include "game/ai/pinball_trial.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "game/pinball/pinball.h"

namespace carom {
namespace {

// Points are worth less and less, so that a player does not risk a ball for many of them.
constexpr double points_for_one = 100.0;
constexpr double most_for_points = 20.0;
constexpr double for_lit_shot = 15.0;  // a shot that the task asks for
constexpr int most_lit_shots = 2;
constexpr double for_lost_ball = -100.0;  // as PinballSight::safety has it

double value_of(double points) {
    return std::min(most_for_points, std::sqrt(std::max(0.0, points) / points_for_one));
}

constexpr double time_in_lane = 0.8;  // s that a ball rolls down an inlane or an outlane, at most

enum class Prospect : std::uint8_t { near, beside, away, lost };

// `beside`: a ball is in a lane beside the flippers. `away`: none is near. `lost`: all balls are.
Prospect prospect_of(const PinballSight& sight, const Scene& scene, const PinballTrial& trial) {
    bool is_any_near = false;
    bool is_any_beside = false;
    bool all_lost = true;
    for (std::size_t i = 0; i < trial.world.balls().size(); ++i) {
        if (!is_in_play(scene, trial.state, trial.world.balls().id[i])) continue;
        const bool is_lost = sight.is_lost(trial.world, i);
        all_lost = all_lost && is_lost;
        is_any_near = is_any_near || (!is_lost && sight.is_near(trial.world, i));
        is_any_beside = is_any_beside || sight.is_beside(trial.world, i);
    }
    if (all_lost) return Prospect::lost;
    if (is_any_beside) return Prospect::beside;
    return is_any_near ? Prospect::near : Prospect::away;
}

/// The shots that the task asks for, and how often they are made.
class LitShots {
  public:
    LitShots(const Scene& scene, const PinballTrial& trial) : scene_(scene) { look(trial); }

    /// Counts what has happened since `events`. Returns the lit device that was hit, if any.
    std::optional<std::uint32_t> count(const PinballTrial& trial,
                                       const std::vector<std::uint32_t>& events) {
        std::optional<std::uint32_t> made;
        for (const std::uint32_t group : lit_)
            for (const std::uint32_t device : scene_.table.groups[group].devices) {
                if (trial.state.events[device] == events[device]) continue;
                made = device;
                ++made_;
            }
        look(trial);
        return made;
    }
    double value() const { return for_lit_shot * std::min(most_lit_shots, made_); }

  private:
    void look(const PinballTrial& trial) { lit_ = shots_to_make(scene_, trial.world, trial.state); }

    const Scene& scene_;
    std::span<const std::uint32_t> lit_;
    int made_ = 0;
};

}  // namespace

void play_tick(const Scene& scene, Solver& solver, PinballTrial& trial) {
    solver.tick(trial.world);
    update_pinball(scene, trial.world, trial.state, solver.contacts());
}

Foreseen play_ahead(const PinballSight& sight, const Scene& scene, Solver& solver,
                    PinballTrial trial, const std::vector<TimedPress>& presses, std::uint64_t ticks,
                    bool ends_when_away) {
    Foreseen foreseen;
    const double worth_before = sight.worth(trial.state);
    const std::uint64_t drained_before = trial.state.drained;
    double worth = worth_before;
    double most = 0.0;
    std::vector<std::uint32_t> events = trial.state.events;
    LitShots lit(scene, trial);
    std::optional<std::uint32_t> lit_device;
    auto next = presses.begin();
    bool was_away = false;
    const auto longest = ticks + static_cast<std::uint64_t>(time_in_lane * trial.world.rate());
    for (std::uint64_t tick = 0; tick < longest; ++tick) {
        const Prospect prospect = prospect_of(sight, scene, trial);
        if (prospect == Prospect::lost || (was_away && prospect != Prospect::away)) break;
        if (tick >= ticks && prospect != Prospect::beside) break;
        was_away = was_away || prospect == Prospect::away;
        if (was_away && ends_when_away) break;
        for (; next != presses.end() && next->after <= tick; ++next)
            press(scene, trial.world, trial.state, next->button, next->is_down);
        play_tick(scene, solver, trial);
        if (trial.state.events == events) continue;
        const double now = sight.worth(trial.state);
        if (now - worth > most) {
            most = now - worth;
            foreseen.device = static_cast<std::uint32_t>(
                std::ranges::mismatch(trial.state.events, events).in1 - trial.state.events.begin());
        }
        worth = now;
        const auto made = lit.count(trial, events);
        if (!lit_device) lit_device = made;
        events = trial.state.events;
    }
    foreseen.safety = sight.safety(trial.world, trial.state) +
                      for_lost_ball * static_cast<double>(trial.state.drained - drained_before);
    foreseen.gain = value_of(worth - worth_before) + lit.value();
    if (lit_device) foreseen.device = lit_device;
    return foreseen;
}

}  // namespace carom
