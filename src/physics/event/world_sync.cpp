#include "physics/event/world_sync.h"

#include <algorithm>
#include <array>
#include <type_traits>

#include "physics/event/motion/stored_trajectory.h"
#include "physics/laws/free_motion.h"
#include "physics/memory/prefetch.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

template <typename Real>
Vec2 place_on(const LinearPart<Real>& line, const Real& time) {
    return Vec2(line.position + line.velocity * (time - line.time));
}

StoredTrajectories& stored_in(World& world) {
    return SolverAccess(world).memory().use<EventMemory>().trajectories;
}

// visit(i) from `first` to before `last`, of `count` in all. Where so many do not fit into the
// cache, fetch(i) is called some way ahead.
template <typename Visit, typename Fetch>
void go_through(std::size_t first, std::size_t last, std::size_t count, Visit&& visit,
                Fetch&& fetch) {
    constexpr std::size_t ahead = 40;
    const std::size_t fetched =
        count < too_many_to_cache ? first : std::clamp(count - ahead, first, last);
    for (std::size_t i = first; i < fetched; ++i) {
        fetch(i + ahead);
        visit(i);
    }
    for (std::size_t i = fetched; i < last; ++i)
        visit(i);
}

}  // namespace

// Whether the world is, but for the motion of balls, as the last tick left it.
template <typename Real>
bool WorldSync<Real>::is_continued(const World& world) const {
    const Stamps& now = world.stamps();
    const Stamps& written = last_written_.stamps;
    const bool has_trajectories = !std::is_same_v<Real, double> || now.memory == written.memory;
    return last_written_.is_valid && has_trajectories && last_written_.tick == world.tick() &&
           world.held_balls().empty() && world.held_capsules().empty() &&
           now.held == written.held && now.definition == written.definition &&
           now.capsules == written.capsules && now.roster == written.roster;
}

// What the world shows of the ball at `time`, before any speed limit.
template <typename Real>
auto WorldSync<Real>::shown(std::size_t ball, const Real& time) const -> Shown {
    const World& world = *scene_.world;
    const LinearPart<Real>& line = balls_[ball].line;
    if (writes_lines()) return {place_on(line, time), Vec2(line.velocity)};
    Shown result;
    if (!world.model().gravity && !scene_.field.has_drag && line.motion == Motion::free) {
        result = {place_on(line, time), Vec2(line.velocity)};
    } else {
        const BallState<Real> state = state_at(balls_.trajectory(ball), scene_.field, time);
        result.position = Vec2(state.position);
        if (line.motion != Motion::held) result.velocity = Vec2(state.velocity);
    }
    if (world.model().wrap) result.position = wrapped(result.position, *world.model().wrap);
    return result;
}

template <typename Real>
bool WorldSync<Real>::is_position_unchanged(std::uint32_t ball) const {
    return shown(ball, scene_.now).position == scene_.world->balls().position[ball];
}

template <typename Real>
bool WorldSync<Real>::is_velocity_unchanged(std::uint32_t ball) const {
    return shown(ball, scene_.now).velocity == scene_.world->balls().velocity[ball];
}

// Balls on lines. A velocity that was there when the tick began is written only where a trajectory
// started; some balls at a time, so that they are still in the cache.
template <typename Real>
void WorldSync<Real>::write_lines(World& world) {
    Balls& balls = SolverAccess(world).balls();
    const std::size_t count = balls_.size();
    const bool are_all = is_rebuilt_ || !std::is_same_v<Real, double>;
    if (are_all) clear_stored(world);
    std::array<std::uint32_t, 4096> begun;
    for (std::size_t first = 0; first < count; first += begun.size()) {
        const std::size_t last = std::min(first + begun.size(), count);
        std::size_t begun_count = 0;
        const auto write = [&](std::size_t i) {
            const LinearPart<Real>& line = balls_[i].line;
            balls.position[i] = place_on(line, scene_.end);
            // Without a branch: no processor can predict which.
            begun[begun_count] = static_cast<std::uint32_t>(i);
            begun_count += static_cast<std::size_t>(are_all || !(line.time < began_));
        };
        go_through(first, last, count, write, [&](std::size_t soon) {
            balls_.prefetch_neighbour(soon);
            prefetch_line(&balls.position[soon]);
        });
        if (!is_unchanged_)
            for (std::size_t i = first; i < last; ++i)
                balls.velocity[i] = Vec2(balls_[i].line.velocity);
        write_begun(world, {begun.data(), begun_count});
    }
}

// The trajectories of balls on lines that started in this tick.
template <typename Real>
void WorldSync<Real>::write_begun(World& world, std::span<const std::uint32_t> begun) {
    LargeVector<StoredLinearPart>& lines = stored_in(world).lines;
    for (std::size_t at = 0; at < begun.size(); ++at) {
        const std::uint32_t i = begun[at];
        SolverAccess(world).balls().velocity[i] = Vec2(balls_[i].line.velocity);
        if constexpr (std::is_same_v<Real, double>) {
            const StoredLinearPart& soon = lines[begun[std::min(at + 32, begun.size() - 1)]];
            prefetch_line(&soon);
            prefetch_line(&soon.velocity);
            StoredLinearPart& stored = lines[i];
            stored =
                stored_linear_part(is_rebuilt_ ? world.balls().id[i] : stored.id, balls_[i].line);
        }
    }
}

// Whether the ball has been still on cloth since before this tick, so that the world shows its
// position, velocity and roll already.
template <typename Real>
bool WorldSync<Real>::has_lain_still(std::uint32_t ball) const {
    const LinearPart<Real>& line = balls_[ball].line;
    return is_unchanged_ && line.motion == Motion::still && line.time < began_;
}

// Whether the spin has been constant since before this tick, so that the world shows it already.
template <typename Real>
bool WorldSync<Real>::has_kept_spin(std::uint32_t ball) const {
    const SpinTrajectory<Real>& turn = trajectories_.spin(ball);
    return is_unchanged_ && turn.rate == Real{} && turn.time < began_;
}

template <typename Real>
void WorldSync<Real>::write_states(World& world) {
    Balls& balls = SolverAccess(world).balls();
    moving_.clear();
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
        if (has_lain_still(i)) continue;
        moving_.push_back(i);
        const Shown state = shown(i, scene_.end);
        balls.position[i] = state.position;
        balls.velocity[i] = state.velocity;
    }
}

// Whether the limit has changed a velocity: such a ball starts a new trajectory in the next tick.
template <typename Real>
bool WorldSync<Real>::limit_speeds(World& world) const {
    if (!world.model().speed_limit) return false;
    bool any = false;
    for (Vec2& velocity : SolverAccess(world).balls().velocity) {
        const Vec2 within = limited(velocity, *world.model().speed_limit);
        any = any || !(within == velocity);
        velocity = within;
    }
    return any;
}

// Makes room for all trajectories to be stored anew.
template <typename Real>
void WorldSync<Real>::clear_stored(World& world) {
    if constexpr (std::is_same_v<Real, double>) {
        StoredTrajectories& stored = stored_in(world);
        stored.lines.assign(balls_.size(), {});
        stored.curves.assign(balls_.may_curve() ? balls_.size() : 0, {});
    } else {
        last_written_.support_digests.assign(balls_.size(), 0);
    }
}

// Stores the trajectories that started in this tick, or all.
template <typename Real>
void WorldSync<Real>::store_trajectories(World& world) {
    StoredTrajectories& stored = stored_in(world);
    const auto store = [&](std::uint32_t i) {
        const Trajectory<Real> trajectory = balls_.trajectory(i);
        if constexpr (!std::is_same_v<Real, double>) {
            last_written_.support_digests[i] =
                digest_of_supports(world, trajectory.support, trajectory.second_support);
        } else {
            stored.lines[i] = stored_linear_part(world.balls().id[i], trajectory);
            if (balls_.may_curve()) stored.curves[i] = stored_curved_part(world, trajectory);
        }
    };
    const bool are_all = is_rebuilt_ || trajectories_.started().size() >= balls_.size() ||
                         !std::is_same_v<Real, double>;
    if (!are_all) {
        for (const std::uint32_t i : trajectories_.started())
            store(i);
        return;
    }
    clear_stored(world);
    for (std::uint32_t i = 0; i < balls_.size(); ++i)
        store(i);
}

template <typename Real>
void WorldSync<Real>::write(World& world, bool has_stopped) {
    is_rebuilt_ = is_rebuilt_ || has_stopped;
    is_unchanged_ = is_unchanged_ && !is_rebuilt_;
    bool is_limited = false;
    if (writes_lines()) {
        write_lines(world);
    } else {
        write_states(world);
        is_limited = limit_speeds(world);
        store_trajectories(world);
    }
    const SolverAccess access(world);
    access.balls().edge_contacts = scatter_counts_;
    if (world.model().spin) write_spins(world);
    for (const KinematicEdge<Real>& moved : kinematic_.edges()) {
        if (moved.seesaw != KinematicEdge<Real>::no_seesaw) {
            const Seesaw seesaw = kinematic_.seesaw_at(moved, scene_.end);
            world.edit_seesaws()[moved.seesaw] = seesaw;
            access.capsules().shape[moved.capsule] = seesaw_shape(seesaw, seesaw.angle);
            continue;
        }
        const Edge<Real> shape = moved.edge.at(scene_.end);
        access.capsules().shape[moved.capsule].start = Vec2(shape.start);
        access.capsules().shape[moved.capsule].end = Vec2(shape.end);
    }
    if constexpr (std::is_same_v<Real, double>) {
        write_dense(world);
        stored_in(world).gravity = world.model().gravity.value_or(Vec2{});
        stored_in(world).drag = world.model().drag.value_or(0.0);
    } else if (is_rebuilt_) {
        last_written_.model = world.model();
        last_written_.ids = world.balls().id;
    }
    if (is_rebuilt_)
        stored_in(world).obstacles = kinematic_.edges().empty() ? digest_of_obstacles(world) : 0;
    access.stamp_motion();
    access.stamp_memory();
    last_written_.tick = world.tick() + 1;
    last_written_.stamps = world.stamps();
    if (is_limited) last_written_.stamps.motion = new_stamp();
    last_written_.is_valid = !has_stopped;
}

template <typename Real>
bool WorldSync<Real>::is_spin_unchanged(std::uint32_t ball) const {
    return !scene_.world->model().spin ||
           static_cast<double>(trajectories_.spin_at(ball, scene_.now)) ==
               scene_.world->balls().spin[ball];
}

template <typename Real>
void WorldSync<Real>::write_spins(World& world) {
    const std::size_t count = trajectories_.spins().size();
    Balls& balls = SolverAccess(world).balls();
    std::vector<StoredSpin>* stored = nullptr;
    if constexpr (std::is_same_v<Real, double>) {
        stored = &stored_in(world).spins;
        stored->resize(count);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        if (has_kept_spin(i)) continue;
        balls.spin[i] = balls_[i].line.motion == Motion::held
                            ? 0.0
                            : static_cast<double>(trajectories_.spin_at(i, scene_.end));
        if constexpr (std::is_same_v<Real, double>) {
            const SpinTrajectory<Real>& turn = trajectories_.spin(i);
            (*stored)[i] = {turn.time, turn.spin, turn.rate, turn.rolls};
        }
    }
    if (world.model().cloth) write_rolls(world);
}

template <typename Real>
bool WorldSync<Real>::is_roll_unchanged(std::uint32_t ball) const {
    return !scene_.world->model().cloth ||
           Vec2(trajectories_.roll_at(ball, scene_.now)) == scene_.world->balls().roll[ball];
}

template <typename Real>
void WorldSync<Real>::write_rolls(World& world) const {
    Balls& balls = SolverAccess(world).balls();
    for (const std::uint32_t i : moving_)
        balls.roll[i] = Vec2(trajectories_.roll_at(i, scene_.end));
}

// The balls in dense clusters, for the hybrid step.
template <typename Real>
void WorldSync<Real>::write_dense(World& world) {
    std::vector<BallId>& clustered = SolverAccess(world).memory().use<EventMemory>().clustered;
    clustered.clear();
    for (const std::uint32_t ball : guard_.dense())
        clustered.push_back(world.balls().id[ball]);
}

// What the files beside this one use of it: a member may be instantiated once in a program.
template bool WorldSync<double>::is_continued(const World&) const;
template bool WorldSync<DoubleDouble>::is_continued(const World&) const;
template bool WorldSync<double>::is_position_unchanged(std::uint32_t) const;
template bool WorldSync<DoubleDouble>::is_position_unchanged(std::uint32_t) const;
template bool WorldSync<double>::is_velocity_unchanged(std::uint32_t) const;
template bool WorldSync<DoubleDouble>::is_velocity_unchanged(std::uint32_t) const;
template bool WorldSync<double>::is_spin_unchanged(std::uint32_t) const;
template bool WorldSync<DoubleDouble>::is_spin_unchanged(std::uint32_t) const;
template bool WorldSync<double>::is_roll_unchanged(std::uint32_t) const;
template bool WorldSync<DoubleDouble>::is_roll_unchanged(std::uint32_t) const;
template void WorldSync<double>::write(World&, bool);
template void WorldSync<DoubleDouble>::write(World&, bool);

}  // namespace carom
