#include <algorithm>
#include <bit>

#include "physics/event_engine.h"
#include "physics/flight.h"
#include "physics/same_bits.h"

// What a tick leaves in the world, and whether the next one goes on from there.
namespace carom {
namespace {

template <typename Real>
Vec2 place_on(const EventLine<Real>& line, const Real& time) {
    return Vec2(line.position + line.velocity * (time - line.time));
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

// Bit by bit. Pre: is_continued.
template <typename Real>
bool EventEngine<Real>::are_left(const World& world) const {
    if (!left_.on_lines)
        return have_same_bits(left_.velocities, world.balls.velocity) &&
               have_same_bits(left_.positions, world.balls.position);
    std::uint64_t differ = 0;
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    const auto compare = [&](const Vec2& a, const Vec2& b) {
        differ |= (bits(a.x) ^ bits(b.x)) | (bits(a.y) ^ bits(b.y));
    };
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        const std::size_t soon = std::min(i + 40, balls_.size() - 1);
        balls_.fetch_neighbour(soon);
        fetch_early(&world.balls.position[soon]);
        fetch_early(&world.balls.velocity[soon]);
        const EventLine<Real>& line = balls_[i].line;
        compare(place_on(line, now_), world.balls.position[i]);
        compare(Vec2(line.velocity), world.balls.velocity[i]);
    }
    return differ == 0;
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

// Velocities that were there when the tick began only where a path has begun: with the paths.
template <typename Real>
void EventEngine<Real>::write_lines(Balls& balls) {
    const std::size_t count = balls_.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t soon = std::min(i + 40, count - 1);
        balls_.fetch_neighbour(soon);
        fetch_early(&balls.position[soon]);
        balls.position[i] = place_on(balls_[i].line, end_);
    }
    if (std::is_same_v<Real, double> && is_all_left_) return;
    for (std::size_t i = 0; i < count; ++i)
        balls.velocity[i] = Vec2(balls_[i].line.velocity);
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

// Those that began in this tick: the others are there already.
template <typename Real>
void EventEngine<Real>::store_paths(World& world) {
    if constexpr (std::is_same_v<Real, double>) {
        const bool are_all = is_begun_anew_ || begun_.size() >= balls_.size();
        if (are_all) {
            world.paths.assign(balls_.size(), {});
            world.path_bends.assign(balls_.may_bend() ? balls_.size() : 0, {});
            world.paths_sum = balls_.size() * sum_of(BallPath{});
        }
        const auto store = [&](std::uint32_t i) {
            BallPath& stored = world.paths[i];
            const BallPath before = stored;
            stored = stored_line(world.balls.id[i], balls_[i].line);
            if (left_.on_lines) world.balls.velocity[i] = stored.velocity;
            if (!balls_.may_bend()) {
                world.paths_sum += sum_of(stored) - sum_of(before);
                return;
            }
            PathBend& bend = world.path_bends[i];
            world.paths_sum -= sum_of(before, bend);
            bend = stored_bend(world, balls_.path(i));
            world.paths_sum += sum_of(stored, bend);
        };
        if (are_all)
            for (std::uint32_t i = 0; i < balls_.size(); ++i)
                store(i);
        else
            for (std::size_t at = 0; at < begun_.size(); ++at) {
                const std::uint32_t soon = begun_[std::min(at + 16, begun_.size() - 1)];
                fetch_early(&world.paths[soon].id);
                fetch_early(&world.paths[soon].motion);
                fetch_early(&world.balls.velocity[soon]);
                balls_.fetch_neighbour(soon);
                store(begun_[at]);
            }
        left_.paths_sum = world.paths_sum;
    } else {
        left_.carriers.clear();
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            const EventPath<Real> path = balls_.path(i);
            left_.carriers.push_back(sum_of_carriers(world, path.support, path.second_support));
        }
    }
}

template <typename Real>
void EventEngine<Real>::write(World& world) {
    Balls& balls = world.balls;
    left_.on_lines = are_lines_ && !world.model.speed_limit;
    if (left_.on_lines)
        write_lines(world.balls);
    else
        write_paths(world);
    balls.edge_contacts = edge_contacts_;
    if (world.model.spin) write_spins(world);
    for (const Hand& hand : hands_) {
        const Edge<Real> shape = hand.edge.at(end_);
        world.capsules.shape[hand.capsule].start = Vec2(shape.start);
        world.capsules.shape[hand.capsule].end = Vec2(shape.end);
    }
    store_paths(world);
    if constexpr (std::is_same_v<Real, double>) {
        write_crowded(world);
        world.paths_gravity = world.model.gravity.value_or(Vec2{});
        world.paths_drag = world.model.drag.value_or(0.0);
    }
    left_.tick = world.tick + 1;
    left_.rate = world.rate;
    left_.had_hands = !world.held_balls.empty() || !hands_.empty();
    if (is_begun_anew_) {
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
