#include <algorithm>
#include <type_traits>

#include "physics/broad_phase/capsule_cells.h"
#include "physics/event/motion/stored_trajectory.h"
#include "physics/event/world_sync.h"

// How a tick begins: with the trajectories of the last one, with some changed, or rebuilt.
namespace carom {

template <typename Real>
WorldSync<Real>::WorldSync(const Parts& parts)
    : scene_(parts.scene),
      balls_(parts.balls),
      space_(parts.space),
      trajectories_(parts.trajectories),
      kinematic_(parts.kinematic),
      rest_(parts.rest),
      cloth_(parts.cloth),
      guard_(parts.guard),
      uniform_(parts.uniform),
      search_(parts.search),
      scatter_counts_(parts.scatter_counts) {}

template <typename Real>
auto WorldSync<Real>::begin() -> Begun {
    const World& world = *scene_.world;
    scatter_counts_ = world.balls().edge_contacts;
    began_ = scene_.now;
    is_rebuilt_ = is_unchanged_ = false;
    trajectories_.begin_log(!writes_lines());
    const Begun begun = begin_from(world);
    last_written_.is_valid = false;
    return begun;
}

template <typename Real>
auto WorldSync<Real>::begin_from(const World& world) -> Begun {
    // An impact with a one-way edge depends on when it is predicted. For a snapshot to go on with
    // the same bits, all of them are predicted when a tick begins.
    constexpr std::uint64_t ticks_between_frame_checks = 64;
    if (!world.model().one_way && is_continued(world) &&
        (world.tick() % ticks_between_frame_checks != 0 || space_.cells().has_frame_of(world))) {
        is_unchanged_ = world.stamps().motion == last_written_.stamps.motion;
        if (is_unchanged_) return Begun::continued;
        std::size_t changed = 0;
        for (std::uint32_t i = 0; i < balls_.size(); ++i)
            changed +=
                !is_position_unchanged(i) || !is_velocity_unchanged(i) || !is_rotation_unchanged(i);
        if (changed == 0) return Begun::continued;
        if (changed <= balls_.size() / 8 + 1) {
            apply_changes(world);
            return Begun::changed;
        }
    }
    is_rebuilt_ = true;
    is_unchanged_ = false;
    trajectories_.begin_log(false);
    rebuild(world);
    return Begun::rebuilt;
}

// Balls that were written through SolverAccess since the last tick, for instance by the stop speed,
// start new trajectories. So do the balls that they supported.
template <typename Real>
void WorldSync<Real>::apply_changes(const World& world) {
    changed_.clear();
    note_collisions();
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
        if (is_position_unchanged(i) && is_velocity_unchanged(i) && is_rotation_unchanged(i))
            continue;
        changed_.push_back(i);
        if (world.model().spin)
            trajectories_.spin(i) = {scene_.now, Real(world.balls().spin[i]), Real{}, false};
        // The balls on it are released before it leaves its place.
        if (balls_[i].line.motion == Motion::resting) rest_.release_supported(i, changed_);
        const Vector<Real> velocity(world.balls().velocity[i]);
        if (!is_position_unchanged(i)) {
            space_.cells().leave(balls_, i);
            trajectories_.start(i, scene_.now, Vector<Real>(world.balls().position[i]), velocity);
            space_.cells().enter(balls_, i, Vec2(balls_[i].line.position));
        } else {
            trajectories_.start(i, scene_.now, trajectories_.state_now(i).position, velocity);
        }
        if (world.model().cloth) balls_.curve(i).center = Vector<Real>(world.balls().roll[i]);
    }
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    for (const std::uint32_t i : changed_)
        balls_[i].line.recent_collisions = collisions_[i];
    for (const std::uint32_t i : changed_)
        rest_.settle(i);
}

// The counts with which balls start new trajectories, whatever has changed them.
template <typename Real>
void WorldSync<Real>::note_collisions() {
    collisions_.resize(balls_.size());
    for (std::uint32_t i = 0; i < balls_.size(); ++i)
        collisions_[i] = guard_.remaining(i);
}

template <typename Real>
void WorldSync<Real>::rebuild(const World& world) {
    const std::size_t count = world.balls().size();
    BallTable<Real> before;
    if constexpr (!std::is_same_v<Real, double>) before = balls_;
    balls_.resize(count, may_curve(world.model()));
    for (std::size_t i = 0; i < count; ++i) {
        balls_.set_trajectory(i, {});
        balls_.plan(i).set_next_event({});
    }
    take_stored(world, before);
    for (std::size_t i = 0; i < count; ++i) {
        balls_.plan(i).inverse_mass = Real(world.balls().inverse_mass[i]);
        balls_[i].radius = Real(world.balls().radius[i]);
    }
    kinematic_.take();
    take_spins(world);
    for (std::size_t i = 0; i < count; ++i)
        is_kept_[i] = is_kept_[i] && !(balls_.plan(i).inverse_mass == Real{}) &&
                      leads_through(balls_.trajectory(i), i);
    const std::uint64_t obstacles = event_memory(world).trajectories.obstacles;
    if (obstacles == 0 || obstacles != digest_of_obstacles(world))
        for (std::uint32_t i = 0; i < count; ++i)
            is_kept_[i] = is_kept_[i] && !has_passed_an_edge(i);
    drop_unsupported();
    note_collisions();
    space_.rebuild();
    for (std::uint32_t i = 0; i < count; ++i)
        start_or_shift(world, i);
    trajectories_.set_all_straight(uniform_.applies(kinematic_));
    trajectories_.reserve_log(writes_lines() ? 0 : count);
    for (std::uint32_t i = 0; i < count; ++i)
        if (!is_kept_[i]) rest_.settle(i);
}

// The trajectories that the world stores, or for other numbers than doubles those of `before`.
template <typename Real>
void WorldSync<Real>::take_stored(const World& world, const BallTable<Real>& before) {
    const std::size_t count = world.balls().size();
    is_kept_.assign(count, 0);
    spin_from_.assign(world.model().spin ? count : 0, -1);
    std::size_t at = 0;
    if constexpr (std::is_same_v<Real, double>) {
        const StoredTrajectories& stored = event_memory(world).trajectories;
        const bool same_field = stored.gravity == world.model().gravity.value_or(Vec2{}) &&
                                stored.drag == world.model().drag.value_or(0.0);
        for (std::size_t i = 0; i < count && same_field; ++i) {
            while (at < stored.lines.size() && stored.lines[at].id < world.balls().id[i])
                ++at;
            if (at >= stored.lines.size() || stored.lines[at].id != world.balls().id[i]) continue;
            const StoredCurvedPart curve =
                at < stored.curves.size() ? stored.curves[at] : StoredCurvedPart{};
            balls_.set_trajectory(i, trajectory_from(stored.lines[at], curve));
            is_kept_[i] = (!world.model().spin || at < stored.spins.size()) &&
                          are_supports_unchanged(balls_.trajectory(i), curve.support_digest);
            if (world.model().spin && is_kept_[i]) spin_from_[i] = static_cast<std::int64_t>(at);
        }
    } else if (last_written_.is_valid && last_written_.tick == world.tick() &&
               last_written_.model == world.model()) {
        for (std::size_t i = 0; i < count; ++i) {
            while (at < last_written_.ids.size() && last_written_.ids[at] < world.balls().id[i])
                ++at;
            if (at >= last_written_.ids.size() || last_written_.ids[at] != world.balls().id[i])
                continue;
            balls_.set_trajectory(i, before.trajectory(at));
            is_kept_[i] =
                are_supports_unchanged(balls_.trajectory(i), last_written_.support_digests[at]);
            if (world.model().spin) spin_from_[i] = static_cast<std::int64_t>(at);
        }
    }
}

template <typename Real>
void WorldSync<Real>::take_spins(const World& world) {
    std::vector<SpinTrajectory<Real>> before;
    if constexpr (!std::is_same_v<Real, double>) before.swap(trajectories_.spins());
    trajectories_.spins().assign(spin_from_.size(), {});
    for (std::uint32_t i = 0; i < spin_from_.size(); ++i) {
        const auto at = static_cast<std::size_t>(spin_from_[i]);
        if (spin_from_[i] < 0) {
            trajectories_.spin(i) = {scene_.now, Real(world.balls().spin[i]), Real{}, false};
        } else if constexpr (std::is_same_v<Real, double>) {
            const StoredSpin& stored = event_memory(world).trajectories.spins[at];
            trajectories_.spin(i) = {stored.time, stored.spin, stored.rate, stored.rolls};
        } else {
            trajectories_.spin(i) = before[at];
        }
    }
}

// If a support starts a new trajectory, so does every ball that rests on it, and so on up the pile.
template <typename Real>
void WorldSync<Real>::drop_unsupported() {
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < is_kept_.size(); ++i) {
            if (!is_kept_[i] || has_support(i)) continue;
            is_kept_[i] = 0;
            changed = true;
        }
    }
}

// A kept trajectory may start some periods away from where the ball is shown; any other starts now.
template <typename Real>
void WorldSync<Real>::start_or_shift(const World& world, std::uint32_t ball) {
    if (is_kept_[ball]) {
        if (!world.model().wrap) return;
        const Vec2 offset =
            Vec2(trajectories_.state_now(ball).position) - world.balls().position[ball];
        const auto periods = [](double x, double period) {
            return static_cast<int>(x / period + (x < 0.0 ? -0.5 : 0.5));
        };
        space_.cells().shift(balls_, ball, periods(offset.x, scene_.period.x),
                             periods(offset.y, scene_.period.y));
        return;
    }
    const bool is_held = balls_.plan(ball).inverse_mass == Real{};
    const Vector<Real> velocity =
        is_held ? balls_[ball].line.velocity : Vector<Real>(world.balls().velocity[ball]);
    if (world.model().spin)
        trajectories_.spin(ball) = {scene_.now, Real(world.balls().spin[ball]), Real{}, false};
    trajectories_.start(ball, scene_.now, Vector<Real>(world.balls().position[ball]), velocity);
    balls_[ball].line.recent_collisions = collisions_[ball];
    if (is_held)
        trajectories_.hold(ball);
    else if (world.model().cloth)
        balls_.curve(ball).center = Vector<Real>(world.balls().roll[ball]);
}

template WorldSync<double>::WorldSync(const Parts&);
template WorldSync<DoubleDouble>::WorldSync(const Parts&);
template auto WorldSync<double>::begin() -> Begun;
template auto WorldSync<DoubleDouble>::begin() -> Begun;

}  // namespace carom
