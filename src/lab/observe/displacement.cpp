#include "lab/observe/displacement.h"

#include <utility>

#include "physics/broad_phase/cell_frame.h"

namespace carom {

void DisplacementMeter::Sums::add(const Sums& more) {
    squares += more.squares;
    products += more.products;
    own_products += more.own_products;
    pairs += more.pairs;
}

std::optional<double> DisplacementMeter::Sums::msd() const {
    return pairs > 0.0 ? std::optional(squares / pairs) : std::nullopt;
}

std::optional<double> DisplacementMeter::Sums::vacf() const {
    return own_products > 0.0 ? std::optional(products / own_products) : std::nullopt;
}

DisplacementMeter::DisplacementMeter(const World& start)
    : tick_length_(start.tick_length()), start_tick_(start.tick()) {
    measure(start);
}

void DisplacementMeter::note_tick(const World& world) {
    measure(world);
}

void DisplacementMeter::note_places(const World& world) {
    const Balls& balls = world.balls();
    const auto& torus = world.model().wrap;
    const std::vector<Place> before = std::exchange(now_, {});
    const std::vector<Vec2> before_in_frame = std::exchange(in_frame_, {});
    std::size_t earlier = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        Place place{balls.id[i], balls.position[i], balls.velocity[i]};
        while (earlier < before.size() && before[earlier].id < place.id)
            ++earlier;
        if (torus && earlier < before.size() && before[earlier].id == place.id)
            place.position =
                before[earlier].position +
                nearest_image(balls.position[i] - before_in_frame[earlier], size(*torus));
        now_.push_back(place);
        if (torus) in_frame_.push_back(balls.position[i]);
    }
}

DisplacementMeter::Sums DisplacementMeter::since(const Origin& origin) const {
    Sums sums;
    std::size_t i = 0;
    for (const Place& then : origin.places) {
        while (i < now_.size() && now_[i].id < then.id)
            ++i;
        if (i == now_.size()) break;
        if (now_[i].id != then.id) continue;
        sums.squares += length_squared(now_[i].position - then.position);
        sums.products += dot(now_[i].velocity, then.velocity);
        sums.own_products += length_squared(then.velocity);
        sums.pairs += 1.0;
    }
    return sums;
}

void DisplacementMeter::halve() {
    for (std::size_t i = 0; 2 * i < sums_.size(); ++i)
        sums_[i] = sums_[2 * i];
    sums_.resize((sums_.size() + 1) / 2);
    lag_ *= 2;
    std::erase_if(origins_, [&](const Origin& origin) {
        return (origin.tick - start_tick_) % (lag_ * origin_lags) != 0;
    });
}

void DisplacementMeter::measure(const World& world) {
    note_places(world);
    const std::uint64_t passed = world.tick() - start_tick_;
    if (passed >= lags * lag_) halve();
    if (passed % (lag_ * origin_lags) == 0) origins_.push_back({world.tick(), now_});
    whole_ = since(origins_.front());
    if (passed % lag_ != 0) return;
    for (const Origin& origin : origins_) {
        const auto lag = static_cast<std::size_t>((world.tick() - origin.tick) / lag_);
        if (lag >= sums_.size()) sums_.resize(lag + 1);
        sums_[lag].add(&origin == &origins_.front() ? whole_ : since(origin));
    }
}

Curve DisplacementMeter::curve_of(std::optional<double> (Sums::*value)() const) const {
    Curve curve{"t", {}};
    for (std::size_t i = 0; i < sums_.size(); ++i)
        if (const auto y = (sums_[i].*value)())
            curve.points.push_back(
                {static_cast<double>(static_cast<std::uint64_t>(i) * lag_) * tick_length_, *y, {}});
    return curve;
}

}  // namespace carom
