#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/bounce.h"
#include "physics/contact_solver.h"
#include "physics/fetch.h"
#include "physics/totals.h"

// Between the world and the bodies of the solver `contact`.
namespace carom {
namespace {

// What the sizes of regions depend on.
struct Times {
    double tick = 0.0;     // s
    double substep = 0.0;  // s
    double fall = 0.0;     // length/s^2
    double radii = 0.0;    // that a region may be larger than the ball, for a way of a whole tick
};

// How far each ball may go in a tick before the pairs must be found again: what it needs at its
// speed, but at least `hit`, for what pushes it; of a very fast one, what it needs in a substep.
double margin_for(double speed, double radius, const Times& times, double hit) {
    const double whole = speed * times.tick + times.fall * times.tick * times.tick;
    const double most = std::max(
        times.radii * radius, speed * times.substep + times.fall * times.substep * times.substep);
    return std::max(1.25 * std::min(whole, most), hit) + 0.03 * radius;
}

// A few fast balls get large regions, so that not all pairs are found anew for their sake. Where
// balls typically go further than their radius in a tick, such regions
// would hold a crowd each, and all that meets looks at all of it: there they last for a substep.
double most_radii(const World& world) {
    return typical_way(world) > 1.0 ? 0.5 : 4.0;
}

// The balls lie anywhere in the world's arrays: asked for so many bodies ahead, they are there.
constexpr std::uint32_t ahead = 16;

// Whether it does not show in the result when the pairs are found: nothing is ever pressed, so they
// are in no order, and neither the torus nor spin is rounded anew when bodies are loaded.
bool is_order_free(const World& world) {
    const Model& model = world.model;
    return !model.gravity && !model.lossy && !model.wrap && !model.spin &&
           world.held_balls.empty() && world.held_capsules.empty();
}

}  // namespace

// Regions for all balls, around where they are now.
void ContactSolver::find_homes(World& world) const {
    const Balls& balls = world.balls;
    const Times times{.tick = world.tick_length(),
                      .substep = duration_,
                      .fall = length(gravity_),
                      .radii = most_radii(world)};
    double fastest = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        fastest = std::max(fastest, length_squared(balls.velocity[i]));
        smallest = std::min(smallest, balls.radius[i]);
    }
    fastest = std::sqrt(fastest);
    // Where it does not show when the pairs are found, more for what is hit: so that they last for
    // the tick, mostly.
    const double roomy =
        is_order_free(world) ? std::min(1.15 * fastest * times.tick, 0.4 * smallest) : 0.0;
    Homes& homes = world.homes;
    homes.ball = balls.id;
    homes.place = balls.position;
    homes.margin.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double radius = balls.radius[i];
        const double hit = std::max(std::min(1.1 * fastest * duration_, 0.25 * radius), roomy);
        homes.margin[i] = margin_for(length(balls.velocity[i]), radius, times, hit);
    }
    for (const HeldBall& held : world.held_balls) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        Vec2 way = held.target - balls.position[*index];
        if (wraps_) way = nearest_image(way, torus_);
        homes.margin[*index] += length(way);
    }
}

// Whether the regions of an earlier tick will do, at least for the next substep. What a hand meets
// is asked anew in each tick, and on a torus balls leave their homes behind at its seams.
bool ContactSolver::has_homes(const World& world) const {
    const Homes& homes = world.homes;
    if (wraps_ || !world.held_balls.empty() || !world.held_capsules.empty()) return false;
    if (homes.ball != world.balls.id) return false;
    const Balls& balls = world.balls;
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (!stays_home(balls.position[i] - homes.place[i], balls.velocity[i], homes.margin[i]))
            return false;
    return true;
}

void ContactSolver::begin(World& world) {
    if (!has_homes(world))
        find_homes(world);
    else if (take_up(world))
        return;
    load(world);
}

void ContactSolver::load(const World& world) {
    smallest_ = std::numeric_limits<double>::infinity();
    for (const double radius : world.balls.radius)
        smallest_ = std::min(smallest_, radius);
    guard_ = 0.02 * smallest_;
    near_.sort(world, world.homes.place, world.homes.margin, ball_);
    load_bodies(world);
    near_.find(world, {.ball = ball_, .center = home_, .radius = radius_, .margin = margin_});
    load_hands(world);
    load_pairs(world);
    scenery_.note(world);
}

void ContactSolver::load_bodies(const World& world) {
    const Balls& balls = world.balls;
    const std::size_t count = balls.size();
    still_ = static_cast<std::uint32_t>(count);
    position_.resize(count);
    home_.resize(count);
    radius_.resize(count);
    margin_.resize(count);
    before_.resize(count + 1);
    way_.resize(count + 1);
    mover_.resize(count + 1);
    for (std::uint32_t i = 0; i < still_; ++i) {
        if (i + ahead < still_) {
            const std::uint32_t next = ball_[i + ahead];
            fetch_early(&balls.position[next]);
            fetch_early(&balls.velocity[next]);
            fetch_early(&balls.radius[next]);
            fetch_early(&balls.inverse_mass[next]);
            fetch_early(&world.homes.place[next]);
            fetch_early(&world.homes.margin[next]);
        }
        const std::uint32_t ball = ball_[i];
        position_[i] = balls.position[ball];
        radius_[i] = balls.radius[ball];
        home_[i] = world.homes.place[ball];
        margin_[i] = world.homes.margin[ball];
        mover_[i] = {balls.velocity[ball], 0.0, balls.inverse_mass[ball]};
        if (world.model.spin) mover_[i].rim = balls.spin[ball] * balls.radius[ball];
    }
    before_[still_] = way_[still_] = {};
    mover_[still_] = {};
}

// Goes on with the pairs of the last tick, where they are those that `load` would find. False: they
// are not, or it cannot tell.
bool ContactSolver::take_up(const World& world) {
    const Balls& balls = world.balls;
    if (!hands_.empty() || still_ != balls.size() || !scenery_.is_that_of(world)) return false;
    for (std::uint32_t i = 0; i < still_; ++i) {
        const std::uint32_t ball = ball_[i];
        const bool is_same =
            home_[i] == world.homes.place[ball] && margin_[i] == world.homes.margin[ball] &&
            radius_[i] == balls.radius[ball] && mover_[i].inverse_mass == balls.inverse_mass[ball];
        if (!is_same) return false;
        position_[i] = balls.position[ball];
        mover_[i].velocity = balls.velocity[ball];
        if (world.model.spin) mover_[i].rim = balls.spin[ball] * balls.radius[ball];
    }
    return true;
}

void ContactSolver::load_hands(const World& world) {
    hands_.clear();
    for (std::uint32_t h = 0; h < world.held_balls.size(); ++h) {
        const auto index = index_of(world, world.held_balls[h].id);
        if (!index) continue;
        const auto body = static_cast<std::uint32_t>(
            std::ranges::find(ball_, static_cast<std::uint32_t>(*index)) - ball_.begin());
        hands_.push_back({.index = body, .held = h, .is_ball = true});
        mover_[body].inverse_mass = 0.0;
    }
    for (std::uint32_t h = 0; h < world.held_capsules.size(); ++h)
        if (const auto index = index_of(world, world.held_capsules[h].id))
            hands_.push_back({.index = static_cast<std::uint32_t>(*index),
                              .held = h,
                              .is_driven = world.held_capsules[h].is_driven});
}

void ContactSolver::load_pairs(const World& world) {
    any_damped_ = false;
    has_pairs_of_bodies_ = false;
    std::vector<NearPair>& near = near_.pairs();
    if (!hands_.empty())
        std::erase_if(near, [&](const NearPair& pair) {
            return pair.b < still_ && is_held_body(pair.a) && is_held_body(pair.b);
        });
    for (const Hand& hand : hands_)
        if (!hand.is_ball) add_pairs_of_hand(world, hand);
    if (pairs_.capacity() < near.size()) pairs_.reserve(near.size() + near.size() / 8);
    pairs_.resize(near.size());
    first_impulses(world);
    order_pairs();
    for (std::size_t p = 0; p < near.size(); ++p) {
        pairs_[p] = pair_of(world, near[turn_.empty() ? p : turn_[p]]);
        any_damped_ = any_damped_ || pairs_[p].damped;
    }
    hand_pairs_.clear();
    if (hands_.empty()) return;
    for (std::uint32_t p = 0; p < pairs_.size(); ++p)
        if (pairs_[p].by_hand) hand_pairs_.push_back(p);
}

ContactSolver::Pair ContactSolver::pair_of(const World& world, const NearPair& near) const {
    const std::uint32_t ball = ball_[near.a];
    const std::uint32_t b = near.b;
    const double inverse = mover_[near.a].inverse_mass + mover_[b].inverse_mass;
    Pair pair{.a = near.a,
              .b = b,
              .mass = inverse > 0.0 ? 1.0 / inverse : 0.0,
              .edge = near.edge,
              .across = near.across,
              .along = near.along,
              .by_hand = b > still_ || is_held_body(near.a) || (b < still_ && is_held_body(b))};
    if (near.edge == NearPair::no_edge) {
        const std::uint32_t other = ball_[b];
        const double restitution = world.model.lossy ? std::min(world.balls.restitution[ball],
                                                                world.balls.restitution[other])
                                                     : 1.0;
        pair.bounces = restitution > 0.0;
        pair.damped = pair.bounces && restitution < 1.0;
        if (world.model.spin)
            pair.friction = friction_between(world.kinds[world.balls.kind[ball]],
                                             world.kinds[world.balls.kind[other]]);
    } else {
        const Material& material = world.materials[world.capsules.material[near.edge]];
        pair.bounces = material.restitution > 0.0 || world.model.scatter || material.kick > 0.0;
        pair.damped = pair.bounces && world.model.lossy && !(material.kick > 0.0) &&
                      (material.restitution < 1.0 || material.soften > 0.0);
        if (world.model.spin) pair.friction = material.friction;
    }
    if (const PressedPair* const then = last_impulse(world, pair)) {
        pair.impulse = then->impulse;
        pair.rub = then->rub;
        pair.is_new = false;
    }
    return pair;
}

// Every ball that could be where the held capsule goes in the tick; each such pair has a body of
// its own that stands for the place of the capsule where the two touch.
void ContactSolver::add_pairs_of_hand(const World& world, const Hand& hand) {
    const HeldCapsule& held = world.held_capsules[hand.held];
    const Capsule& shape = world.capsules.shape[hand.index];
    const Box box = join(bounds(shape), bounds({held.start_target, held.end_target, shape.radius}));
    for (std::uint32_t i = 0; i < still_; ++i) {
        if (!overlaps(grow({position_[i], position_[i]}, radius_[i] + margin_[i]), box)) continue;
        if (!kind_meets_material(world, world.balls.kind[ball_[i]],
                                 world.capsules.material[hand.index]))
            continue;
        near_.pairs().push_back(
            {.a = i, .b = static_cast<std::uint32_t>(mover_.size()), .edge = hand.index});
        mover_.push_back({});
        before_.push_back({});
        way_.push_back({});
    }
}

// By ball, where its impulses of the last tick begin.
void ContactSolver::first_impulses(const World& world) {
    const std::vector<PressedPair>& pressed = world.pressed;
    if (pressed.empty()) return;
    first_impulse_.resize(still_ + 1);
    std::uint32_t at = 0;
    for (std::uint32_t ball = 0; ball < still_; ++ball) {
        while (at < pressed.size() && pressed[at].ball < world.balls.id[ball])
            ++at;
        first_impulse_[ball] = at;
    }
    first_impulse_[still_] = static_cast<std::uint32_t>(pressed.size());
}

// The impulses at the end of the last tick, found by number.
const PressedPair* ContactSolver::last_impulse(const World& world, const Pair& pair) const {
    if (world.pressed.empty()) return nullptr;
    const std::vector<BallId>& ids = world.balls.id;
    const std::uint32_t ball = ball_[pair.a];
    const bool on_ball = pair.edge == NearPair::no_edge;
    const std::uint32_t other =
        on_ball ? number(ids[ball_[pair.b]]) : number(world.capsules.id[pair.edge]);
    const ContactKind kind = on_ball ? ContactKind::ball_ball : ContactKind::ball_edge;
    for (std::uint32_t k = first_impulse_[ball]; k < first_impulse_[ball + 1]; ++k) {
        const PressedPair& then = world.pressed[k];
        if (then.ball != ids[ball]) break;
        if (then.other == other && then.kind == kind && then.across == pair.across &&
            then.along == pair.along)
            return &then;
    }
    return nullptr;
}

// Against gravity, by the height of the contact in 4096 steps; what is as high stays in the order
// of the cells. Then into shifts: in each no two pairs have a body in common, and each pair comes
// after all that were before it and share a body with it, so that the result is that of the first
// order, bit by bit, but the processor need not wait for one pair to begin the next.
void ContactSolver::order_pairs() {
    const std::vector<NearPair>& near = near_.pairs();
    turn_.clear();
    if (gravity_ == Vec2{} || near.size() < 2) return;
    const Vec2 up = -gravity_ / length(gravity_);
    height_.resize(still_);
    for (std::uint32_t i = 0; i < still_; ++i)
        height_[i] = dot(up, home_[i]);
    const auto height_of = [&](const NearPair& pair) {
        const double a = height_[pair.a];
        return pair.b < still_ ? a + height_[pair.b] : 2.0 * a;
    };
    double low = height_of(near[0]);
    double high = low;
    for (const NearPair& pair : near) {
        const double height = height_of(pair);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    if (!(high > low)) return;
    constexpr std::size_t steps = 4096;
    const double scale = static_cast<double>(steps - 1) / (high - low);
    begin_.assign(steps + 1, 0);
    shift_.resize(near.size());
    for (std::size_t p = 0; p < near.size(); ++p) {
        const double step = (height_of(near[p]) - low) * scale;
        shift_[p] = static_cast<std::uint32_t>(step > 0.0 ? std::min(step, steps - 1.0) : 0.0);
        ++begin_[shift_[p] + 1];
    }
    for (std::size_t s = 1; s <= steps; ++s)
        begin_[s] += begin_[s - 1];
    upwards_.resize(near.size());
    for (std::uint32_t p = 0; p < near.size(); ++p)
        upwards_[begin_[shift_[p]]++] = p;

    last_shift_.assign(still_ + 1, 0);
    begin_.assign(2, 0);
    for (const std::uint32_t p : upwards_) {
        const NearPair& pair = near[p];
        std::uint32_t& a = last_shift_[pair.a];
        std::uint32_t& b = last_shift_[pair.b < still_ ? pair.b : pair.a];
        a = b = std::max(a, b) + 1;
        shift_[p] = a;
        if (a + 1 >= begin_.size()) begin_.resize(a + 2, 0);
        ++begin_[a + 1];
    }
    for (std::size_t s = 1; s < begin_.size(); ++s)
        begin_[s] += begin_[s - 1];
    turn_.resize(near.size());
    for (const std::uint32_t p : upwards_)
        turn_[begin_[shift_[p]]++] = p;
}

void ContactSolver::store(World& world, std::vector<std::uint8_t>& touched) {
    Balls& balls = world.balls;
    for (std::uint32_t i = 0; i < still_; ++i) {
        if (i + ahead < still_) {
            fetch_early(&balls.position[ball_[i + ahead]]);
            fetch_early(&balls.velocity[ball_[i + ahead]]);
        }
        const std::uint32_t ball = ball_[i];
        balls.position[ball] = wraps_ ? wrapped(position_[i], *world.model.wrap) : position_[i];
        balls.velocity[ball] = mover_[i].velocity;
        if (world.model.spin) balls.spin[ball] = mover_[i].rim / balls.radius[ball];
    }
    for (const Hand& hand : hands_)
        if (hand.is_ball) balls.velocity[ball_[hand.index]] = {};
    store_impulses(world, touched);
}

void ContactSolver::store_impulses(World& world, std::vector<std::uint8_t>& touched) {
    if (is_order_free(world)) {
        world.pressed.clear();
        scenery_.note_impulses(world);
        return;
    }
    first_impulse_.assign(still_ + 1, 0);
    for (Pair& pair : pairs_) {
        pair.is_new = !(pair.impulse > 0.0);
        if (pair.is_new) {
            pair.impulse = pair.rub = 0.0;
            continue;
        }
        ++first_impulse_[ball_[pair.a] + 1];
        touched[ball_[pair.a]] = 1;
        if (pair.b < still_) touched[ball_[pair.b]] = 1;
    }
    for (std::uint32_t i = 1; i <= still_; ++i)
        first_impulse_[i] += first_impulse_[i - 1];
    world.pressed.resize(first_impulse_[still_]);
    for (const Pair& pair : pairs_) {
        if (pair.is_new) continue;
        const std::uint32_t ball = ball_[pair.a];
        const bool on_ball = pair.edge == NearPair::no_edge;
        world.pressed[first_impulse_[ball]++] = {
            .ball = world.balls.id[ball],
            .other = on_ball ? number(world.balls.id[ball_[pair.b]])
                             : number(world.capsules.id[pair.edge]),
            .kind = on_ball ? ContactKind::ball_ball : ContactKind::ball_edge,
            .across = pair.across,
            .along = pair.along,
            .impulse = pair.impulse,
            .rub = pair.rub};
    }
    scenery_.note_impulses(world);
}

}  // namespace carom
