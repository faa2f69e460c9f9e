#include "physics/event/hybrid_step.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>

#include "geometry/closest.h"
#include "physics/broad_phase/capsule_cells.h"
#include "physics/laws/bounce.h"
#include "physics/world/columns.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

Vec2 torus_of(const World& world) {
    return world.model().wrap ? size(*world.model().wrap) : Vec2{};
}

Vec2 displacement(const World& world, Vec2 from, Vec2 to) {
    return world.model().wrap ? nearest_image(to - from, torus_of(world)) : to - from;
}

EventMemory& memory_of(World& world) {
    return SolverAccess(world).memory().use<EventMemory>();
}

// Whether the hand moves what it holds up, however slowly.
bool lifts(const World& world, const Hand& hand) {
    constexpr double least_rise = 0.1;  // sine of the slope
    Vec2 way;
    if (hand.is_on_ball) {
        if (const auto index = index_of(world, BallId{hand.number}))
            way = displacement(world, world.balls().position[*index], hand.start_target);
    } else if (const auto index = index_of(world, CapsuleId{hand.number})) {
        const Capsule& shape = world.capsules().shape[*index];
        way = 0.5 * ((hand.start_target - shape.start) + (hand.end_target - shape.end));
    }
    const Vec2 gravity = world.model().gravity.value_or(Vec2{});
    return dot(way, gravity) < -least_rise * length(way) * length(gravity);
}

}  // namespace

EventOutcome HybridStep::tick(World& world, EventEngine<double>& event, ContactSolver& contact,
                              std::vector<Contact>& contacts, std::vector<std::uint8_t>& touched,
                              const std::function<bool()>& keep_going) {
    find_reach(world);
    find_cluster(world);
    if (!has_clustered_ball(world)) {
        // The balls of the cluster no longer exist, or a hand lifts nothing.
        const EventOutcome outcome = event.tick(world, contacts, touched, keep_going);
        if (outcome != EventOutcome::cancelled) memory_of(world).contacts.clear();
        standing_.assign(event.standing().begin(), event.standing().end());
        return outcome;
    }
    for (int attempt = 1;; ++attempt) {
        const bool is_all = std::ranges::find(is_clustered_, 0) == is_clustered_.end();
        if (is_all || attempt > most_attempts) {
            contact.tick(world, substeps_for(world), contacts, touched);
            standing_.assign(contact.standing().begin(), contact.standing().end());
            forget_trajectories(world);
            find_staying(world, memory_of(world).clustered);
            return EventOutcome::done;
        }
        if (attempt > 1 || !has_free_part_of(world)) take_part(world, false, free_);
        free_stamps_.reset();
        const EventOutcome outcome =
            event.tick(free_.world, free_.contacts, free_.touched, keep_going);
        if (outcome == EventOutcome::cancelled) return outcome;
        take_part(world, true, cluster_);
        contact.tick(cluster_.world, substeps_for(cluster_.world), cluster_.contacts,
                     cluster_.touched);
        const bool free_went_further = widen_reaches(world, free_);
        if (widen_reaches(world, cluster_) || free_went_further) {
            was_clustered_ = is_clustered_;
            find_cluster(world);
            if (is_clustered_ != was_clustered_) continue;
        }
        write_back(world, free_, touched);
        write_back(world, cluster_, touched);
        standing_.clear();
        for (const std::uint32_t ball : event.standing())
            standing_.push_back(free_.ball[ball]);
        for (const std::uint32_t ball : contact.standing())
            standing_.push_back(cluster_.ball[ball]);
        for (std::size_t h = 0; h < world.held_capsules().size(); ++h) {
            const auto index = index_of(world, world.held_capsules()[h].id);
            if (!index) continue;
            const bool is_clustered = is_clustered_[world.balls().size() + h];
            const World& part = is_clustered ? cluster_.world : free_.world;
            SolverAccess(world).capsules().shape[*index] = part.capsules().shape[*index];
        }
        merge_contacts(contacts);
        EventMemory& memory = memory_of(world);
        const EventMemory& of_free = event_memory(free_.world);
        memory.trajectories = of_free.trajectories;
        if (!world.held_capsules().empty()) memory.trajectories.obstacles = 0;
        find_staying(cluster_.world, memory.clustered);
        memory.contacts.swap(SolverAccess(cluster_.world).memory().use<ContactMemory>().contacts);
        memory.clustered.insert(memory.clustered.end(), of_free.clustered.begin(),
                                of_free.clustered.end());
        std::ranges::sort(memory.clustered);
        SolverAccess(world).stamp_motion();
        SolverAccess(world).stamp_memory();
        free_stamps_ = world.stamps();
        return outcome;
    }
}

// Whether the free part, as the last tick left it, is that of this tick: nobody has changed the
// world since, and nothing was held, whether in this part or in the cluster. A held edge of the
// cluster stands still in the free part, which must then be taken anew. Prepares the part if so.
bool HybridStep::has_free_part_of(const World& world) {
    if (free_stamps_ != world.stamps() || !world.held_balls().empty() ||
        !world.held_capsules().empty())
        return false;
    std::size_t at = 0;
    for (std::uint32_t i = 0; i < world.balls().size(); ++i) {
        if (is_clustered_[i]) continue;
        if (at == free_.ball.size() || free_.ball[at++] != i) return false;
    }
    if (at != free_.ball.size()) return false;
    free_.world.edit_tick() = world.tick();
    free_.contacts.clear();
    free_.touched.assign(free_.ball.size(), 0);
    return true;
}

const std::vector<BallId>& HybridStep::cluster_of(const World& world) {
    find_reach(world);
    find_cluster(world);
    ids_.clear();
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        if (is_clustered_[i]) ids_.push_back(world.balls().id[i]);
    return ids_;
}

void HybridStep::find_reach(const World& world) {
    const Balls& balls = world.balls();
    const double duration = world.tick_length();
    const double fall = length(world.model().gravity.value_or(Vec2{})) * duration * duration;
    reach_.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i)
        reach_[i] = length(balls.velocity[i]) * duration + fall;
    for (const HeldBall& held : world.held_balls())
        if (const auto index = index_of(world, held.id))
            reach_[*index] = length(displacement(world, balls.position[*index], held.target));
}

void HybridStep::find_cluster(const World& world) {
    const std::size_t count = world.balls().size();
    parent_.resize(count + world.held_capsules().size());
    std::iota(parent_.begin(), parent_.end(), 0u);
    near_.find(world, reach_, order_);
    for (const NearPair& pair : near_.pairs())
        if (pair.edge == NearPair::no_edge) unite(order_[pair.a], order_[pair.b]);
    unite_held_capsules(world);
    is_clustered_.assign(parent_.size(), 0);
    for (const BallId id : event_memory(world).clustered)
        if (const auto index = index_of(world, id))
            is_clustered_[root_of(static_cast<std::uint32_t>(*index))] = 1;
    for (const Hand& hand : world.hands().each)
        if (lifts(world, hand))
            if (const auto node = node_of(world, hand)) is_clustered_[root_of(*node)] = 1;
    // A root is the lowest node of its tree.
    for (std::uint32_t i = 0; i < parent_.size(); ++i)
        is_clustered_[i] = is_clustered_[root_of(i)];
}

bool HybridStep::has_clustered_ball(const World& world) const {
    const auto balls = std::span(is_clustered_).first(world.balls().size());
    return std::ranges::find(balls, 1) != balls.end();
}

// The node of what the hand holds.
std::optional<std::uint32_t> HybridStep::node_of(const World& world, const Hand& hand) {
    if (hand.is_on_ball) {
        const auto index = index_of(world, BallId{hand.number});
        return index ? std::optional(static_cast<std::uint32_t>(*index)) : std::nullopt;
    }
    const auto place = std::ranges::lower_bound(world.held_capsules(), CapsuleId{hand.number}, {},
                                                &HeldCapsule::id);
    if (place == world.held_capsules().end() || place->id != CapsuleId{hand.number})
        return std::nullopt;
    const auto held = static_cast<std::size_t>(place - world.held_capsules().begin());
    return static_cast<std::uint32_t>(world.balls().size() + held);
}

bool HybridStep::is_needed(const World& world) {
    const std::vector<Hand>& hands = world.hands().each;
    if (hands.empty()) return !event_memory(world).clustered.empty();
    if (std::ranges::any_of(hands, [&](const Hand& hand) { return lifts(world, hand); }))
        return true;
    return !event_memory(world).clustered.empty() && world.balls().size() > most_pushed;
}

void HybridStep::unite_held_capsules(const World& world) {
    const Balls& balls = world.balls();
    for (std::size_t h = 0; h < world.held_capsules().size(); ++h) {
        const HeldCapsule& held = world.held_capsules()[h];
        const auto index = index_of(world, held.id);
        if (!index) continue;
        const Capsule& shape = world.capsules().shape[*index];
        const Box box =
            join(bounds(shape), bounds({held.start_target, held.end_target, shape.radius}));
        for (std::uint32_t i = 0; i < balls.size(); ++i)
            if (overlaps(grow({balls.position[i], balls.position[i]}, balls.radius[i] + reach_[i]),
                         box) &&
                kind_meets_material(world, balls.kind[i], world.capsules().material[*index]))
                unite(i, static_cast<std::uint32_t>(balls.size() + h));
    }
}

std::uint32_t HybridStep::root_of(std::uint32_t node) {
    while (parent_[node] != node)
        node = parent_[node] = parent_[parent_[node]];
    return node;
}

void HybridStep::unite(std::uint32_t a, std::uint32_t b) {
    a = root_of(a);
    b = root_of(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

// The cluster, or all but it, with everything of the world that a solver reads in a tick.
void HybridStep::take_part(const World& world, bool of_cluster, Part& part) const {
    const std::size_t count = world.balls().size();
    part.ball.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        if ((is_clustered_[i] != 0) == of_cluster) part.ball.push_back(i);
    part.contacts.clear();
    part.touched.assign(part.ball.size(), 0);
    World& some = part.world;
    some.edit_definition() = world.definition();
    some.edit_tick() = world.tick();
    some.edit_capsules() = world.capsules();
    copy_rows(world.balls(), part.ball, some.edit_balls());
    some.edit_held_balls().clear();
    for (const HeldBall& held : world.held_balls())
        if (index_of(some, held.id)) some.edit_held_balls().push_back(held);
    some.edit_held_capsules().clear();
    for (std::size_t h = 0; h < world.held_capsules().size(); ++h)
        if ((is_clustered_[count + h] != 0) == of_cluster)
            some.edit_held_capsules().push_back(world.held_capsules()[h]);
    if (of_cluster) {
        ContactMemory& memory = some.edit_memory().use<ContactMemory>();
        memory.contacts = event_memory(world).contacts;
        memory.reference.clear();
        return;
    }
    EventMemory& memory = some.edit_memory().use<EventMemory>();
    memory.trajectories = event_memory(world).trajectories;
    memory.contacts.clear();
    memory.clustered.clear();
}

// Widens the reach of every ball that got further. Whether there is one.
bool HybridStep::widen_reaches(const World& world, const Part& part) {
    bool went_further = false;
    for (std::size_t i = 0; i < part.ball.size(); ++i)
        went_further |= widen_to(world, part.ball[i], part.world.balls().position[i]);
    for (const Contact& contact : part.contacts)
        went_further |= widen(world, contact, part);
    return went_further;
}

bool HybridStep::widen(const World& world, const Contact& contact, const Part& part) {
    const std::vector<double>& radius = part.world.balls().radius;
    bool went_further =
        widen_to(world, part.ball[contact.a], contact.point + contact.normal * radius[contact.a]);
    if (contact.kind == ContactKind::ball_ball)
        went_further |= widen_to(world, part.ball[contact.b],
                                 contact.point - contact.normal * radius[contact.b]);
    return went_further;
}

bool HybridStep::widen_to(const World& world, std::uint32_t ball, Vec2 place) {
    const double way = length(displacement(world, world.balls().position[ball], place));
    const double rounding = 1e-6 * world.balls().radius[ball];
    if (way <= reach_[ball] + rounding) return false;
    reach_[ball] = 2.0 * way;
    return true;
}

void HybridStep::write_back(World& world, const Part& part,
                            std::vector<std::uint8_t>& touched) const {
    write_rows(part.world.balls(), part.ball, SolverAccess(world).balls());
    for (std::size_t i = 0; i < part.ball.size(); ++i)
        touched[part.ball[i]] = part.touched[i];
}

// By time.
void HybridStep::merge_contacts(std::vector<Contact>& contacts) {
    for (Part* const part : {&free_, &cluster_})
        for (Contact& contact : part->contacts) {
            contact.a = part->ball[contact.a];
            if (contact.kind == ContactKind::ball_ball) contact.b = part->ball[contact.b];
        }
    std::ranges::merge(free_.contacts, cluster_.contacts, std::back_inserter(contacts), {},
                       &Contact::time, &Contact::time);
}

// Balls under pressure overlap by about the fall of a substep, times the number of balls above.
int HybridStep::substeps_for(const World& cluster) {
    const std::vector<double>& radius = cluster.balls().radius;
    const double smallest = *std::ranges::min_element(radius);
    const double duration = cluster.tick_length();
    const double fall =
        0.5 * length(cluster.model().gravity.value_or(Vec2{})) * duration * duration;
    int substeps = least_substeps;
    while (substeps < most_substeps && fall > most_fall * smallest * substeps * substeps)
        substeps *= 2;
    return substeps;
}

void HybridStep::find_staying(const World& cluster, std::vector<BallId>& staying) {
    const Balls& balls = cluster.balls();
    const Vec2 torus = torus_of(cluster);
    stays_.assign(balls.size(), 0);
    for (const PersistentContact& pair : contact_memory(cluster).contacts) {
        if (pair.kind != ContactKind::ball_ball) continue;
        for (const BallId id : {pair.ball, BallId{pair.other}})
            if (const auto index = index_of(cluster, id)) stays_[*index] = 1;
    }
    const auto is_sunk = [&](std::uint32_t ball, Vec2 at, std::size_t edge) {
        const double radius = balls.radius[ball];
        const Capsule& shape = cluster.capsules().shape[edge];
        return separation(Disc{at, radius}, shape) < -sunk * radius &&
               (!cluster.model().one_way ||
                is_on_solid_side(shape, cluster.capsules().side[edge], at));
    };
    margin_.assign(balls.size(), 0.0);
    near_.find(cluster, margin_, order_);
    for (const NearPair& pair : near_.pairs()) {
        const std::uint32_t a = order_[pair.a];
        if (pair.edge != NearPair::no_edge) {
            const Vec2 shift{pair.across * torus.x, pair.along * torus.y};
            stays_[a] |= is_sunk(a, balls.position[a] - shift, pair.edge);
            continue;
        }
        const std::uint32_t b = order_[pair.b];
        const double away = length(displacement(cluster, balls.position[a], balls.position[b]));
        const double gap = away - balls.radius[a] - balls.radius[b];
        if (gap < -sunk * std::min(balls.radius[a], balls.radius[b])) stays_[a] = stays_[b] = 1;
    }
    for (const HeldCapsule& held : cluster.held_capsules())
        if (const auto index = index_of(cluster, held.id))
            for (std::uint32_t i = 0; i < balls.size(); ++i)
                stays_[i] |= is_sunk(i, balls.position[i], *index);
    staying.clear();
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (stays_[i]) staying.push_back(balls.id[i]);
}

}  // namespace carom
