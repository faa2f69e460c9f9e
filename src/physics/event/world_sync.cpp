#include <algorithm>
#include <array>
#include <bit>

#include "geometry/f64x2.h"
#include "physics/event/engine.h"
#include "physics/laws/free_motion.h"
#include "physics/world/same_bits.h"

// What a tick leaves in the world, and whether the next one goes on from there.
namespace carom {
namespace {

template <typename Real>
Vec2 place_on(const EventLine<Real>& line, const Real& time) {
    return Vec2(line.position + line.velocity * (time - line.time));
}

// visit(i) from `first` to before `last`, of `count` in all; where so many are not all in the
// cache, fetch(i) some way ahead of it.
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

TwoBits bits_of(const Vec2& v) {
    return std::bit_cast<TwoBits>(Two{v.x, v.y});
}

bool are_same(const Capsules& a, const Capsules& b) {
    return a.id == b.id && a.shape == b.shape && a.material == b.material && a.side == b.side;
}

}  // namespace

template <typename Real>
bool EventEngine<Real>::is_continued(const World& world) const {
    // The sum stands for the paths, which are too many to be compared one by one in every tick.
    if (std::is_same_v<Real, double> &&
        (world.paths.size() != balls_.size() || world.paths_sum != left_.paths_sum))
        return false;
    return are_spins_left(world) && left_.is_valid && !left_.had_hands &&
           world.held_balls.empty() && world.held_capsules.empty() && left_.tick == world.tick &&
           left_.rate == world.rate && left_.model == world.model &&
           left_.ids.are(world.balls.id) && left_.radii.are(world.balls.radius) &&
           left_.inverse_masses.are(world.balls.inverse_mass) && left_.meets == world.meets &&
           are_same(left_.capsules, world.capsules);
}

// Bit by bit; lines that are too many to be gone through for that, by their sums. Pre:
// is_continued.
template <typename Real>
bool EventEngine<Real>::are_left(const World& world) const {
    if (!left_.on_lines)
        return have_same_bits(left_.velocities, world.balls.velocity) &&
               have_same_bits(left_.positions, world.balls.position);
    const std::vector<Vec2>& positions = world.balls.position;
    const std::vector<Vec2>& velocities = world.balls.velocity;
    if (is_summed()) {
        SumOfBits position_sum;
        SumOfBits velocity_sum;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            position_sum.add(bits_of(positions[i]));
            velocity_sum.add(bits_of(velocities[i]));
        }
        return position_sum == left_.position_sum && velocity_sum == left_.velocity_sum;
    }
    TwoBits differ{};
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        const EventLine<Real>& line = balls_[i].line;
        differ |= bits_of(place_on(line, now_)) ^ bits_of(positions[i]);
        differ |= bits_of(Vec2(line.velocity)) ^ bits_of(velocities[i]);
    }
    return (differ[0] | differ[1]) == 0;
}

template <typename Real>
bool EventEngine<Real>::is_position_left(std::uint32_t ball) const {
    const Vec2& now = world_->balls.position[ball];
    return left_.on_lines ? place_on(balls_[ball].line, now_) == now : left_.positions[ball] == now;
}

template <typename Real>
bool EventEngine<Real>::is_velocity_left(std::uint32_t ball) const {
    const Vec2& now = world_->balls.velocity[ball];
    return left_.on_lines ? Vec2(balls_[ball].line.velocity) == now : left_.velocities[ball] == now;
}

// A velocity that was there when the tick began, and a path, only where a path has begun. Some
// balls at a time, so that they are still in the cache then.
template <typename Real>
void EventEngine<Real>::write_lines(World& world) {
    Balls& balls = world.balls;
    const std::size_t count = balls_.size();
    const Real began(world.time());
    const bool are_all = is_begun_anew_ || !std::is_same_v<Real, double>;
    if (are_all) clear_paths(world);
    std::array<std::uint32_t, 4096> begun;
    const bool is_summed = this->is_summed();
    SumOfBits position_sum;
    SumOfBits velocity_sum;
    for (std::size_t first = 0; first < count; first += begun.size()) {
        const std::size_t last = std::min(first + begun.size(), count);
        std::size_t begun_count = 0;
        const auto write = [&](std::size_t i) {
            const EventLine<Real>& line = balls_[i].line;
            const Vec2 place = place_on(line, end_);
            balls.position[i] = place;
            if (is_summed) {
                position_sum.add(bits_of(place));
                velocity_sum.add(bits_of(Vec2(line.velocity)));
            }
            // Which ones nobody can foretell.
            begun[begun_count] = static_cast<std::uint32_t>(i);
            begun_count += static_cast<std::size_t>(are_all || !(line.time < began));
        };
        go_through(first, last, count, write, [&](std::size_t soon) {
            balls_.fetch_neighbour(soon);
            fetch_early(&balls.position[soon]);
        });
        if (!is_all_left_)
            for (std::size_t i = first; i < last; ++i)
                balls.velocity[i] = Vec2(balls_[i].line.velocity);
        write_begun(world, {begun.data(), begun_count});
    }
    left_.position_sum = position_sum;
    left_.velocity_sum = velocity_sum;
}

template <typename Real>
void EventEngine<Real>::write_begun(World& world, std::span<const std::uint32_t> begun) {
    for (std::size_t at = 0; at < begun.size(); ++at) {
        const std::uint32_t i = begun[at];
        world.balls.velocity[i] = Vec2(balls_[i].line.velocity);
        if constexpr (std::is_same_v<Real, double>) {
            const BallPath& soon = world.paths[begun[std::min(at + 32, begun.size() - 1)]];
            fetch_early(&soon);
            fetch_early(&soon.velocity);
            BallPath& stored = world.paths[i];
            world.paths_sum -= sum_of(stored);
            stored = stored_line(is_begun_anew_ ? world.balls.id[i] : stored.id, balls_[i].line);
            world.paths_sum += sum_of(stored);
        }
    }
}

template <typename Real>
void EventEngine<Real>::write_paths(World& world) {
    Balls& balls = world.balls;
    const bool is_coasting = !world.model.gravity && !field_.has_drag;
    const std::size_t count = balls_.size();
    left_.positions.resize(count);
    left_.velocities.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const EventLine<Real>& line = balls_[i].line;
        Vec2 position;
        Vec2 velocity;
        if (is_coasting && line.motion == Motion::free) {
            position = place_on(line, end_);
            velocity = Vec2(line.velocity);
        } else {
            const BallState<Real> state = state_at(balls_.path(i), field_, end_);
            position = Vec2(state.position);
            velocity = line.motion == Motion::held ? Vec2{} : Vec2(state.velocity);
        }
        if (world.model.wrap) position = wrapped(position, *world.model.wrap);
        // What the paths say: a velocity that is limited below differs from it, and begins a new
        // path.
        balls.position[i] = left_.positions[i] = position;
        balls.velocity[i] = left_.velocities[i] = velocity;
    }
    if (world.model.speed_limit)
        for (Vec2& velocity : balls.velocity)
            velocity = limited(velocity, *world.model.speed_limit);
}

// To be stored all of them.
template <typename Real>
void EventEngine<Real>::clear_paths(World& world) {
    if constexpr (std::is_same_v<Real, double>) {
        world.paths.assign(balls_.size(), {});
        world.path_bends.assign(balls_.may_bend() ? balls_.size() : 0, {});
        world.paths_sum = balls_.size() * sum_of(BallPath{});
    } else {
        left_.carriers.assign(balls_.size(), 0);
    }
}

// Those that began in this tick: the others are there already.
template <typename Real>
void EventEngine<Real>::store_paths(World& world) {
    const auto store = [&](std::uint32_t i) {
        const EventPath<Real> path = balls_.path(i);
        if constexpr (!std::is_same_v<Real, double>) {
            left_.carriers[i] = sum_of_carriers(world, path.support, path.second_support);
        } else {
            BallPath& stored = world.paths[i];
            const BallPath before = stored;
            stored = stored_line(world.balls.id[i], path);
            if (!balls_.may_bend()) {
                world.paths_sum += sum_of(stored) - sum_of(before);
                return;
            }
            PathBend& bend = world.path_bends[i];
            world.paths_sum -= sum_of(before, bend);
            bend = stored_bend(world, path);
            world.paths_sum += sum_of(stored, bend);
        }
    };
    const bool are_all =
        is_begun_anew_ || begun_.size() >= balls_.size() || !std::is_same_v<Real, double>;
    if (!are_all) {
        for (const std::uint32_t i : begun_)
            store(i);
        return;
    }
    clear_paths(world);
    for (std::uint32_t i = 0; i < balls_.size(); ++i)
        store(i);
}

template <typename Real>
void EventEngine<Real>::write(World& world) {
    Balls& balls = world.balls;
    left_.on_lines = leaves_lines();
    if (left_.on_lines) {
        write_lines(world);
    } else {
        write_paths(world);
        store_paths(world);
    }
    balls.edge_contacts = edge_contacts_;
    if (world.model.spin) write_spins(world);
    for (const Hand& hand : hands_) {
        const Edge<Real> shape = hand.edge.at(end_);
        world.capsules.shape[hand.capsule].start = Vec2(shape.start);
        world.capsules.shape[hand.capsule].end = Vec2(shape.end);
    }
    if constexpr (std::is_same_v<Real, double>) {
        left_.paths_sum = world.paths_sum;
        write_crowded(world);
        world.paths_gravity = world.model.gravity.value_or(Vec2{});
        world.paths_drag = world.model.drag.value_or(0.0);
    }
    left_.tick = world.tick + 1;
    left_.rate = world.rate;
    left_.had_hands = !world.held_balls.empty() || !hands_.empty();
    if (is_begun_anew_) {
        world.paths_obstacles = hands_.empty() ? sum_of_obstacles(world) : 0;
        left_.model = world.model;
        left_.ids.keep(balls.id);
        left_.radii.keep(balls.radius);
        left_.inverse_masses.keep(balls.inverse_mass);
        left_.meets = world.meets;
        left_.capsules = world.capsules;
    }
    left_.is_valid = true;
}

template class EventEngine<double>;
template class EventEngine<Wide>;

}  // namespace carom
