#pragma once

#include <cstdint>
#include <vector>

#include "game/pinball/pinball.h"
#include "geometry/closest.h"
#include "lab/games/pinball_games.h"
#include "physics/world/random.h"

namespace carom::test {

/// Somebody who plays pinball for the first time: flips both flippers when a ball is within 15 cm
/// of one of them, 0.25 s later, give or take; keeps flipping while one is near; never nudges;
/// pulls the plunger by any strength.
class FirstTimer {
  public:
    std::vector<command::Press> operator()(const Scene& scene, const World& world,
                                           const PinballState& state) {
        std::vector<command::Press> presses;
        const auto set = [&](Button button, bool is_down) {
            if (state.is_down[static_cast<std::size_t>(button)] != is_down)
                presses.push_back({button, is_down});
        };
        const auto ticks = [&](double seconds) {
            return static_cast<std::uint64_t>(seconds * world.rate() + 0.5);
        };
        const auto draw = [&](double low, double high, std::uint64_t which) {
            return random_between(low, high, world.seed(), RandomStream::player, 1000 + which,
                                  flips_);
        };
        const std::uint64_t now = world.tick();
        if (now >= up_until_ && now >= up_from_ && is_near(world)) {
            up_from_ = now + ticks(draw(reaction - scatter, reaction + scatter, 0));
            up_until_ = up_from_ + ticks(draw(0.1, 0.25, 1));
            ++flips_;
        }
        const bool is_up = now >= up_from_ && now < up_until_;
        set(Button::left_flipper, is_up);
        set(Button::right_flipper, is_up);
        if (state.phase == PinballState::Phase::over) {
            set(Button::plunger, !state.is_down[static_cast<std::size_t>(Button::plunger)]);
            return presses;
        }
        const bool pulls = state.is_down[static_cast<std::size_t>(Button::plunger)];
        const double pull =
            random_between(0.0, 1.0, world.seed(), RandomStream::player, 1002, pulls_);
        const bool may_launch = state.launch_at == 0 && is_on_plunger(scene, world);
        if (pulls && state.pull >= pull) ++pulls_;
        set(Button::plunger, may_launch && state.pull < pull);
        return presses;
    }

  private:
    static constexpr double reaction = 0.25;  // s
    static constexpr double scatter = 0.08;
    static constexpr double near = 0.15;  // m

    static bool is_near(const World& world) {
        for (const Flipper& flipper : world.flippers()) {
            const auto capsule = index_of(world, flipper.capsule);
            if (!capsule) continue;
            for (std::size_t i = 0; i < world.balls().size(); ++i)
                if (separation(Disc{world.balls().position[i], world.balls().radius[i]},
                               world.capsules().shape[*capsule]) < near)
                    return true;
        }
        return false;
    }

    std::uint64_t up_from_ = 0;
    std::uint64_t up_until_ = 0;
    std::uint64_t flips_ = 0;
    std::uint64_t pulls_ = 0;
};

}  // namespace carom::test
