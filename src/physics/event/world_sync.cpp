#include "physics/event/world_sync.h"

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>

#include "geometry/f64x2.h"
#include "physics/event/stored_trajectory.h"
#include "physics/laws/free_motion.h"
#include "physics/memory/prefetch.h"
#include "physics/world/same_bits.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

template <typename Real>
Vec2 place_on(const LinearPart<Real>& line, const Real& time) {
    return Vec2(line.position + line.velocity * (time - line.time));
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

U64x2 bits_of(const Vec2& v) {
    return std::bit_cast<U64x2>(F64x2{v.x, v.y});
}

bool are_same(const Capsules& a, const Capsules& b) {
    return a.id == b.id && a.shape == b.shape && a.material == b.material && a.side == b.side;
}

}  // namespace

// Whether the world is, but for positions, velocities and turns, as the last tick left it.
template <typename Real>
bool WorldSync<Real>::is_continued(const World& world) const {
    // The sum stands for the trajectories, which are too many to compare in every tick.
    if (std::is_same_v<Real, double> && (world.memory().paths.size() != balls_.size() ||
                                         world.memory().paths_sum != left_.paths_sum))
        return false;
    return are_spins_left(world) && left_.is_valid && !left_.had_hands &&
           world.held_balls().empty() && world.held_capsules().empty() &&
           left_.tick == world.tick() && left_.rate == world.rate() &&
           left_.model == world.model() && left_.ids.are(world.balls().id) &&
           left_.radii.are(world.balls().radius) &&
           left_.inverse_masses.are(world.balls().inverse_mass) && left_.meets == world.meets() &&
           are_same(left_.capsules, world.capsules());
}

// Whether positions and velocities are as the last tick left them, bit by bit; of many balls on
// lines, by sums. Pre: is_continued.
template <typename Real>
bool WorldSync<Real>::are_left(const World& world) const {
    if (!left_.on_lines)
        return have_same_bits(left_.velocities, world.balls().velocity) &&
               have_same_bits(left_.positions, world.balls().position);
    const std::vector<Vec2>& positions = world.balls().position;
    const std::vector<Vec2>& velocities = world.balls().velocity;
    if (is_summed()) {
        SumOfBits position_sum;
        SumOfBits velocity_sum;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            position_sum.add(bits_of(positions[i]));
            velocity_sum.add(bits_of(velocities[i]));
        }
        return position_sum == left_.position_sum && velocity_sum == left_.velocity_sum;
    }
    U64x2 differ{};
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        const LinearPart<Real>& line = balls_[i].line;
        differ |= bits_of(place_on(line, scene_.now)) ^ bits_of(positions[i]);
        differ |= bits_of(Vec2(line.velocity)) ^ bits_of(velocities[i]);
    }
    return (differ[0] | differ[1]) == 0;
}

template <typename Real>
bool WorldSync<Real>::is_position_left(std::uint32_t ball) const {
    const Vec2& now = scene_.world->balls().position[ball];
    return left_.on_lines ? place_on(balls_[ball].line, scene_.now) == now
                          : left_.positions[ball] == now;
}

template <typename Real>
bool WorldSync<Real>::is_velocity_left(std::uint32_t ball) const {
    const Vec2& now = scene_.world->balls().velocity[ball];
    return left_.on_lines ? Vec2(balls_[ball].line.velocity) == now : left_.velocities[ball] == now;
}

// Balls on lines. A velocity that was there when the tick began is written only where a trajectory
// started; some balls at a time, so that they are still in the cache.
template <typename Real>
void WorldSync<Real>::write_lines(World& world) {
    Balls& balls = SolverAccess(world).balls();
    const std::size_t count = balls_.size();
    const Real began(world.time());
    const bool are_all = is_rebuilt_ || !std::is_same_v<Real, double>;
    if (are_all) clear_paths(world);
    std::array<std::uint32_t, 4096> begun;
    const bool is_summed = this->is_summed();
    SumOfBits position_sum;
    SumOfBits velocity_sum;
    for (std::size_t first = 0; first < count; first += begun.size()) {
        const std::size_t last = std::min(first + begun.size(), count);
        std::size_t begun_count = 0;
        const auto write = [&](std::size_t i) {
            const LinearPart<Real>& line = balls_[i].line;
            const Vec2 place = place_on(line, scene_.end);
            balls.position[i] = place;
            if (is_summed) {
                position_sum.add(bits_of(place));
                velocity_sum.add(bits_of(Vec2(line.velocity)));
            }
            // Without a branch: no processor can predict which.
            begun[begun_count] = static_cast<std::uint32_t>(i);
            begun_count += static_cast<std::size_t>(are_all || !(line.time < began));
        };
        go_through(first, last, count, write, [&](std::size_t soon) {
            balls_.prefetch_neighbour(soon);
            fetch_early(&balls.position[soon]);
        });
        if (!is_unchanged_)
            for (std::size_t i = first; i < last; ++i)
                balls.velocity[i] = Vec2(balls_[i].line.velocity);
        write_begun(world, {begun.data(), begun_count});
    }
    left_.position_sum = position_sum;
    left_.velocity_sum = velocity_sum;
}

// The trajectories of balls on lines that started in this tick.
template <typename Real>
void WorldSync<Real>::write_begun(World& world, std::span<const std::uint32_t> begun) {
    for (std::size_t at = 0; at < begun.size(); ++at) {
        const std::uint32_t i = begun[at];
        SolverAccess(world).balls().velocity[i] = Vec2(balls_[i].line.velocity);
        if constexpr (std::is_same_v<Real, double>) {
            const BallPath& soon = world.memory().paths[begun[std::min(at + 32, begun.size() - 1)]];
            fetch_early(&soon);
            fetch_early(&soon.velocity);
            BallPath& stored = SolverAccess(world).memory().paths[i];
            SolverAccess(world).memory().paths_sum -= sum_of(stored);
            stored = stored_line(is_rebuilt_ ? world.balls().id[i] : stored.id, balls_[i].line);
            SolverAccess(world).memory().paths_sum += sum_of(stored);
        }
    }
}

template <typename Real>
void WorldSync<Real>::write_paths(World& world) {
    Balls& balls = SolverAccess(world).balls();
    const bool is_coasting = !world.model().gravity && !scene_.field.has_drag;
    const std::size_t count = balls_.size();
    const Field<Real>& field = scene_.field;
    const Real end = scene_.end;
    left_.positions.resize(count);
    left_.velocities.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const LinearPart<Real>& line = balls_[i].line;
        Vec2 position;
        Vec2 velocity;
        if (is_coasting && line.motion == Motion::free) {
            position = place_on(line, end);
            velocity = Vec2(line.velocity);
        } else {
            const BallState<Real> state = state_at(balls_.path(i), field, end);
            position = Vec2(state.position);
            velocity = line.motion == Motion::held ? Vec2{} : Vec2(state.velocity);
        }
        if (world.model().wrap) position = wrapped(position, *world.model().wrap);
        // As the trajectory says: a velocity that is limited below differs, and starts a new one.
        balls.position[i] = left_.positions[i] = position;
        balls.velocity[i] = left_.velocities[i] = velocity;
    }
    if (world.model().speed_limit)
        for (Vec2& velocity : balls.velocity)
            velocity = limited(velocity, *world.model().speed_limit);
}

// Makes room for all trajectories to be stored anew.
template <typename Real>
void WorldSync<Real>::clear_paths(World& world) {
    if constexpr (std::is_same_v<Real, double>) {
        SolverAccess(world).memory().paths.assign(balls_.size(), {});
        SolverAccess(world).memory().path_bends.assign(balls_.may_curve() ? balls_.size() : 0, {});
        SolverAccess(world).memory().paths_sum = balls_.size() * sum_of(BallPath{});
    } else {
        left_.carriers.assign(balls_.size(), 0);
    }
}

// Stores the trajectories that started in this tick, or all.
template <typename Real>
void WorldSync<Real>::store_paths(World& world) {
    const auto store = [&](std::uint32_t i) {
        const Trajectory<Real> path = balls_.path(i);
        if constexpr (!std::is_same_v<Real, double>) {
            left_.carriers[i] = sum_of_carriers(world, path.support, path.second_support);
        } else {
            BallPath& stored = SolverAccess(world).memory().paths[i];
            const BallPath before = stored;
            stored = stored_line(world.balls().id[i], path);
            if (!balls_.may_curve()) {
                SolverAccess(world).memory().paths_sum += sum_of(stored) - sum_of(before);
                return;
            }
            PathBend& bend = SolverAccess(world).memory().path_bends[i];
            SolverAccess(world).memory().paths_sum -= sum_of(before, bend);
            bend = stored_bend(world, path);
            SolverAccess(world).memory().paths_sum += sum_of(stored, bend);
        }
    };
    const bool are_all = is_rebuilt_ || trajectories_.started().size() >= balls_.size() ||
                         !std::is_same_v<Real, double>;
    if (!are_all) {
        for (const std::uint32_t i : trajectories_.started())
            store(i);
        return;
    }
    clear_paths(world);
    for (std::uint32_t i = 0; i < balls_.size(); ++i)
        store(i);
}

template <typename Real>
void WorldSync<Real>::write(World& world, bool has_stopped) {
    is_rebuilt_ = is_rebuilt_ || has_stopped;
    Balls& balls = SolverAccess(world).balls();
    left_.on_lines = leaves_lines();
    if (left_.on_lines) {
        write_lines(world);
    } else {
        write_paths(world);
        store_paths(world);
    }
    balls.edge_contacts = scatter_counts_;
    if (world.model().spin) write_spins(world);
    for (const KinematicEdge<Real>& moved : kinematic_.edges()) {
        const Edge<Real> shape = moved.edge.at(scene_.end);
        SolverAccess(world).capsules().shape[moved.capsule].start = Vec2(shape.start);
        SolverAccess(world).capsules().shape[moved.capsule].end = Vec2(shape.end);
    }
    if constexpr (std::is_same_v<Real, double>) {
        left_.paths_sum = world.memory().paths_sum;
        write_dense(world);
        SolverAccess(world).memory().paths_gravity = world.model().gravity.value_or(Vec2{});
        SolverAccess(world).memory().paths_drag = world.model().drag.value_or(0.0);
    }
    left_.tick = world.tick() + 1;
    left_.rate = world.rate();
    left_.had_hands = !world.held_balls().empty() || !kinematic_.edges().empty();
    if (is_rebuilt_) {
        SolverAccess(world).memory().paths_obstacles =
            kinematic_.edges().empty() ? sum_of_obstacles(world) : 0;
        left_.model = world.model();
        left_.ids.keep(balls.id);
        left_.radii.keep(balls.radius);
        left_.inverse_masses.keep(balls.inverse_mass);
        left_.meets = world.meets();
        left_.capsules = world.capsules();
    }
    left_.is_valid = !has_stopped;
}

template <typename Real>
bool WorldSync<Real>::are_spins_left(const World& world) const {
    if (!world.model().spin) return true;
    if constexpr (std::is_same_v<Real, double>) {
        if (world.memory().spin_paths.size() != trajectories_.spins().size()) return false;
        for (std::uint32_t i = 0; i < trajectories_.spins().size(); ++i) {
            const SpinPath& path = world.memory().spin_paths[i];
            if (path.time != trajectories_.spin(i).time ||
                path.spin != trajectories_.spin(i).spin ||
                path.rate != trajectories_.spin(i).rate ||
                path.rolls != trajectories_.spin(i).rolls)
                return false;
        }
    }
    return true;
}

template <typename Real>
bool WorldSync<Real>::is_spin_left(std::uint32_t ball) const {
    return !scene_.world->model().spin ||
           static_cast<double>(trajectories_.spin_at(ball, scene_.now)) ==
               scene_.world->balls().spin[ball];
}

template <typename Real>
void WorldSync<Real>::write_spins(World& world) {
    for (std::uint32_t i = 0; i < trajectories_.spins().size(); ++i)
        SolverAccess(world).balls().spin[i] =
            balls_[i].line.motion == Motion::held
                ? 0.0
                : static_cast<double>(trajectories_.spin_at(i, scene_.end));
    if constexpr (std::is_same_v<Real, double>) {
        SolverAccess(world).memory().spin_paths.clear();
        for (const SpinTrajectory<Real>& turn : trajectories_.spins())
            SolverAccess(world).memory().spin_paths.push_back(
                {turn.time, turn.spin, turn.rate, turn.rolls});
    }
    if (world.model().cloth) write_rolls(world);
}

template <typename Real>
bool WorldSync<Real>::is_roll_left(std::uint32_t ball) const {
    return !scene_.world->model().cloth ||
           Vec2(trajectories_.roll_at(ball, scene_.now)) == scene_.world->balls().roll[ball];
}

template <typename Real>
void WorldSync<Real>::write_rolls(World& world) const {
    for (std::uint32_t i = 0; i < balls_.size(); ++i)
        SolverAccess(world).balls().roll[i] = Vec2(trajectories_.roll_at(i, scene_.end));
}

// The balls in dense clusters, for the hybrid step.
template <typename Real>
void WorldSync<Real>::write_dense(World& world) {
    SolverAccess(world).memory().heaped.clear();
    for (const std::uint32_t ball : guard_.dense())
        SolverAccess(world).memory().heaped.push_back(world.balls().id[ball]);
}

template class WorldSync<double>;
template class WorldSync<DoubleDouble>;

}  // namespace carom
