#include "game/support/pinball_player.h"

#include "geometry/closest.h"
#include "physics/random.h"

namespace carom::test {

PinballPlayer::PinballPlayer(Scene scene, const SolverSettings& solver)
    : scene_(std::move(scene)), world_(scene_.world), game_(begin_game(scene_)), solver_(solver) {}

void PinballPlayer::press(Button button, bool is_down) {
    if (state().is_down[static_cast<std::size_t>(button)] != is_down)
        obey(scene_, world_, game_, command::Press{button, is_down});
}

// A ball comes down on the outer part of the flipper, and is nearly there.
bool PinballPlayer::is_chance(const Flipper& flipper) const {
    const auto index = index_of(world_, flipper.capsule);
    if (!index) return false;
    const Capsule& shape = world_.capsules.shape[*index];
    for (std::size_t i = 0; i < world_.balls.size(); ++i) {
        const Vec2 at = world_.balls.position[i];
        const Vec2 soon = at + world_.balls.velocity[i] * 0.01;
        const double place = closest_parameter(shape.start, shape.end, soon);
        const double gap = separation(Disc{soon, world_.balls.radius[i]}, shape);
        const bool is_above = flipper.sweep > 0.0
                                  ? cross(shape.end - shape.start, at - shape.start) > 0.0
                                  : cross(shape.end - shape.start, at - shape.start) < 0.0;
        if (is_above && place > 0.45 && gap < 0.4 * world_.balls.radius[i]) return true;
    }
    return false;
}

void PinballPlayer::again() {
    press(Button::plunger, true);
    press(Button::plunger, false);
}

void PinballPlayer::tick() {
    for (std::size_t i = 0; i < world_.flippers.size(); ++i) {
        const Button button = scene_.table.flipper_buttons[i];
        std::uint64_t& until = flip_until_[static_cast<std::size_t>(button)];
        if (until <= world_.tick && is_chance(world_.flippers[i]))
            until = world_.tick + static_cast<std::uint64_t>(0.25 * world_.rate);
        // Up for a tenth of a second, then down again.
        press(button, until > world_.tick + static_cast<std::uint64_t>(0.12 * world_.rate));
    }
    const double pull =
        random_between(0.4, 1.0, world_.seed, RandomStream::player, 1, world_.next_ball);
    press(Button::plunger,
          is_on_plunger(scene_, world_) && state().launch_at == 0 && state().pull < pull);
    solver_.tick(world_);
    follow_rules(scene_, world_, game_, solver_.contacts());
}

}  // namespace carom::test
