#include "lab/observe/lyapunov.h"

#include <cmath>

#include "physics/broad_phase/nearest_image.h"
#include "physics/world/random.h"

namespace carom {
namespace {

constexpr double smallest = 1e-8;  // radii: the distance of the twin at its start
constexpr double most_growth = 1e3;

// Whether someone other than the solver has changed the world.
bool is_changed(const Stamps& before, const Stamps& now) {
    return before.definition != now.definition || before.capsules != now.capsules ||
           before.roster != now.roster || before.held != now.held;
}

}  // namespace

LyapunovMeter::LyapunovMeter(const SolverSettings& solver, const World& start)
    : solver_(solver), twin_(start), start_tick_(start.tick()) {
    begin_twin(start);
}

void LyapunovMeter::begin_twin(const World& world) {
    const Balls& balls = world.balls();
    const auto count = static_cast<double>(balls.size());
    double radii = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        radii += balls.radius[i];
        squares += length_squared(balls.velocity[i]);
    }
    radius_ = radii > 0.0 ? radii / count : 1.0;
    radius_time_ = squares > 0.0 ? radius_ / std::sqrt(squares / count) : 0.0;
    const double one = smallest * radius_;
    const auto draw = [&](BallId id, std::uint64_t axis) {
        return random_between(-one, one, world.seed(), RandomStream::lab, number(id), axis);
    };
    offsets_.clear();
    for (const BallId id : balls.id)
        offsets_.push_back({{draw(id, 0), draw(id, 1)}, {}});
    set_twin(world, 1.0);
}

// Puts the twin beside the world, at `scale` times the offsets.
void LyapunovMeter::set_twin(const World& world, double scale) {
    twin_ = world;
    Balls& balls = twin_.edit_balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        balls.position[i] += offsets_[i].position * scale;
        balls.velocity[i] += offsets_[i].velocity * scale;
    }
    forget_trajectories(twin_);
    stamps_ = world.stamps();
    reference_ = distance(world);
}

// Pre: the twin has the same balls.
double LyapunovMeter::distance(const World& world) {
    const Balls& balls = world.balls();
    const Balls& others = twin_.balls();
    double sum = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Vec2 apart = nearest_image(world, others.position[i] - balls.position[i]);
        offsets_[i] = {apart, others.velocity[i] - balls.velocity[i]};
        sum += length_squared(apart);
    }
    return std::sqrt(sum) / radius_;
}

// Whether no ball is between its impact in one world and that in the other. A difference that has
// grown much beyond what it was to be is no longer small: then the twin is set back in any case.
bool LyapunovMeter::may_set_back(double distance) const {
    constexpr double no_longer_small = 1e-3;
    constexpr double jump = 1e3;  // in a radius by radius_time_, by the distance
    double sum = 0.0;
    for (const Offset& offset : offsets_)
        sum += length_squared(offset.velocity);
    return distance > no_longer_small || std::sqrt(sum) * radius_time_ / radius_ < jump * distance;
}

void LyapunovMeter::restart_count(const World& world) {
    growth_ = 0.0;
    time_ = 0.0;
    start_tick_ = world.tick();
    series_ = {};
    has_vanished_ = false;
    if (twin_.balls().id == world.balls().id) reference_ = distance(world);
}

void LyapunovMeter::note_tick(const World& world) {
    solver_.tick(twin_);
    if (is_changed(stamps_, world.stamps()) || twin_.balls().id != world.balls().id)
        return begin_twin(world);
    stamps_ = world.stamps();
    const double now = distance(world);
    if (!(now > 0.0) || !std::isfinite(now)) {
        has_vanished_ = has_vanished_ || !world.balls().id.empty();
        return begin_twin(world);
    }
    time_ += world.tick_length();
    growth_ += std::log(now / reference_);
    reference_ = now;
    const bool is_far = now > most_growth * smallest || now < smallest / most_growth;
    if (is_far && may_set_back(now)) set_twin(world, smallest / now);
    const double since = static_cast<double>(world.tick() - start_tick_) * world.tick_length();
    if (const auto value = exponent()) series_.add(world.tick(), {since, *value, {}});
}

std::optional<double> LyapunovMeter::exponent() const {
    if (!(time_ > 0.0) || has_vanished_) return std::nullopt;
    return growth_ / time_;
}

std::optional<double> LyapunovMeter::time() const {
    const std::optional<double> value = exponent();
    if (!value || !(*value > 0.0)) return std::nullopt;
    return 1.0 / *value;
}

}  // namespace carom
