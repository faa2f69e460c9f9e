#include "physics/event/motion/event_memory.h"

namespace carom {
namespace {

template <typename List>
std::size_t bytes_in_list(const List& list) {
    return list.capacity() * sizeof(list[0]);
}

void add_stored(Hash& hash, const StoredLinearPart& line) {
    hash.add(line.id);
    hash.add(line.recent_collisions);
    hash.add(line.motion);
    hash.add(line.time);
    hash.add(line.position);
    hash.add(line.velocity);
}

void add_stored(Hash& hash, const SupportId& support) {
    hash.add(support.kind);
    hash.add(support.across);
    hash.add(support.along);
    hash.add(support.number);
}

void add_stored(Hash& hash, const StoredCurvedPart& curve) {
    hash.add(curve.acceleration);
    hash.add(curve.center);
    add_stored(hash, curve.support);
    add_stored(hash, curve.second_support);
    hash.add(curve.support_digest);
}

void add_stored(Hash& hash, const StoredSpin& spin) {
    hash.add(spin.time);
    hash.add(spin.spin);
    hash.add(spin.rate);
    hash.add(spin.rolls);
}

void add_version_2(Hash& hash, const StoredTrajectories& stored) {
    hash.add(std::uint64_t{stored.lines.size()});
    for (const StoredLinearPart& line : stored.lines)
        add_stored(hash, line);
    for (const StoredCurvedPart& curve : stored.curves)
        add_stored(hash, curve);
    for (const StoredSpin& spin : stored.spins)
        add_stored(hash, spin);
    hash.add(stored.gravity);
    hash.add(stored.drag);
}

// The order and the choice of what is added must never change.
void add_version_1(Hash& hash, const StoredTrajectories& stored, const Model& model) {
    for (std::size_t i = 0; i < stored.lines.size(); ++i) {
        const StoredLinearPart& line = stored.lines[i];
        const StoredCurvedPart curve =
            i < stored.curves.size() ? stored.curves[i] : StoredCurvedPart{};
        hash.add(line.id);
        hash.add(line.time);
        hash.add(line.position);
        hash.add(line.velocity);
        hash.add(curve.acceleration);
        hash.add(line.recent_collisions);
        hash.add(line.motion);
        if (model.cloth) hash.add(curve.center);
    }
    for (const StoredSpin& spin : stored.spins)
        add_stored(hash, spin);
}

}  // namespace

void EventMemory::add_to(Hash& hash, const Model& model, int version) const {
    if (version == 1)
        add_version_1(hash, trajectories, model);
    else
        add_version_2(hash, trajectories);
    add_contacts_to(hash, version);
    if (version != 1) hash.add(std::uint64_t{clustered.size()});
    for (const BallId id : clustered)
        hash.add(id);
}

std::size_t EventMemory::bytes() const {
    return sizeof(EventMemory) - sizeof(ContactMemory) + ContactMemory::bytes() +
           bytes_in_list(trajectories.lines) + bytes_in_list(trajectories.curves) +
           bytes_in_list(trajectories.spins) + bytes_in_list(clustered);
}

void EventMemory::forget_trajectories() {
    trajectories.lines.clear();
    trajectories.curves.clear();
    trajectories.spins.clear();
}

const EventMemory& event_memory(const World& world) {
    static const EventMemory empty;
    const EventMemory* const found = world.memory().find<EventMemory>();
    return found ? *found : empty;
}

EventMemory& edit_event_memory(World& world) {
    return world.edit_memory().use<EventMemory>();
}

}  // namespace carom
