#include "physics/tick/contact_reports.h"

#include <algorithm>

#include "physics/broad_phase/cell_frame.h"

namespace carom {

// Looked up one by one, the ids of many balls would have to come from far away in memory.
void name_bodies(const World& world, std::span<Contact> contacts) {
    const std::vector<BallId>& ids = world.balls().id;
    const bool are_counted = !ids.empty() && are_consecutive(ids);
    const auto id_of = [&](std::uint32_t ball) {
        return are_counted ? number(ids.front()) + ball : number(ids[ball]);
    };
    for (Contact& contact : contacts) {
        contact.a = id_of(contact.a);
        if (contact.kind == ContactKind::ball_ball) {
            contact.b = id_of(contact.b);
        } else {
            contact.b = number(world.capsules().id[contact.b]);
        }
    }
}

void count_collisions(World& world, std::span<const Contact> contacts) {
    Ledger& ledger = world.edit_ledger();
    for (const Contact& contact : contacts)
        ++(contact.kind == ContactKind::ball_ball ? ledger.ball_ball_collisions
                                                  : ledger.ball_edge_collisions);
}

void wrap_points(const std::optional<Box>& torus, std::span<Contact> contacts) {
    if (!torus) return;
    for (Contact& contact : contacts)
        contact.point = wrapped(contact.point, *torus);
}

void name_standing(const World& world, std::span<const std::uint32_t> balls,
                   std::vector<BallId>& named) {
    for (const std::uint32_t ball : balls)
        named.push_back(world.balls().id[ball]);
    std::ranges::sort(named);
    named.erase(std::unique(named.begin(), named.end()), named.end());
}

}  // namespace carom
