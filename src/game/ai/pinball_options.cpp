#include "game/ai/pinball_options.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "game/pinball/pinball.h"

namespace carom {
namespace {

// In seconds.
constexpr double press_step = 0.02;  // between the moments that are tried
constexpr int press_moments = 6;
constexpr double looks_ahead = 0.60;
constexpr double nudge_time = 0.05;
constexpr int nudge_moments = 3;

}  // namespace

std::uint64_t pinball_ticks(const World& world, double seconds) {
    return static_cast<std::uint64_t>(seconds * world.rate() + 0.5);
}

double value_around(const std::vector<double>& values, std::size_t moment, int reach) {
    double sum = 0.0;
    double weights = 0.0;
    for (int away = -reach; away <= reach; ++away) {
        const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
        const auto at =
            std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(moment) + away, 0, last);
        const double weight = reach + 1 - std::abs(away);
        sum += weight * values[static_cast<std::size_t>(at)];
        weights += weight;
    }
    return sum / weights;
}

std::vector<PinballOption> ways_to_meet(const PinballSight& sight, const Scene& scene,
                                        const SolverSettings& settings, PinballTrial waiting,
                                        Button button) {
    Solver solver(settings);
    const bool is_down = waiting.state.is_down[static_cast<std::size_t>(button)];
    const std::uint64_t step = pinball_ticks(waiting.world, press_step);
    const std::uint64_t horizon = pinball_ticks(waiting.world, looks_ahead);
    const std::uint64_t flips = pinball_ticks(waiting.world, pinball_flip_time);
    std::vector<PinballOption> options;
    options.push_back({{}, play_ahead(sight, scene, solver, waiting, {}, horizon, true)});
    std::uint64_t after = pinball_ticks(waiting.world, pinball_reaction);
    for (std::uint64_t i = 0; i < after; ++i)
        play_tick(scene, solver, waiting);
    for (int moment = 0; moment < press_moments; ++moment, after += step) {
        const std::vector<TimedPress> change{{0, button, !is_down}};
        const std::vector<TimedPress> flip{{0, button, !is_down}, {flips, button, is_down}};
        for (std::vector<TimedPress> presses : {change, flip}) {
            const Foreseen foreseen =
                play_ahead(sight, scene, solver, waiting, presses, horizon - after, true);
            for (TimedPress& press : presses)
                press.after += after;
            options.push_back({std::move(presses), foreseen});
        }
        for (std::uint64_t i = 0; i < step; ++i)
            play_tick(scene, solver, waiting);
    }
    return options;
}

std::optional<PinballOption> best_nudge(const PinballSight& sight, const Scene& scene,
                                        const SolverSettings& settings, const PinballTrial& trial) {
    Solver solver(settings);
    const std::uint64_t first = pinball_ticks(trial.world, pinball_reaction);
    const std::uint64_t step = pinball_ticks(trial.world, press_step);
    const std::uint64_t lasts = pinball_ticks(trial.world, nudge_time);
    std::optional<PinballOption> best;
    for (const Button way : {Button::nudge_left, Button::nudge_right, Button::nudge_up}) {
        if (!has_button(scene, way)) continue;
        std::vector<PinballOption> options;
        std::vector<double> values;
        for (int moment = 0; moment < nudge_moments; ++moment) {
            const std::uint64_t after = first + step * static_cast<std::uint64_t>(moment);
            PinballOption option{{{after, way, true}, {after + lasts, way, false}}, {}};
            option.foreseen = play_ahead(sight, scene, solver, trial, option.presses,
                                         pinball_ticks(trial.world, looks_ahead), true);
            values.push_back(option.foreseen.safety);
            options.push_back(std::move(option));
        }
        for (std::size_t i = 0; i < options.size(); ++i) {
            options[i].foreseen.safety = value_around(values, i, 1);
            if (!best || options[i].foreseen.safety > best->foreseen.safety) best = options[i];
        }
    }
    return best;
}

}  // namespace carom
