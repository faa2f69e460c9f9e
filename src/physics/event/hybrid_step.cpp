#include "physics/event/hybrid_step.h"

#include <algorithm>
#include <iterator>

#include "physics/event/motion/event_memory.h"
#include "physics/world/columns.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

EventMemory& memory_of(World& world) {
    return SolverAccess(world).memory().use<EventMemory>();
}

}  // namespace

EventOutcome HybridStep::tick(World& world, EventEngine<double>& event, ContactSolver& contact,
                              std::vector<Contact>& contacts, std::vector<std::uint8_t>& touched,
                              const std::function<bool()>& keep_going, bool is_repeated) {
    pressing_.clear();
    standing_before_.clear();
    cluster_.find(world);
    if (!cluster_.has_balls()) {
        // The balls of the cluster no longer exist, or a hand lifts nothing.
        const EventOutcome outcome = event.tick(world, contacts, touched, keep_going, is_repeated);
        if (outcome != EventOutcome::cancelled) memory_of(world).contacts.clear();
        standing_.assign(event.standing().begin(), event.standing().end());
        return outcome;
    }
    for (int attempt = 1;; ++attempt) {
        if (cluster_.is_everything() || attempt > most_attempts) {
            step_all(world, contact, contacts, touched);
            return EventOutcome::done;
        }
        if (attempt > 1 || !has_free_part_of(world)) take_part(world, false, free_);
        free_stamps_.reset();
        const EventOutcome outcome = event.tick(free_.world, free_.contacts, free_.touched,
                                                keep_going, is_repeated || attempt > 1);
        if (outcome == EventOutcome::cancelled) return outcome;
        take_part(world, true, dense_);
        contact.tick(dense_.world, substeps_for(dense_.world), dense_.contacts, dense_.touched);
        const bool free_went_further = widen_reaches(world, free_);
        if (widen_reaches(world, dense_) || free_went_further)
            if (cluster_.find_again(world)) {
                note_standing(event, contact, standing_before_);
                continue;
            }
        write_back(world, touched);
        note_pressing(event, contact);
        merge_contacts(contacts);
        merge_memory(world);
        SolverAccess(world).stamp_motion();
        SolverAccess(world).stamp_memory();
        free_stamps_ = world.stamps();
        return outcome;
    }
}

void HybridStep::step_all(World& world, ContactSolver& contact, std::vector<Contact>& contacts,
                          std::vector<std::uint8_t>& touched) {
    contact.tick(world, substeps_for(world), contacts, touched);
    standing_.assign(contact.standing().begin(), contact.standing().end());
    pressing_.assign(contact.pressing().begin(), contact.pressing().end());
    forget_trajectories(world);
    cluster_.find_staying(world, memory_of(world).clustered);
}

// Whether the free part that the last tick left is that of this tick: the world has not changed
// since, the cluster is the same, and nothing is held. (An edge held in the cluster does not move
// in the free part, which must then be copied again.) If so, prepares the part for the tick.
bool HybridStep::has_free_part_of(const World& world) {
    if (free_stamps_ != world.stamps() || !world.held_balls().empty() ||
        !world.held_capsules().empty())
        return false;
    std::size_t at = 0;
    for (std::uint32_t i = 0; i < world.balls().size(); ++i) {
        if (cluster_.has_ball(i)) continue;
        if (at == free_.ball.size() || free_.ball[at++] != i) return false;
    }
    if (at != free_.ball.size()) return false;
    free_.world.edit_tick() = world.tick();
    free_.contacts.clear();
    free_.touched.assign(free_.ball.size(), 0);
    return true;
}

// Copies the cluster, or all other balls, with everything else that a solver reads in a tick.
void HybridStep::take_part(const World& world, bool of_cluster, Part& part) const {
    const std::size_t count = world.balls().size();
    part.ball.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        if (cluster_.has_ball(i) == of_cluster) part.ball.push_back(i);
    part.contacts.clear();
    part.touched.assign(part.ball.size(), 0);
    World& some = part.world;
    some.edit_definition() = world.definition();
    some.edit_tick() = world.tick();
    some.edit_capsules() = world.capsules();
    some.edit_seesaws() = world.seesaws();
    copy_rows(world.balls(), part.ball, some.edit_balls());
    some.edit_held_balls().clear();
    for (const HeldBall& held : world.held_balls())
        if (index_of(some, held.id)) some.edit_held_balls().push_back(held);
    some.edit_held_capsules().clear();
    for (std::size_t h = 0; h < world.held_capsules().size(); ++h)
        if (cluster_.has_held_capsule(h) == of_cluster)
            some.edit_held_capsules().push_back(world.held_capsules()[h]);
    if (of_cluster) {
        ContactMemory& memory = some.edit_memory().use<ContactMemory>();
        memory.contacts = event_memory(world).contacts;
        memory.stored_energy = event_memory(world).stored_energy;
        memory.reference.clear();
        return;
    }
    EventMemory& memory = some.edit_memory().use<EventMemory>();
    memory.trajectories = event_memory(world).trajectories;
    memory.contacts.clear();
    memory.clustered.clear();
}

// Widens the reach of every ball that got further. Returns whether there is one.
bool HybridStep::widen_reaches(const World& world, const Part& part) {
    bool went_further = false;
    for (std::size_t i = 0; i < part.ball.size(); ++i)
        went_further |= cluster_.widen(world, part.ball[i], part.world.balls().position[i]);
    for (const Contact& contact : part.contacts)
        went_further |= widen(world, contact, part);
    return went_further;
}

bool HybridStep::widen(const World& world, const Contact& contact, const Part& part) {
    const std::vector<double>& radius = part.world.balls().radius;
    bool went_further = cluster_.widen(world, part.ball[contact.a],
                                       contact.point + contact.normal * radius[contact.a]);
    if (contact.kind == ContactKind::ball_ball)
        went_further |= cluster_.widen(world, part.ball[contact.b],
                                       contact.point - contact.normal * radius[contact.b]);
    return went_further;
}

// Balls, and the edges that each part has moved.
void HybridStep::write_back(World& world, std::vector<std::uint8_t>& touched) const {
    for (const Part* const part : {&free_, &dense_}) {
        write_rows(part->world.balls(), part->ball, SolverAccess(world).balls());
        for (std::size_t i = 0; i < part->ball.size(); ++i)
            touched[part->ball[i]] = part->touched[i];
    }
    for (std::size_t h = 0; h < world.held_capsules().size(); ++h) {
        const auto index = index_of(world, world.held_capsules()[h].id);
        if (!index) continue;
        const World& part = cluster_.has_held_capsule(h) ? dense_.world : free_.world;
        SolverAccess(world).capsules().shape[*index] = part.capsules().shape[*index];
        if (const auto seesaw = seesaw_of(world, world.held_capsules()[h].id))
            world.edit_seesaws()[*seesaw] = part.seesaws()[*seesaw];
    }
}

// What both solvers say of the tick, by index in the whole.
void HybridStep::note_pressing(const EventEngine<double>& event, const ContactSolver& contact) {
    standing_.clear();
    note_standing(event, contact, standing_);
    pressing_.assign(contact.pressing().begin(), contact.pressing().end());
    name_by_whole(dense_, pressing_);
}

void HybridStep::note_standing(const EventEngine<double>& event, const ContactSolver& contact,
                               std::vector<std::uint32_t>& standing) const {
    for (const std::uint32_t ball : event.standing())
        standing.push_back(free_.ball[ball]);
    for (const std::uint32_t ball : contact.standing())
        standing.push_back(dense_.ball[ball]);
}

// Trajectories from the free part, persistent contacts from the cluster.
void HybridStep::merge_memory(World& world) {
    EventMemory& memory = memory_of(world);
    const EventMemory& of_free = event_memory(free_.world);
    memory.trajectories = of_free.trajectories;
    if (!world.held_capsules().empty()) memory.trajectories.obstacles = 0;
    cluster_.find_staying(dense_.world, memory.clustered);
    memory.contacts = contact_memory(dense_.world).contacts;
    memory.stored_energy = contact_memory(dense_.world).stored_energy;
    memory.clustered.insert(memory.clustered.end(), of_free.clustered.begin(),
                            of_free.clustered.end());
    std::ranges::sort(memory.clustered);
}

// From indices in the part to those in the whole.
void HybridStep::name_by_whole(const Part& part, std::span<Contact> contacts) {
    for (Contact& contact : contacts) {
        contact.a = part.ball[contact.a];
        if (contact.kind == ContactKind::ball_ball) contact.b = part.ball[contact.b];
    }
}

// By time.
void HybridStep::merge_contacts(std::vector<Contact>& contacts) {
    for (Part* const part : {&free_, &dense_})
        name_by_whole(*part, part->contacts);
    std::ranges::merge(free_.contacts, dense_.contacts, std::back_inserter(contacts), {},
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

}  // namespace carom
