#include "physics/tick/hands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/tick/kinematic.h"
#include "physics/tick/overlap.h"
#include "physics/tick/totals.h"

namespace carom {
namespace {

// A hand has reached its target within this share of the target's next step.
constexpr double arrival = 1e-6;
// The smallest share that is tried before 0, and the one from which stopped hands start again.
constexpr double least_share = 1.0 / 64.0;
// A ball that a hand pushes becomes no faster than this many times the hand's pace.
constexpr double most_throw = 2.0;
// Pushes make overlaps deeper by no more than this, in radii.
constexpr double most_overlap = 0.02;

// The length of the longer of the displacements of the two ends of an edge.
double longer(Vec2 start, Vec2 end) {
    return std::max(length(start), length(end));
}

const Hand* find_hand(const Hands& hands, bool is_on_ball, std::uint32_t number) {
    for (const Hand& hand : hands.each)
        if (hand.is_on_ball == is_on_ball && hand.number == number) return &hand;
    return nullptr;
}

// The hand after the target has moved: `way` is the distance to the new target, `rest` what was
// left to the old one.
Hand moved_on(const Hands& hands, Hand hand, double displacement, double rest, double rate) {
    const Hand* const last = find_hand(hands, hand.is_on_ball, hand.number);
    if (!last) {
        hand.pace = displacement * rate;
        return hand;
    }
    const double step =
        longer(hand.start_target - last->start_target, hand.end_target - last->end_target);
    if (step == 0.0)
        hand.pace = last->pace;
    else if (rest <= arrival * step)
        hand.pace = step * rate;
    else
        hand.pace = std::max(last->pace, step * rate);
    return hand;
}

// Not a solenoid, and no hinge.
bool is_hand(const HeldCapsule& held) {
    return !held.is_driven && !held.is_seesaw;
}

}  // namespace

bool HandStep::begin(World& world) {
    if (world.held_balls().empty() && std::ranges::none_of(world.held_capsules(), is_hand)) {
        if (!world.hands().each.empty()) world.edit_hands() = {};
        return false;
    }
    const Hands& last = world.hands();
    Hands& hands = hands_;
    hands.each.clear();
    for (const HeldBall& held : world.held_balls()) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        const Vec2 place = world.balls().position[*index];
        const Hand* const was = find_hand(last, true, number(held.id));
        const double rest =
            was ? length(displacement_to_target(world, {held.id, was->start_target}, place)) : 0.0;
        hands.each.push_back(moved_on(
            last, {.is_on_ball = true, .number = number(held.id), .start_target = held.target},
            length(displacement_to_target(world, held, place)), rest, world.rate()));
    }
    for (const HeldCapsule& held : world.held_capsules()) {
        const auto index = index_of(world, held.id);
        if (!index || !is_hand(held)) continue;
        const Capsule& shape = world.capsules().shape[*index];
        const Hand* const was = find_hand(last, false, number(held.id));
        const double rest =
            was ? longer(was->start_target - shape.start, was->end_target - shape.end) : 0.0;
        hands.each.push_back(
            moved_on(last,
                     {.number = number(held.id),
                      .start_target = held.start_target,
                      .end_target = held.end_target},
                     longer(held.start_target - shape.start, held.end_target - shape.end), rest,
                     world.rate()));
    }
    const bool is_first = last.each.empty();
    hands.share = is_first ? 1.0 : last.share;
    hands.overlap = is_first ? deepest_overlap(world) : last.overlap;
    share_ = std::min(1.0, std::max(2.0 * hands.share, least_share));
    fastest_ = 0.0;
    for (const Hand& hand : hands.each)
        fastest_ = std::max(fastest_, hand.pace);
    balls_ = world.held_balls();
    edges_ = world.held_capsules();
    std::swap(world.edit_hands(), hands);
    return true;
}

double HandStep::next_share(double share) {
    return share > least_share ? 0.5 * share : 0.0;
}

void HandStep::aim(World& world, double share) {
    // A free hand goes to its target, without rounding.
    const auto part_of = [&](double displacement, double pace) {
        const double most = pace * world.tick_length() * (1.0 + arrival);
        return share * (displacement > most ? most / displacement : 1.0);
    };
    aimed_balls_ = balls_;
    for (HeldBall& held : aimed_balls_) {
        const auto index = index_of(world, held.id);
        const Hand* const hand = find_hand(world.hands(), true, number(held.id));
        if (!index || !hand) continue;
        const Vec2 place = world.balls().position[*index];
        const Vec2 displacement = displacement_to_target(world, held, place);
        const double part = part_of(length(displacement), hand->pace);
        if (part < 1.0) held.target = place + displacement * part;
    }
    aimed_edges_ = edges_;
    for (HeldCapsule& held : aimed_edges_) {
        const auto index = index_of(world, held.id);
        const Hand* const hand = find_hand(world.hands(), false, number(held.id));
        if (!index || !hand || !is_hand(held)) continue;
        const Capsule& shape = world.capsules().shape[*index];
        const Vec2 start = held.start_target - shape.start;
        const Vec2 end = held.end_target - shape.end;
        const double part = part_of(longer(start, end), hand->pace);
        if (part == 1.0) continue;
        held.start_target = shape.start + start * part;
        held.end_target = shape.end + end * part;
    }
    world.edit_held_balls() = aimed_balls_;
    world.edit_held_capsules() = aimed_edges_;
}

void HandStep::end(World& world, double share) const {
    world.edit_held_balls() = balls_;
    world.edit_held_capsules() = edges_;
    world.edit_hands().share = share;
}

namespace {

double fastest_ball(const World& world) {
    double fastest = 0.0;
    for (const Vec2 velocity : world.balls().velocity)
        fastest = std::max(fastest, length_squared(velocity));
    return std::sqrt(fastest);
}

// Whether a ball has crossed a held edge.
bool has_passed(const World& before, const World& after) {
    for (const HeldCapsule& held : after.held_capsules()) {
        const auto index = index_of(after, held.id);
        if (!index || !is_hand(held)) continue;
        const Capsule& was = before.capsules().shape[*index];
        const Capsule& is = after.capsules().shape[*index];
        for (std::size_t i = 0; i < after.balls().size(); ++i) {
            if (!kind_meets_material(after, after.balls().kind[i],
                                     after.capsules().material[*index]))
                continue;
            if (has_crossed(was, is, before.balls().position[i], after.balls().position[i]))
                return true;
        }
    }
    return false;
}

}  // namespace

// Calls visit(overlap_in) for every pair that may overlap in `world`. overlap_in(any) is the
// relative overlap of that pair in any world.
template <typename Visit>
void HandStep::for_each_overlap(const World& world, Visit&& visit) {
    for (const HeldCapsule& held : world.held_capsules()) {
        const auto index = index_of(world, held.id);
        if (!index) continue;
        const ClassIndex material = world.capsules().material[*index];
        for (std::uint32_t i = 0; i < world.balls().size(); ++i)
            if (kind_meets_material(world, world.balls().kind[i], material))
                visit([i, edge = *index](const World& any) {
                    return relative_overlap(any, i, any.capsules().shape[edge]);
                });
    }
    margin_.assign(world.balls().size(), 0.0);
    near_.find(world, margin_);
    const Vec2 torus = world.model().wrap ? size(*world.model().wrap) : Vec2{};
    for (const NearPair& pair : near_.pairs()) {
        const std::uint32_t a = pair.a;
        if (pair.edge == NearPair::no_edge) {
            visit([a, b = pair.b](const World& any) { return relative_overlap(any, a, b); });
        } else if (!world.model().one_way || world.capsules().side[pair.edge] == Side::both) {
            visit([&, a](const World& any) {
                Capsule edge = any.capsules().shape[pair.edge];
                const Vec2 shift{pair.across * torus.x, pair.along * torus.y};
                edge.start += shift;
                edge.end += shift;
                return relative_overlap(any, a, edge);
            });
        }
    }
}

double HandStep::deepest_overlap(const World& world) {
    double deepest = 0.0;
    for_each_overlap(world, [&](auto&& depth_in) { deepest = std::max(deepest, depth_in(world)); });
    return deepest;
}

// Whether no pair overlaps more than pushes may make it, unless it did before.
bool HandStep::is_free_of_overlap(const World& before, const World& after) {
    const double most = after.hands().overlap + most_overlap;
    bool is_free = true;
    for_each_overlap(after, [&](auto&& depth_in) {
        const double now = depth_in(after);
        is_free = is_free && !(now > most && now > depth_in(before));
    });
    return is_free;
}

bool HandStep::is_sound(const World& before, const World& after) {
    const double fall = length(before.model().gravity.value_or(Vec2{})) * before.tick_length();
    const double most = std::max(most_throw * fastest_, fastest_ball(before)) + 2.0 * fall;
    if (fastest_ball(after) > most * (1.0 + arrival)) return false;
    return !has_passed(before, after) && is_free_of_overlap(before, after);
}

}  // namespace carom
