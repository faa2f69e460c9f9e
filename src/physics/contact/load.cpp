#include <algorithm>
#include <limits>

#include "physics/contact/solver.h"
#include "physics/laws/bounce.h"
#include "physics/memory/prefetch.h"

// Between the world and the bodies of the solver `contact`.
namespace carom {
namespace {

// The balls lie anywhere in the world's arrays: asked for so many bodies ahead, they are there.
constexpr std::uint32_t ahead = 16;

}  // namespace

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
