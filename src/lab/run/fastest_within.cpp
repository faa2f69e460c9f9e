#include "lab/run/fastest_within.h"

#include <algorithm>

namespace carom {

std::vector<double> fastest_within(const World& world, std::span<const Contact> contacts,
                                   std::span<const BallId> ids, std::span<const Vec2> velocity) {
    std::vector<Vec2> now(velocity.begin(), velocity.end());
    std::vector<double> fastest;
    for (const Vec2 start : velocity)
        fastest.push_back(length(start));
    const auto give = [&](BallId ball, Vec2 impulse) {
        const auto at = std::ranges::lower_bound(ids, ball);
        const auto index = index_of(world, ball);
        if (at == ids.end() || *at != ball || !index) return;
        const auto place = static_cast<std::size_t>(at - ids.begin());
        now[place] += impulse * world.balls().inverse_mass[*index];
        fastest[place] = std::max(fastest[place], length(now[place]));
    };
    for (const Contact& contact : contacts) {
        const Vec2 impulse = contact.normal * contact.impulse;
        give(BallId{contact.a}, impulse);
        if (contact.kind == ContactKind::ball_ball) give(BallId{contact.b}, -impulse);
    }
    return fastest;
}

}  // namespace carom
