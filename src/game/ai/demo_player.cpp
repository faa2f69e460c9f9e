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

// Traps.
constexpr double slow = 0.9;          // m/s: a ball that it dares to trap
constexpr double trap_reach = 3.0;    // radii between ball and flipper at which it raises it
constexpr double longest_trap = 3.0;  // s after which it gives up
constexpr double longest_aim = 1.0;   // s that a ball may take to roll to the place of the shot
constexpr double still_speed = 0.02;  // m/s
constexpr double still_time = 0.25;   // s that the ball lies still before it lets it go
constexpr double nearest_aim = 0.35;
constexpr double farthest_aim = 0.85;

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
        flip(world, plan);
        return;
    }
}

void DemoPlayer::flip(const World& world, FlipperPlan& plan) {
    plan = {world.tick(), world.tick() + ticks(world, up_time),
            world.tick() + ticks(world, up_time + rest_time)};
    ++flips_;
}

bool DemoPlayer::cradle(const Scene& scene, const World& world, std::size_t which) {
    Cradle& cradle = cradles_[which];
    const Flipper& flipper = world.flippers()[which];
    const auto capsule = index_of(world, flipper.capsule);
    if (!capsule || world.balls().size() != 1) {
        cradle = {};
        return false;
    }
    const Capsule& shape = world.capsules().shape[*capsule];
    const double radius = world.balls().radius[0];
    const Vec2 at = world.balls().position[0];
    const Vec2 velocity = world.balls().velocity[0];
    const double gap = separation(Disc{at, radius}, shape);
    const Vec2 along = shape.end - shape.start;
    const double place = dot(at - shape.start, along) / dot(along, along);
    const std::uint64_t now = world.tick();
    FlipperPlan& plan = plans_[index(scene.table.flipper_buttons[which])];
    if (cradle.aims) {
        if (place >= cradle.place && gap < radius) {
            flip(world, plan);
            cradle = {};
        } else if (gap > 2.0 * radius || now > cradle.since + ticks(world, longest_aim)) {
            cradle = {};
        }
        return cradle.aims;
    }
    if (cradle.holds) {
        const bool is_still = gap < 0.1 * radius && length(velocity) < still_speed;
        cradle.still = is_still ? cradle.still + 1 : 0;
        if (cradle.still > ticks(world, still_time)) {
            cradle = {.aims = true,
                      .since = now,
                      .place = random_between(nearest_aim, farthest_aim, world.seed(),
                                              RandomStream::player, flips_, 100 + which)};
        } else if (gap > 3.0 * trap_reach * radius ||
                   now > cradle.since + ticks(world, longest_trap)) {
            cradle = {};
        }
        return cradle.holds;
    }
    // A flipper that stands on its head has no cradle.
    const bool has_cradle = std::fabs(flipper.rest.x) > std::fabs(flipper.rest.y) &&
                            cross(flipper.rest, Vec2{0.0, 1.0}) * flipper.sweep > 0.0;
    const bool comes = gap < trap_reach * radius && is_above(flipper, shape, at) && place < 0.7;
    if (has_cradle && comes && length(velocity) < slow) cradle = {.holds = true, .since = now};
    return cradle.holds;
}

// Where a push helps: a ball that falls between the flippers may come to one of them, and one that
// comes down beside an inlane may still get into it.
std::optional<Button> DemoPlayer::wanted_nudge(const World& world,
                                               const PinballState& state) const {
    if (world.flippers().size() < 2 || state.tilt_meter > 0.05) return {};
    if (world.tick() < nudged_at_ + ticks(world, nudge_pause)) return {};
    const auto left = index_of(world, world.flippers()[0].capsule);
    const auto right = index_of(world, world.flippers()[1].capsule);
    if (!left || !right) return {};
    const Capsule& a = world.capsules().shape[*left];
    const Capsule& b = world.capsules().shape[*right];
    const double middle = 0.5 * (a.end.x + b.end.x);
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const Vec2 at = world.balls().position[i];
        const double radius = world.balls().radius[i];
        if (!(world.balls().velocity[i].y < 0.0)) continue;
        const double height = at.y - std::max(a.end.y, b.end.y);
        if (std::fabs(at.x - middle) < radius && height > 2.0 * radius && height < 8.0 * radius)
            return flips_ % 2 == 0 ? Button::nudge_left : Button::nudge_right;
        // Inlanes begin some 12 radii above the pivots, and 9 beside them.
        const double rise = at.y - a.start.y;
        const double aside = std::fabs(at.x - middle) - std::fabs(a.start.x - middle);
        if (rise > 12.0 * radius && rise < 20.0 * radius && aside > 7.5 * radius &&
            aside < 12.0 * radius)
            return at.x < middle ? Button::nudge_right : Button::nudge_left;
    }
    return {};
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
    cradles_.resize(world.flippers().size());
    std::array<bool, 2> traps{};
    for (std::size_t i = 0; i < world.flippers().size(); ++i) {
        if (!cradle(scene, world, i)) watch_flipper(scene, world, i);
        if (cradles_[i].holds) traps[index(scene.table.flipper_buttons[i])] = true;
    }
    set(Button::left_flipper, traps[0] || world.tick() < plans_[0].up_until);
    set(Button::right_flipper, traps[1] || world.tick() < plans_[1].up_until);

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
    const auto wanted = is_nudging ? std::nullopt : wanted_nudge(world, state);
    if (wanted) {
        nudged_at_ = world.tick();
        nudge_ = *wanted;
    }
    set(nudge_, nudged_at_ > 0 && world.tick() < nudged_at_ + ticks(world, 0.05));
    return presses;
}

}  // namespace carom
