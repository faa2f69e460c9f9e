#include <algorithm>
#include <utility>

#include "game/pinball/pinball.h"
#include "game/pinball/pinball_table.h"
#include "geometry/closest.h"
#include "physics/world/random.h"

// What the mechanisms of a table do between two ticks.
namespace carom {
namespace {

// The lowest approach speed that counts as a hit, in ball radii a second: a ball that rolls along
// an edge touches it in every tick.
constexpr double softest_hit = 4.0;
// The time that a kicker flashes, s.
constexpr double flash = 0.15;

bool is_in_the_way(const World& world, const Capsule& shape) {
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        if (separation(Disc{world.balls().position[i], world.balls().radius[i]}, shape) <= 0.0)
            return true;
    return false;
}

/// The indices of the balls that rest on this plunger.
std::vector<std::size_t> lying_on(const World& world, const Device& plunger) {
    std::vector<std::size_t> lying;
    for (const CapsuleId id : plunger.capsules) {
        const auto index = index_of(world, id);
        if (!index) continue;
        const Capsule& shape = world.capsules().shape[*index];
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            const Disc ball{world.balls().position[i], world.balls().radius[i]};
            const bool is_before = dot(ball.center - plunger.place, plunger.direction) > 0.0;
            if (is_before && separation(ball, shape) < 0.3 * ball.radius) lying.push_back(i);
        }
    }
    return lying;
}

void fall(Pinball game, const Device& target) {
    for (const CapsuleId id : target.capsules)
        set_side(game.world, id, Side::none);
}

void kick_back(Pinball game, std::uint32_t device, std::size_t ball) {
    if (game.state.is_lit[device] == 0) return;
    const Device& kickback = game.table().devices[device];
    game.world.edit_balls().velocity[ball] = kickback.direction * kickback.most_speed;
    set_lit(game, device, false);
}

// A ball hits a captive one, or one captive ball another.
void hit_captives(Pinball game, const Contact& contact) {
    if (contact.approach < softest_hit * game.radius()) return;
    for (const CaptiveBall& captive : game.table().captives)
        if (number(captive.ball) == contact.a || number(captive.ball) == contact.b)
            apply_rules(game, captive.device, RuleEvent::hit);
}

}  // namespace

void hit_devices(Pinball game, std::span<const Contact> contacts) {
    const PinballTable& table = game.table();
    const double softest = softest_hit * game.radius();
    for (const Contact& contact : contacts) {
        if (contact.kind == ContactKind::ball_ball) hit_captives(game, contact);
        if (contact.kind != ContactKind::ball_edge || contact.b >= table.device_of_capsule.size())
            continue;
        const std::int32_t number = table.device_of_capsule[contact.b];
        if (number < 0) continue;
        const auto device = static_cast<std::uint32_t>(number);
        const Device& hit = table.devices[device];
        const auto index = index_of(game.world, CapsuleId{contact.b});
        if (!index) continue;
        const Material& material = game.world.materials()[game.world.capsules().material[*index]];
        if (contact.approach < std::max(softest, material.kick_from)) continue;
        const bool is_down =
            game.world.model().one_way && game.world.capsules().side[*index] == Side::none;
        if (is_down) continue;  // a second ball in the same tick
        if (hit.kind == DeviceKind::droptarget) fall(game, hit);
        if (hit.kind == DeviceKind::bumper || hit.kind == DeviceKind::slingshot) {
            game.state.flash_until[device] = game.now() + game.ticks(flash);
        }
        apply_rules(game, device, RuleEvent::hit);
    }
}

void visit_zones(Pinball game) {
    const PinballTable& table = game.table();
    std::vector<PinballState::Visit> visits;
    for (std::uint32_t device = 0; device < table.devices.size(); ++device) {
        const Device& place = table.devices[device];
        if (!place.zone || place.kind == DeviceKind::drain || place.kind == DeviceKind::ramp)
            continue;
        const Capsule& shape = game.world.zones()[*place.zone].shape;
        for (std::size_t i = 0; i < game.world.balls().size(); ++i)
            if (game.world.kinds()[game.world.balls().kind[i]].layer == place.from &&
                is_inside(shape, game.world.balls().position[i]))
                visits.push_back({device, game.world.balls().id[i]});
    }
    const std::vector<PinballState::Visit> before = std::exchange(game.state.visits, visits);
    for (const PinballState::Visit& visit : visits) {
        if (std::ranges::binary_search(before, visit)) continue;
        const Device& place = table.devices[visit.device];
        const std::size_t ball = *index_of(game.world, visit.ball);
        if (place.kind == DeviceKind::lock) continue;  // update_locks waits until it lies there
        if (place.kind == DeviceKind::spinner) {
            // The rim of the vane moves as fast as the ball that pushes it.
            constexpr double half_turns_per_length = 1.0 / 3.14159265358979323846;
            const double rim = game.world.zones()[*place.zone].shape.radius;
            game.state.turning[visit.device] =
                std::max(game.state.turning[visit.device],
                         length(game.world.balls().velocity[ball]) / rim * half_turns_per_length);
        }
        // A ball that finds a hole occupied rolls past.
        const bool is_taken = take_in(game, visit.device, visit.ball);
        if (place.kind == DeviceKind::hole && !is_taken) continue;
        apply_rules(game, visit.device, RuleEvent::enter);
        if (place.kind == DeviceKind::kickback) kick_back(game, visit.device, ball);
    }
}

void update_spinners(Pinball game) {
    constexpr double slowing = 1.2;  // 1/s
    constexpr double slowest = 1.0;  // half turns a second
    const double step = game.world.tick_length();
    for (std::uint32_t device = 0; device < game.table().devices.size(); ++device) {
        double& turning = game.state.turning[device];
        if (!(turning > 0.0)) continue;
        double& turned = game.state.turned[device];
        turned += turning * step;
        turning -= turning * std::min(1.0, slowing * step);
        for (; turned >= 1.0; turned -= 1.0)
            apply_rules(game, device, RuleEvent::hit);
        if (turning < slowest) turning = turned = 0.0;
    }
}

void raise_targets(Pinball game) {
    const PinballTable& table = game.table();
    for (std::uint32_t device = 0; device < table.devices.size(); ++device) {
        if (game.state.is_rising[device] == 0 ||
            table.devices[device].kind != DeviceKind::droptarget)
            continue;
        for (const CapsuleId id : table.devices[device].capsules) {
            const auto index = index_of(game.world, id);
            if (!index) {
                game.state.is_rising[device] = 0;
            } else if (!is_in_the_way(game.world, game.world.capsules().shape[*index])) {
                set_side(game.world, id, Side::both);
                game.state.is_rising[device] = 0;
            }
        }
    }
}

// For gates and posts, PinballState::is_rising says that they are open.
void update_openings(Pinball game) {
    for (const std::uint32_t device : game.table().openings) {
        std::uint8_t& is_open = game.state.is_rising[device];
        const std::uint8_t wants = game.state.is_lit[device];
        if (is_open == wants) continue;
        const Device& door = game.table().devices[device];
        const bool is_blocked = std::ranges::any_of(door.capsules, [&](CapsuleId id) {
            const auto index = index_of(game.world, id);
            return index && is_in_the_way(game.world, game.world.capsules().shape[*index]);
        });
        if (wants == 0 && is_blocked) continue;
        for (const CapsuleId id : door.capsules)
            set_side(game.world, id, wants != 0 ? Side::none : door.side);
        is_open = wants;
    }
}

bool launch(Pinball game, double pull) {
    bool is_launched = false;
    for (const Device& device : game.table().devices) {
        if (device.kind != DeviceKind::plunger) continue;
        const double wanted = device.least_speed + (device.most_speed - device.least_speed) * pull;
        for (const std::size_t ball : lying_on(game.world, device)) {
            const double scatter = random_between(-device.scatter, device.scatter,
                                                  game.world.seed(), RandomStream::player,
                                                  number(game.world.balls().id[ball]), game.now());
            const double speed = wanted * (1.0 + scatter);
            Vec2& velocity = game.world.edit_balls().velocity[ball];
            velocity += device.direction * (speed - dot(velocity, device.direction));
            is_launched = true;
        }
    }
    return is_launched;
}

bool is_captive(const Scene& scene, BallId ball) {
    return std::ranges::any_of(scene.table.captives,
                               [&](const CaptiveBall& captive) { return captive.ball == ball; });
}

bool is_in_play(const Scene& scene, const PinballState& state, BallId ball) {
    return !std::ranges::binary_search(state.locked, ball) && !is_captive(scene, ball);
}

bool is_on_plunger(const Scene& scene, const World& world) {
    return std::ranges::any_of(scene.table.devices, [&](const Device& device) {
        return device.kind == DeviceKind::plunger && !lying_on(world, device).empty();
    });
}

}  // namespace carom
