#include "lab/observe/pressure.h"

#include "lab/observe/region.h"

namespace carom {
namespace {

double energy_of_motion(const World& world) {
    const Balls& balls = world.balls();
    double sum = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i)
        sum += length_squared(balls.velocity[i]) / balls.inverse_mass[i];
    return sum / 2.0;
}

// 0 for a ball that is gone: its radius is no longer known.
double radius_of(const World& world, std::uint32_t ball) {
    const auto index = index_of(world, BallId{ball});
    return index ? world.balls().radius[*index] : 0.0;
}

bool may_rest(const Model& model) {
    return (model.gravity && loses_energy(model)) || model.cloth;
}

}  // namespace

PressureMeter::PressureMeter(const Scene& scene, const World& start)
    : counts_all_(!may_rest(start.model())), start_tick_(start.tick()) {
    look_at_region(scene, start);
}

void PressureMeter::look_at_region(const Scene& scene, const World& world) {
    capsules_ = world.stamps().capsules;
    const std::optional<Region> region = region_of(scene, world);
    area_ = region ? std::optional(region->area) : std::nullopt;
}

void PressureMeter::note_tick(const Scene& scene, const World& world,
                              std::span<const Contact> contacts) {
    if (world.stamps().capsules != capsules_) look_at_region(scene, world);
    const double step = world.tick_length();
    time_ += step;
    double virial = 0.0;
    for (const Contact& contact : contacts) {
        if (contact.kind == ContactKind::ball_ball) {
            virial += contact.impulse * (radius_of(world, contact.a) + radius_of(world, contact.b));
            continue;
        }
        if (contact.b >= impulses_.size()) impulses_.resize(contact.b + std::size_t{1}, 0.0);
        impulses_[contact.b] += contact.impulse;
    }
    if (!area_) return;
    motion_ += energy_of_motion(world) * step / *area_;
    collisions_ += virial / (2.0 * *area_);
    if (const auto now = pressure())
        series_.add(world.tick(),
                    {static_cast<double>(world.tick() - start_tick_) * step, *now, {}});
}

std::optional<double> PressureMeter::pressure() const {
    if (!counts_all_ || !area_ || !(time_ > 0.0)) return std::nullopt;
    return (motion_ + collisions_) / time_;
}

std::optional<double> PressureMeter::kinetic_part() const {
    if (!pressure()) return std::nullopt;
    return motion_ / time_;
}

std::optional<double> PressureMeter::pressure_on(const World& world,
                                                 std::span<const CapsuleId> edges) const {
    if (!counts_all_ || !(time_ > 0.0)) return std::nullopt;
    constexpr double pi = 3.14159265358979323846;
    double impulse = 0.0;
    double extent = 0.0;
    for (const CapsuleId id : edges) {
        const auto index = index_of(world, id);
        if (!index) continue;
        const Capsule& shape = world.capsules().shape[*index];
        const double spine = length(shape.end - shape.start);
        extent += spine > 0.0 ? spine : 2.0 * pi * shape.radius;
        if (number(id) < impulses_.size()) impulse += impulses_[number(id)];
    }
    if (!(extent > 0.0)) return std::nullopt;
    return impulse / (extent * time_);
}

}  // namespace carom
