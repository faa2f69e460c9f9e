#include "physics/contact/solver.h"

#include <algorithm>

#include "physics/contact/contact_memory.h"
#include "physics/contact/tolerances.h"
#include "physics/tick/emitters_and_sinks.h"
#include "physics/world/solver_access.h"

namespace carom {
namespace {

// More substeps where balls are small against what gravity moves them in one. A constraint lets a
// ball fall that far before it holds it.
int substeps_for_fall(const World& world, int wanted) {
    if (!world.model().gravity || world.balls().size() == 0) return wanted;
    const double smallest = *std::ranges::min_element(world.balls().radius);
    const double fall = length(*world.model().gravity) * world.tick_length() * world.tick_length();
    int count = wanted;
    while (count < contact_tolerance::most_substeps &&
           fall > contact_tolerance::most_fall * smallest * count * count)
        count *= 2;
    return count;
}

}  // namespace

void ContactSolver::tick(World& world, int substeps, std::vector<Contact>& contacts,
                         std::vector<std::uint8_t>& touched, bool is_strict) {
    const int count = substeps_for_fall(world, substeps_needed(world, substeps));
    step_ = contact_substep(world, count, is_strict);
    sizes_ = skin_sizes(world, step_);
    kinematics_.begin_tick();
    impacts_.begin_tick();
    for (int i = 0; i < count; ++i) {
        if (i == 0) {
            begin(world);
            energy_.begin_tick(contact_memory(world).stored_energy);
        } else {
            find_leaving_in_substep(bodies_, sizes_, leaving_);
            is_reloaded_ = false;
            if (must_start_anew(world)) {
                store(world, touched);
                start_anew(world);
            } else if (!leaving_.empty()) {
                follow_leaving(world);
            }
        }
        step_.start_time = world.time() + step_.duration * i;
        substep(world, 1.0 / (count - i), contacts);
    }
    store(world, touched);
}

// Goes on with the pairs of the last tick where `load` would find the same ones.
void ContactSolver::begin(World& world) {
    if (!has_reference_positions(world, step_)) return start_anew(world);
    if (has_pairs_of(world))
        bodies_.reload(world);
    else
        load(world);
    find_leaving_in_tick(bodies_, sizes_, leaving_);
    is_reloaded_ = true;
    if (must_start_anew(world)) {
        start_anew(world);
    } else if (!leaving_.empty() || pairs_.has_added()) {
        renew_reference_positions(world, sizes_, bodies_, leaving_);
        pairs_.update(world, step_, bodies_, leaving_);
    }
}

// Whether all balls get new reference positions, and a new order: where many leave their skins, and
// where one does in a fast crowd, in which any ball may be hit.
bool ContactSolver::must_start_anew(const World& world) const {
    return !leaving_.empty() && (sizes_.is_fast_crowd || 2 * leaving_.size() > bodies_.fixed ||
                                 !has_reference_positions(world, step_));
}

void ContactSolver::start_anew(World& world) {
    is_reloaded_ = true;
    set_reference_positions(world, sizes_);
    load(world);
}

// In the middle of a tick: pairs of a few balls need no order.
void ContactSolver::follow_leaving(World& world) {
    renew_reference_positions(world, sizes_, bodies_, leaving_);
    is_reloaded_ = contact_tolerance::few_leaving * leaving_.size() > bodies_.fixed;
    if (is_reloaded_)
        pairs_.update(world, step_, bodies_, leaving_);
    else
        pairs_.add(world, bodies_, leaving_);
}

// Whether nobody has changed what the pairs depend on, besides the motion of balls, since the last
// tick left it.
bool ContactSolver::has_pairs_of(const World& world) const {
    const Stamps& now = world.stamps();
    return now.definition == stamps_.definition && now.capsules == stamps_.capsules &&
           now.roster == stamps_.roster && now.memory == stamps_.memory && now.held == stamps_.held;
}

void ContactSolver::load(World& world) {
    pairs_.find(world);
    bodies_.load(world);
    kinematics_.load(world, bodies_);
    pairs_.load(world, step_, bodies_, kinematics_.edges());
    stamps_ = world.stamps();
}

void ContactSolver::store(World& world, std::vector<std::uint8_t>& touched) {
    bodies_.store(world);
    kinematics_.stop_held_balls(world, bodies_);
    pairs_.store_impulses(world, bodies_, touched);
    const SolverAccess access(world);
    access.memory().use<ContactMemory>().stored_energy = energy_.stored();
    access.stamp_motion();
    access.stamp_memory();
    stamps_.memory = world.stamps().memory;
}

void ContactSolver::substep(World& world, double share_of_displacement,
                            std::vector<Contact>& contacts) {
    kinematics_.begin_substep(world, step_, bodies_, share_of_displacement);
    bodies_.integrate_velocities(world, step_);
    kinematics_.set_velocities(bodies_);
    classification_.count_contacts(is_reloaded_);
    if (is_reloaded_) energy_.forget_groups();
    classification_.classify(world);
    constraints_.begin();
    hinges_.begin();
    constraints_.report_new(contacts, kinematics_);
    hinges_.report_new(contacts);
    for (int round = 0; round < contact_tolerance::most_holds && !pairs_.kinematic().empty() &&
                        kinematics_.hold_back(pairs_, bodies_, step_);
         ++round)
        constraints_.solve(round % 2 == 0);
    const bool has_impacts = impacts_.find();
    if (has_impacts)
        impacts_.run(world, hinges_, contacts);
    else
        advance_positions(world);
    constraints_.relax(impacts_.most_push(), has_impacts);
    hinges_.relax();
    if (!kinematics_.is_empty()) {
        kinematics_.note_pressing(pairs_, bodies_, step_);
        kinematics_.settle_jams(pairs_, bodies_, step_);
    }
    energy_.end_substep(classification_.constraints(), impacts_.of_balls(),
                        impacts_.given() + kinematics_.work(pairs_, bodies_) + hinges_.given());
    kinematics_.end_substep(world, step_);
}

void ContactSolver::advance_positions(const World& world) {
    const std::optional<double> limit = world.model().speed_limit;
    for (std::uint32_t i = 0; i < bodies_.fixed; ++i) {
        bodies_.position[i] += bodies_.displacement[i];
        if (limit) bodies_.body[i].velocity = limited(bodies_.body[i].velocity, *limit);
    }
}

}  // namespace carom
