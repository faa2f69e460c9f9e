#include "physics/event/hybrid_step.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "geometry/closest.h"
#include "physics/broad_phase/capsule_cells.h"
#include "physics/laws/bounce.h"
#include "physics/world/columns.h"

namespace carom {
namespace {

Vec2 torus_of(const World& world) {
    return world.model.wrap ? size(*world.model.wrap) : Vec2{};
}

Vec2 way_between(const World& world, Vec2 from, Vec2 to) {
    return world.model.wrap ? nearest_image(to - from, torus_of(world)) : to - from;
}

}  // namespace

EventOutcome Handover::tick(World& world, EventEngine<double>& event, ContactSolver& contact,
                            std::vector<Contact>& contacts, std::vector<std::uint8_t>& touched,
                            const std::function<bool()>& keep_going) {
    find_reach(world);
    find_heap(world);
    if (std::ranges::find(is_heap_, 1) == is_heap_.end()) {
        // They are gone.
        const EventOutcome outcome = event.tick(world, contacts, touched, keep_going);
        if (outcome != EventOutcome::cancelled) world.pressed.clear();
        return outcome;
    }
    for (int attempt = 1;; ++attempt) {
        const bool is_all = std::ranges::find(is_heap_, 0) == is_heap_.end();
        if (is_all || attempt > most_attempts) {
            contact.tick(world, substeps_for(world), contacts, touched);
            forget_paths(world);
            find_who_stays(world, world.heaped);
            return EventOutcome::done;
        }
        take_part(world, false, free_);
        const EventOutcome outcome =
            event.tick(free_.world, free_.contacts, free_.touched, keep_going);
        if (outcome == EventOutcome::cancelled) return outcome;
        take_part(world, true, heap_);
        contact.tick(heap_.world, substeps_for(heap_.world), heap_.contacts, heap_.touched);
        const bool free_went_further = note_ways(world, free_);
        if (note_ways(world, heap_) || free_went_further) {
            was_heap_ = is_heap_;
            find_heap(world);
            if (is_heap_ != was_heap_) continue;
        }
        put_back(world, free_, touched);
        put_back(world, heap_, touched);
        for (std::size_t h = 0; h < world.held_capsules.size(); ++h) {
            const auto index = index_of(world, world.held_capsules[h].id);
            if (!index) continue;
            const bool is_heap = is_heap_[world.balls.size() + h];
            const World& part = is_heap ? heap_.world : free_.world;
            world.capsules.shape[*index] = part.capsules.shape[*index];
        }
        merge_contacts(contacts);
        world.paths.swap(free_.world.paths);
        world.path_bends.swap(free_.world.path_bends);
        world.spin_paths.swap(free_.world.spin_paths);
        world.paths_sum = free_.world.paths_sum;
        world.paths_obstacles = world.held_capsules.empty() ? free_.world.paths_obstacles : 0;
        world.paths_gravity = free_.world.paths_gravity;
        world.paths_drag = free_.world.paths_drag;
        world.pressed.swap(heap_.world.pressed);
        find_who_stays(heap_.world, world.heaped);
        const std::vector<BallId>& crowded = free_.world.heaped;
        world.heaped.insert(world.heaped.end(), crowded.begin(), crowded.end());
        std::ranges::sort(world.heaped);
        return outcome;
    }
}

const std::vector<BallId>& Handover::heap_of(const World& world) {
    find_reach(world);
    find_heap(world);
    ids_.clear();
    for (std::size_t i = 0; i < world.balls.size(); ++i)
        if (is_heap_[i]) ids_.push_back(world.balls.id[i]);
    return ids_;
}

void Handover::find_reach(const World& world) {
    const Balls& balls = world.balls;
    const double duration = world.tick_length();
    const double fall = length(world.model.gravity.value_or(Vec2{})) * duration * duration;
    reach_.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i)
        reach_[i] = length(balls.velocity[i]) * duration + fall;
    for (const HeldBall& held : world.held_balls)
        if (const auto index = index_of(world, held.id))
            reach_[*index] = length(way_between(world, balls.position[*index], held.target));
}

void Handover::find_heap(const World& world) {
    const std::size_t count = world.balls.size();
    parent_.resize(count + world.held_capsules.size());
    std::iota(parent_.begin(), parent_.end(), 0u);
    near_.find(world, reach_, order_);
    for (const NearPair& pair : near_.pairs())
        if (pair.edge == NearPair::no_edge) unite(order_[pair.a], order_[pair.b]);
    join_what_hands_meet(world);
    is_heap_.assign(parent_.size(), 0);
    for (const BallId id : world.heaped)
        if (const auto index = index_of(world, id))
            is_heap_[root_of(static_cast<std::uint32_t>(*index))] = 1;
    // A root is the lowest of its tree.
    for (std::uint32_t i = 0; i < parent_.size(); ++i)
        is_heap_[i] = is_heap_[root_of(i)];
}

void Handover::join_what_hands_meet(const World& world) {
    const Balls& balls = world.balls;
    for (std::size_t h = 0; h < world.held_capsules.size(); ++h) {
        const HeldCapsule& held = world.held_capsules[h];
        const auto index = index_of(world, held.id);
        if (!index) continue;
        const Capsule& shape = world.capsules.shape[*index];
        const Box box =
            join(bounds(shape), bounds({held.start_target, held.end_target, shape.radius}));
        for (std::uint32_t i = 0; i < balls.size(); ++i)
            if (overlaps(grow({balls.position[i], balls.position[i]}, balls.radius[i] + reach_[i]),
                         box) &&
                kind_meets_material(world, balls.kind[i], world.capsules.material[*index]))
                unite(i, static_cast<std::uint32_t>(balls.size() + h));
    }
}

std::uint32_t Handover::root_of(std::uint32_t node) {
    while (parent_[node] != node)
        node = parent_[node] = parent_[parent_[node]];
    return node;
}

void Handover::unite(std::uint32_t a, std::uint32_t b) {
    a = root_of(a);
    b = root_of(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

// The heap, or all but it. Nothing of a world is left out that a solver looks at in a tick.
void Handover::take_part(const World& world, bool of_heap, Part& part) const {
    const std::size_t count = world.balls.size();
    part.ball.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        if ((is_heap_[i] != 0) == of_heap) part.ball.push_back(i);
    part.contacts.clear();
    part.touched.assign(part.ball.size(), 0);
    World& some = part.world;
    some.model = world.model;
    some.seed = world.seed;
    some.rate = world.rate;
    some.tick = world.tick;
    some.capsules = world.capsules;
    some.kinds = world.kinds;
    some.materials = world.materials;
    some.meets = world.meets;
    copy_rows(world.balls, part.ball, some.balls);
    some.held_balls.clear();
    for (const HeldBall& held : world.held_balls)
        if (index_of(some, held.id)) some.held_balls.push_back(held);
    some.held_capsules.clear();
    for (std::size_t h = 0; h < world.held_capsules.size(); ++h)
        if ((is_heap_[count + h] != 0) == of_heap)
            some.held_capsules.push_back(world.held_capsules[h]);
    some.heaped.clear();
    some.pressed.clear();
    some.homes.clear();
    forget_paths(some);
    if (of_heap) {
        some.pressed = world.pressed;
        return;
    }
    some.paths = world.paths;
    some.path_bends = world.path_bends;
    some.spin_paths = world.spin_paths;
    some.paths_sum = world.paths_sum;
    some.paths_obstacles = world.paths_obstacles;
    some.paths_gravity = world.paths_gravity;
    some.paths_drag = world.paths_drag;
}

// Whether somebody has been further away than its reach, which is so far then.
bool Handover::note_ways(const World& world, const Part& part) {
    bool went_further = false;
    for (std::size_t i = 0; i < part.ball.size(); ++i)
        went_further |= widen_to(world, part.ball[i], part.world.balls.position[i]);
    for (const Contact& contact : part.contacts)
        went_further |= widen(world, contact, part);
    return went_further;
}

bool Handover::widen(const World& world, const Contact& contact, const Part& part) {
    const std::vector<double>& radius = part.world.balls.radius;
    bool went_further =
        widen_to(world, part.ball[contact.a], contact.point + contact.normal * radius[contact.a]);
    if (contact.kind == ContactKind::ball_ball)
        went_further |= widen_to(world, part.ball[contact.b],
                                 contact.point - contact.normal * radius[contact.b]);
    return went_further;
}

bool Handover::widen_to(const World& world, std::uint32_t ball, Vec2 place) {
    const double way = length(way_between(world, world.balls.position[ball], place));
    const double rounding = 1e-6 * world.balls.radius[ball];
    if (way <= reach_[ball] + rounding) return false;
    reach_[ball] = 2.0 * way;
    return true;
}

void Handover::put_back(World& world, const Part& part, std::vector<std::uint8_t>& touched) const {
    write_rows(part.world.balls, part.ball, world.balls);
    for (std::size_t i = 0; i < part.ball.size(); ++i)
        touched[part.ball[i]] = part.touched[i];
}

// In the order of time.
void Handover::merge_contacts(std::vector<Contact>& contacts) {
    for (Part* const part : {&free_, &heap_})
        for (Contact& contact : part->contacts) {
            contact.a = part->ball[contact.a];
            if (contact.kind == ContactKind::ball_ball) contact.b = part->ball[contact.b];
        }
    std::ranges::merge(free_.contacts, heap_.contacts, std::back_inserter(contacts), {},
                       &Contact::time, &Contact::time);
}

// What is pressed overlaps by about as much as it would fall in a substep, times the balls above.
int Handover::substeps_for(const World& heap) {
    const std::vector<double>& radius = heap.balls.radius;
    const double smallest = *std::ranges::min_element(radius);
    const double duration = heap.tick_length();
    const double fall = 0.5 * length(heap.model.gravity.value_or(Vec2{})) * duration * duration;
    int substeps = least_substeps;
    while (substeps < most_substeps && fall > still_fall * smallest * substeps * substeps)
        substeps *= 2;
    return substeps;
}

void Handover::find_who_stays(const World& heap, std::vector<BallId>& heaped) {
    const Balls& balls = heap.balls;
    const Vec2 torus = torus_of(heap);
    stays_.assign(balls.size(), 0);
    for (const PressedPair& pair : heap.pressed) {
        if (pair.kind != ContactKind::ball_ball) continue;
        for (const BallId id : {pair.ball, BallId{pair.other}})
            if (const auto index = index_of(heap, id)) stays_[*index] = 1;
    }
    const auto is_sunk = [&](std::uint32_t ball, Vec2 at, std::size_t edge) {
        const double radius = balls.radius[ball];
        const Capsule& shape = heap.capsules.shape[edge];
        return separation(Disc{at, radius}, shape) < -sunk * radius &&
               (!heap.model.one_way || is_on_solid_side(shape, heap.capsules.side[edge], at));
    };
    margin_.assign(balls.size(), 0.0);
    near_.find(heap, margin_, order_);
    for (const NearPair& pair : near_.pairs()) {
        const std::uint32_t a = order_[pair.a];
        if (pair.edge != NearPair::no_edge) {
            const Vec2 shift{pair.across * torus.x, pair.along * torus.y};
            stays_[a] |= is_sunk(a, balls.position[a] - shift, pair.edge);
            continue;
        }
        const std::uint32_t b = order_[pair.b];
        const double away = length(way_between(heap, balls.position[a], balls.position[b]));
        const double gap = away - balls.radius[a] - balls.radius[b];
        if (gap < -sunk * std::min(balls.radius[a], balls.radius[b])) stays_[a] = stays_[b] = 1;
    }
    for (const HeldCapsule& held : heap.held_capsules)
        if (const auto index = index_of(heap, held.id))
            for (std::uint32_t i = 0; i < balls.size(); ++i)
                stays_[i] |= is_sunk(i, balls.position[i], *index);
    heaped.clear();
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (stays_[i]) heaped.push_back(balls.id[i]);
}

}  // namespace carom
