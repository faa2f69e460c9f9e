#include "game/ai/demo_player.h"

#include <algorithm>
#include <cmath>

#include "game/pinball/pinball.h"
#include "geometry/closest.h"
#include "physics/world/random.h"

namespace carom {
namespace {

constexpr double up_time = 0.12;       // s that a flipper stays up
constexpr double rest_time = 0.10;     // s after that before it considers the next ball
constexpr double flip_lead = 0.010;    // s by which it flips ahead of the ball
constexpr double overreach = 0.4;      // radii above the flipper at which it flips
constexpr double pause_between = 4.0;  // s between two games
constexpr double nudge_pause = 1.5;    // s between two nudges, so that the table does not tilt

// The point along a flipper where it prefers to meet a ball; it varies, so that shots vary. 0 is
// the pivot.
constexpr double nearest_place = 0.42;
constexpr double farthest_place = 0.80;
// Beyond it the ball is lost, so this is the latest point to flip.
constexpr double last_place = 0.97;

std::uint64_t ticks(const World& world, double seconds) {
    return static_cast<std::uint64_t>(seconds * world.rate() + 0.5);
}

std::size_t index(Button button) {
    return static_cast<std::size_t>(button);
}

bool is_above(const Flipper& flipper, const Capsule& shape, Vec2 at) {
    const double side = cross(shape.end - shape.start, at - shape.start);
    return flipper.sweep > 0.0 ? side > 0.0 : side < 0.0;
}

}  // namespace

// Plans a flip for a ball that comes down on the flipper and is nearly there.
void DemoPlayer::watch_flipper(const Scene& scene, const World& world, std::size_t which) {
    const Flipper& flipper = world.flippers()[which];
    FlipperPlan& plan = plans_[index(scene.table.flipper_buttons[which])];
    const auto capsule = index_of(world, flipper.capsule);
    if (!capsule || world.tick() < plan.busy_until) return;
    const Capsule& shape = world.capsules().shape[*capsule];
    const double wanted = random_between(nearest_place, farthest_place, world.seed(),
                                         RandomStream::player, flips_, which);
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const Vec2 at = world.balls().position[i];
        const Vec2 soon = at + world.balls().velocity[i] * flip_lead;
        const double gap = separation(Disc{soon, world.balls().radius[i]}, shape);
        if (gap > overreach * world.balls().radius[i] || !is_above(flipper, shape, at)) continue;
        const double place = closest_parameter(shape.start, shape.end, soon);
        // It waits for a ball that rolls towards the tip, but not for one that falls on the
        // flipper.
        const Vec2 along = shape.end - shape.start;
        const double rolls = dot(world.balls().velocity[i], along) / dot(along, along);
        const double sinking = std::fabs(cross(along, world.balls().velocity[i])) / length(along);
        const bool is_rolling = rolls > 0.0 && sinking < 10.0 * world.balls().radius[i];
        if (place < (is_rolling ? wanted : nearest_place) || place > last_place + 0.02) continue;
        plan = {world.tick(), world.tick() + ticks(world, up_time),
                world.tick() + ticks(world, up_time + rest_time)};
        ++flips_;
        return;
    }
}

// Whether a ball falls between the flippers, where a push to the side may bring it to one of them.
bool DemoPlayer::wants_nudge(const World& world, const PinballState& state) const {
    if (world.flippers().size() < 2 || state.tilt_meter > 0.05) return false;
    if (world.tick() < nudged_at_ + ticks(world, nudge_pause)) return false;
    const auto left = index_of(world, world.flippers()[0].capsule);
    const auto right = index_of(world, world.flippers()[1].capsule);
    if (!left || !right) return false;
    const Vec2 a = world.capsules().shape[*left].end;
    const Vec2 b = world.capsules().shape[*right].end;
    const double middle = 0.5 * (a.x + b.x);
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const Vec2 at = world.balls().position[i];
        const double radius = world.balls().radius[i];
        const double height = at.y - std::max(a.y, b.y);
        if (world.balls().velocity[i].y < 0.0 && std::fabs(at.x - middle) < radius &&
            height > 2.0 * radius && height < 8.0 * radius)
            return true;
    }
    return false;
}

std::vector<command::Press> DemoPlayer::play(const Scene& scene, const World& world,
                                             const PinballState& state) {
    // After a step back, its plans belong to a future that no longer exists.
    if (world.tick() < seen_until_) *this = {};
    seen_until_ = world.tick();
    std::vector<command::Press> presses;
    const auto set = [&](Button button, bool is_down) {
        if (state.is_down[index(button)] != is_down && has_button(scene, button))
            presses.push_back({button, is_down});
    };
    for (std::size_t i = 0; i < world.flippers().size(); ++i)
        watch_flipper(scene, world, i);
    set(Button::left_flipper, world.tick() < plans_[0].up_until);
    set(Button::right_flipper, world.tick() < plans_[1].up_until);

    if (state.phase == PinballState::Phase::over) {
        if (begins_at_ == 0) begins_at_ = world.tick() + ticks(world, pause_between);
        // Press and release: the next tick releases the button.
        set(Button::plunger, world.tick() >= begins_at_ && !state.is_down[index(Button::plunger)]);
        return presses;
    }
    begins_at_ = 0;
    const double pull = random_between(0.45, 1.0, world.seed(), RandomStream::player,
                                       state.games + 1, world.next_ball());
    const bool may_launch = state.launch_at == 0 && is_on_plunger(scene, world);
    set(Button::plunger, may_launch && state.pull < pull);

    const bool is_nudging = world.tick() < nudged_at_ + ticks(world, 0.05);
    if (!is_nudging && wants_nudge(world, state)) {
        nudged_at_ = world.tick();
        nudge_ = flips_ % 2 == 0 ? Button::nudge_left : Button::nudge_right;
    }
    set(nudge_, nudged_at_ > 0 && world.tick() < nudged_at_ + ticks(world, 0.05));
    return presses;
}

}  // namespace carom
