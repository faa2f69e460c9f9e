#include "physics/discrete/solver.h"

#include "physics/discrete/bounce_overlap.h"

namespace carom {

void OverlapSolver::tick(World& world, int updates, int steps, std::vector<Contact>& contacts,
                         std::vector<std::uint8_t>& touched, CancellationToken& token) {
    const double start = world.time();
    step_ = {.duration = world.tick_length() / updates,
             .updates = updates,
             .terms = terms_of(world),
             .has_several = steps > 1};
    kinematics_.begin_tick(world);
    motion_.begin_tick(world);
    neighbours_.begin_tick();
    separation_.begin_tick(world);
    const auto first = static_cast<std::ptrdiff_t>(contacts.size());
    for (int i = 0; i < updates && !token.is_cancelled(); ++i) {
        kinematics_.move(world, 1.0 / (updates - i), step_.duration);
        update(world, steps, start + step_.duration * (i + 1), contacts, token);
    }
    for (auto contact = contacts.begin() + first; contact != contacts.end(); ++contact) {
        touched[contact->a] = 1;
        if (contact->kind == ContactKind::ball_ball) touched[contact->b] = 1;
    }
}

void OverlapSolver::update(World& world, int steps, double end_time, std::vector<Contact>& contacts,
                           CancellationToken& token) {
    step_.is_first = true;
    for (int step = 0; step < steps && (step_.is_first || !motion_.active().empty()); ++step) {
        const std::size_t moving = step_.is_first ? world.balls().size() : motion_.active().size();
        if (!token.may_continue(moving)) break;
        move(world);
        separation_.separate(world);
        if (step_.has_several) motion_.keep_time(world, separation_.pushed());
        bounce_overlapping(world, step_.terms, kinematics_, separation_.pairs(), end_time,
                           contacts);
        for (const PushedBall& pushed : separation_.pushed())
            neighbours_.note_place(pushed.ball, world.balls().position[pushed.ball]);
        separation_.end_step();
        step_.is_first = false;
    }
    motion_.clear_active();
}

void OverlapSolver::move(World& world) {
    if (step_.is_first) {
        const double displacement = motion_.move_all(world, neighbours_.are_shared());
        neighbours_.update(world, displacement, kinematics_.longest_displacement());
        return;
    }
    motion_.move_active(world);
    for (const std::uint32_t ball : motion_.active())
        neighbours_.note_place(ball, world.balls().position[ball]);
    neighbours_.update_after_notes(world);
}

}  // namespace carom
