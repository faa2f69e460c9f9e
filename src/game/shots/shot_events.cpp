#include <algorithm>
#include <iterator>
#include <utility>

#include "game/shots/shots_play.h"
#include "geometry/closest.h"

// The events of a shot, in their order: contacts by time, then places, then pockets.
namespace carom {
namespace {

using Meeting = ShotsState::Meeting;

bool matches(const ShotsPlay& play, std::uint32_t set, std::uint32_t ball) {
    return set == no_subject || is_among(play.scene, play.state, play.scene.rules.balls[set], ball);
}

// Notes that two things meet. True: for the first time in this shot.
bool note(std::vector<Meeting>& met, const Meeting& meeting) {
    const auto at = std::ranges::lower_bound(met, meeting);
    if (at != met.end() && *at == meeting) return false;
    met.insert(at, meeting);
    return true;
}

void meet(ShotsPlay& play, std::uint32_t a, std::uint32_t b) {
    const bool is_first =
        note(play.state.met, {Meeting::What::balls, std::min(a, b), std::max(a, b)});
    happen_if(play.rules(), RuleEvent::balls_meet, [&](const Rule& rule) {
        if (rule.once && !is_first) return false;
        const bool is_forth = matches(play, rule.subject, a) && matches(play, rule.other, b);
        play.it = is_forth ? b : a;
        return is_forth || (matches(play, rule.subject, b) && matches(play, rule.other, a));
    });
}

void hit_edge(ShotsPlay& play, std::uint32_t ball, CapsuleId edge) {
    const bool is_first = note(play.state.met, {Meeting::What::edge, ball, number(edge)});
    happen_if(play.rules(), RuleEvent::rail, [&](const Rule& rule) {
        play.it = ball;
        return (is_first || !rule.once) && matches(play, rule.subject, ball);
    });
    happen_if(play.rules(), RuleEvent::edge_hit, [&](const Rule& rule) {
        play.it = ball;
        return (is_first || !rule.once) &&
               std::ranges::binary_search(play.scene.rules.places[rule.subject].edges, edge) &&
               matches(play, rule.other, ball);
    });
}

bool lies_at(const World& world, std::size_t ball, std::size_t edge) {
    constexpr double hair = 1e-4;  // radii
    const double radius = world.balls().radius[ball];
    return separation(Disc{world.balls().position[ball], radius}, world.capsules().shape[edge]) <=
           hair * radius;
}

// Of a ball that lies at an edge, every tick has a contact: it has hit the edge once, and can hit
// it again when it has left it.
void note_touching(ShotsPlay& play, std::span<const Contact> contacts) {
    const World& world = play.world;
    std::erase_if(play.state.touching, [&](const Meeting& touch) {
        const auto& id = play.state.balls[touch.a];
        const auto ball = id ? index_of(world, *id) : std::nullopt;
        const auto edge = index_of(world, CapsuleId{touch.b});
        return !ball || !edge || !lies_at(world, *ball, *edge);
    });
    for (const Contact& contact : contacts) {
        if (contact.kind != ContactKind::ball_edge) continue;
        const auto number = number_of(play.state, BallId{contact.a});
        const auto ball = index_of(world, BallId{contact.a});
        const auto edge = index_of(world, CapsuleId{contact.b});
        if (number && ball && edge && lies_at(world, *ball, *edge))
            note(play.state.touching, {Meeting::What::edge, *number, contact.b});
    }
}

void happen_at_contacts(ShotsPlay& play, std::span<const Contact> contacts) {
    for (const Contact& contact : contacts) {
        const auto a = number_of(play.state, BallId{contact.a});
        if (!a) continue;
        if (contact.kind == ContactKind::ball_edge) {
            const Meeting touch{Meeting::What::edge, *a, contact.b};
            if (!std::ranges::binary_search(play.state.touching, touch))
                hit_edge(play, *a, CapsuleId{contact.b});
            continue;
        }
        if (const auto b = number_of(play.state, BallId{contact.b})) meet(play, *a, *b);
    }
}

std::vector<Meeting> visits(const ShotsPlay& play) {
    std::vector<Meeting> inside;
    const World& world = play.world;
    for (std::uint32_t ball = 0; ball < play.state.balls.size(); ++ball) {
        const auto index =
            play.state.balls[ball] ? index_of(world, *play.state.balls[ball]) : std::nullopt;
        if (!index) continue;
        for (std::uint32_t place = 0; place < play.scene.rules.places.size(); ++place) {
            const auto holds_ball = [&](std::uint32_t zone) {
                return is_inside(world.zones()[zone].shape, world.balls().position[*index]);
            };
            if (std::ranges::any_of(play.scene.rules.places[place].zones, holds_ball))
                inside.push_back({Meeting::What::place, ball, place});
        }
    }
    return inside;
}

void visit(ShotsPlay& play, const Meeting& visit, RuleEvent event) {
    const bool is_first = event == RuleEvent::place_left || note(play.state.met, visit);
    happen_if(play.rules(), event, [&](const Rule& rule) {
        play.it = visit.a;
        return (is_first || !rule.once) && rule.subject == visit.b &&
               matches(play, rule.other, visit.a);
    });
}

void happen_at_places(ShotsPlay& play) {
    const std::vector<Meeting> now = visits(play);
    const std::vector<Meeting> before = std::exchange(play.state.inside, now);
    for (const Meeting& place : before)
        if (!std::ranges::binary_search(now, place)) visit(play, place, RuleEvent::place_left);
    for (const Meeting& place : now)
        if (!std::ranges::binary_search(before, place))
            visit(play, place, RuleEvent::place_entered);
}

void happen_at_pockets(ShotsPlay& play) {
    const std::vector<Removal>& removed = play.world.ledger().removed;
    std::size_t first = removed.size();
    while (first > 0 && removed[first - 1].tick == play.world.tick())
        --first;
    // Rules may respot a ball, and so add removals: those are not of pockets.
    const std::vector<Removal> gone(removed.begin() + static_cast<std::ptrdiff_t>(first),
                                    removed.end());
    for (const Removal& removal : gone) {
        const auto ball = number_of(play.state, removal.id);
        if (!ball || removal.zone < 0) continue;
        play.state.balls[*ball].reset();
        const auto zone = static_cast<std::uint32_t>(removal.zone);
        happen_if(play.rules(), RuleEvent::pocketed, [&](const Rule& rule) {
            play.it = *ball;
            if (!matches(play, rule.subject, *ball)) return false;
            if (rule.other == no_subject) return true;
            const auto& zones = play.scene.rules.places[rule.other].zones;
            return std::ranges::find(zones, zone) != zones.end();
        });
    }
}

}  // namespace

void begin_shot_events(ShotsPlay& play) {
    const World& world = play.world;
    play.state.met.clear();
    play.state.touching.clear();
    for (std::uint32_t number = 0; number < play.state.balls.size(); ++number) {
        const auto ball =
            play.state.balls[number] ? index_of(world, *play.state.balls[number]) : std::nullopt;
        for (std::size_t edge = 0; ball && edge < world.capsules().size(); ++edge)
            if (lies_at(world, *ball, edge))
                play.state.touching.push_back(
                    {Meeting::What::edge, number, carom::number(world.capsules().id[edge])});
    }
    std::ranges::sort(play.state.touching);
    play.state.inside = visits(play);
}

void happen_in_tick(ShotsPlay& play, std::span<const Contact> contacts) {
    happen_at_contacts(play, contacts);
    note_touching(play, contacts);
    happen_at_places(play);
    happen_at_pockets(play);
}

}  // namespace carom
