#include "physics/contact/contact_memory.h"

namespace carom {

void ContactMemory::add_contacts_to(Hash& hash, int version) const {
    if (version != 1) hash.add(std::uint64_t{contacts.size()});
    for (const PersistentContact& contact : contacts) {
        hash.add(contact.ball);
        hash.add(contact.other);
        hash.add(contact.kind);
        if (version != 1) {
            hash.add(contact.across);
            hash.add(contact.along);
        }
        hash.add(contact.impulse);
        hash.add(contact.tangential_impulse);
    }
    if (version != 1) {
        hash.add(reference.ball);
        hash.add(reference.position);
        hash.add(reference.skin);
        if (!reference.order.empty()) hash.add(reference.order);
        if (stored_energy != 0.0) hash.add(stored_energy);
        return;
    }
    for (std::size_t i = 0; i < reference.ball.size(); ++i) {
        hash.add(reference.ball[i]);
        hash.add(reference.position[i]);
        hash.add(reference.skin[i]);
    }
}

// Version 2 has four words, all 0, before the contacts, and one after them: there are no
// trajectories and no cluster.
void ContactMemory::add_to(Hash& hash, const Model&, int version) const {
    if (version == 1) return add_contacts_to(hash, version);
    for (int i = 0; i < 4; ++i)
        hash.add(std::uint64_t{0});
    add_contacts_to(hash, version);
    hash.add(std::uint64_t{0});
}

std::size_t ContactMemory::bytes() const {
    return sizeof(ContactMemory) + contacts.capacity() * sizeof(PersistentContact) +
           reference.ball.capacity() * sizeof(BallId) +
           reference.position.capacity() * sizeof(Vec2) +
           reference.skin.capacity() * sizeof(double) +
           reference.order.capacity() * sizeof(std::uint32_t);
}

const ContactMemory& contact_memory(const World& world) {
    static const ContactMemory empty;
    const ContactMemory* const found = world.memory().find<ContactMemory>();
    return found ? *found : empty;
}

ContactMemory& edit_contact_memory(World& world) {
    return world.edit_memory().use<ContactMemory>();
}

}  // namespace carom
