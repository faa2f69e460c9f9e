#include "game/commands/command.h"

#include <algorithm>

namespace carom {
namespace {

using namespace command;

/// A player can bring together bodies that could not meet when the level was loaded, so the model
/// must include those collisions.
void widen_model(World& world) {
    for (const ClassIndex kind : world.balls().kind) {
        for (std::size_t other = 0; other < world.kinds().size() && !world.model().ball_ball;
             ++other)
            world.edit_definition().model.ball_ball =
                kinds_meet(world, kind, static_cast<ClassIndex>(other));
        for (const ClassIndex material : world.capsules().material) {
            if (world.model().ball_edge) break;
            world.edit_definition().model.ball_edge = kind_meets_material(world, kind, material);
        }
        if (world.model().ball_ball && world.model().ball_edge) return;
    }
}

struct Execute {
    World& world;

    void operator()(const Strike& strike) const {
        const std::size_t i = *index_of(world, strike.ball);
        world.edit_balls().velocity[i] = strike.velocity;
        // An impulse m v at that height and side gives the angular momentum m v r times each
        // offset.
        if (world.model().cloth)
            world.edit_balls().roll[i] = strike.velocity * (strike.follow / *world.model().spin);
        if (world.model().cloth || strike.side != 0.0)
            world.edit_balls().spin[i] = strike.side * length(strike.velocity) /
                                         (*world.model().spin * world.balls().radius[i]);
    }
    void operator()(const HoldBall& hold) const {
        carom::hold(world, HeldBall{hold.ball, hold.target});
    }
    void operator()(const DropBall& drop) const {
        std::erase_if(world.edit_held_balls(),
                      [&](const HeldBall& h) { return h.id == drop.ball; });
    }
    void operator()(const HoldCapsule& hold) const {
        carom::hold(world, HeldCapsule{hold.capsule, hold.start_target, hold.end_target});
    }
    void operator()(const DropCapsule& drop) const {
        std::erase_if(world.edit_held_capsules(),
                      [&](const HeldCapsule& h) { return h.id == drop.capsule; });
    }
    void operator()(const PlaceBall& place) const {
        world.edit_balls().position[*index_of(world, place.ball)] = place.position;
        if (is_held(world, place.ball)) hold(world, HeldBall{place.ball, place.position});
    }
    void operator()(const PlaceCapsule& place) const {
        Capsule& shape = world.edit_capsules().shape[*index_of(world, place.capsule)];
        shape = {place.start, place.end, shape.radius};
        if (is_held(world, place.capsule))
            hold(world, HeldCapsule{place.capsule, place.start, place.end});
    }
    void operator()(const AddBall& add) const {
        add_ball(world, add.spec);
        widen_model(world);
    }
    void operator()(const RemoveBall& remove) const { remove_ball(world, remove.ball); }
    void operator()(const AddCapsule& add) const {
        add_capsule(world, add.shape, add.material, add.side);
        widen_model(world);
    }
    void operator()(const RemoveCapsule& remove) const { remove_capsule(world, remove.capsule); }
    void operator()(const SetGravity& set) const {
        world.edit_definition().model.gravity = set.gravity;
    }
    void operator()(const SetSolver&) const {}
    void operator()(const Press&) const {}
    void operator()(const Pull&) const {}
    void operator()(const CallShot&) const {}
    void operator()(const Decide&) const {}
    void operator()(const RackAgain&) const {}
    void operator()(const TimeOut&) const {}
    void operator()(const Concede&) const {}
};

bool is_drop(const Command& command) {
    return std::holds_alternative<DropBall>(command) ||
           std::holds_alternative<DropCapsule>(command);
}

bool is_hold(const Command& command) {
    return std::holds_alternative<HoldBall>(command) ||
           std::holds_alternative<HoldCapsule>(command);
}

bool is_place(const Command& command) {
    return std::holds_alternative<PlaceBall>(command) ||
           std::holds_alternative<PlaceCapsule>(command);
}

/// The ball or edge that a command drags; none for other commands.
struct Moved {
    std::size_t how = 0;
    std::uint32_t what = 0;

    friend bool operator==(const Moved&, const Moved&) = default;
};

std::optional<Moved> moved(const Command& command) {
    const std::size_t how = command.index();
    if (const auto* c = std::get_if<HoldBall>(&command)) return Moved{how, number(c->ball)};
    if (const auto* c = std::get_if<HoldCapsule>(&command)) return Moved{how, number(c->capsule)};
    if (const auto* c = std::get_if<PlaceBall>(&command)) return Moved{how, number(c->ball)};
    if (const auto* c = std::get_if<PlaceCapsule>(&command)) return Moved{how, number(c->capsule)};
    return std::nullopt;
}

}  // namespace

void execute(World& world, const Command& command) {
    std::visit(Execute{world}, command);
}

bool continues_gesture(const Command& earlier, const Command& later) {
    if (std::holds_alternative<CallShot>(earlier))
        return std::holds_alternative<CallShot>(later) || std::holds_alternative<Strike>(later);
    const bool hand_was_closed = is_hold(earlier) || is_place(earlier);
    const bool hand_goes_on = is_hold(later) || is_place(later);
    return hand_was_closed ? hand_goes_on || is_drop(later) : is_drop(earlier) && is_drop(later);
}

bool moves_capsule(const Command& command) {
    return std::holds_alternative<HoldCapsule>(command) ||
           std::holds_alternative<PlaceCapsule>(command);
}

bool moves_same_hand(const Command& earlier, const Command& later) {
    const auto what = moved(earlier);
    return what && what == moved(later);
}

}  // namespace carom
