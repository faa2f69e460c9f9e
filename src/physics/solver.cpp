#include "physics/solver.h"

#include "physics/broad_phase/cell_frame.h"
#include "physics/solver_table.h"
#include "physics/tick/contact_reports.h"
#include "physics/tick/emitters_and_sinks.h"
#include "physics/tick/hands.h"
#include "physics/tick/mover_step.h"
#include "physics/tick/undo.h"

namespace carom {

std::span<const SolverKind> solvers_available() {
    static const std::vector<SolverKind> kinds = [] {
        std::vector<SolverKind> all;
        for (const SolverRow& row : solver_table())
            all.push_back(row.kind);
        return all;
    }();
    return kinds;
}

bool supports(SolverKind kind, const Model& model) {
    return (!model.cloth || row_of(kind).supports_cloth) &&
           (!model.hinged || row_of(kind).supports_hinges);
}

bool uses_hybrid_step(const Model& model, const SolverSettings& settings) {
    return settings.kind == SolverKind::event && !settings.extended && model.gravity &&
           loses_energy(model) && (model.ball_ball || model.hinged);
}

struct Solver::State {
    SolverSettings settings;
    std::unique_ptr<SolverMethod> method;
    std::vector<Contact> contacts;
    std::vector<Contact> pressing;
    std::vector<std::uint8_t> touched;
    std::vector<BallId> standing;
    std::size_t standing_seesaws = 0;
    TickUndo undo;
    HandStep hands;
    MoverStep movers;
    SinkDrain sinks;
    World before;  // a tick that may be repeated

    TickOutcome advance(World& world, const std::function<bool()>& keep_going,
                        bool is_strict = false, bool is_repeated = false);
    TickOutcome advance_by_trial(World& world, bool has_hands, bool has_movers,
                                 const std::function<bool()>& keep_going);
    bool is_sound_for_movers(const World& world);
    void note_standing(const World& world);
};

TickOutcome Solver::State::advance(World& world, const std::function<bool()>& keep_going,
                                   bool is_strict, bool is_repeated) {
    contacts.clear();
    touched.assign(world.balls().size(), 0);
    return method->advance(world, {contacts, touched, keep_going, is_strict, is_repeated});
}

// A trial that is rejected counts too: where it was a limit that made it unsound, hands and movers
// yield to that limit.
void Solver::State::note_standing(const World& world) {
    name_standing(world, method->standing(), standing);
    name_standing(world, method->standing_before(), standing);
    standing_seesaws = std::max(standing_seesaws, count_standing_seesaws(world));
}

bool Solver::State::is_sound_for_movers(const World& world) {
    return movers.is_sound({.before = before,
                            .after = world,
                            .contacts = contacts,
                            .standing = method->standing(),
                            .overlaps_at_impacts = row_of(settings.kind).overlaps_at_impacts});
}

// Repeats the tick with shorter and shorter displacements of hands and movers, until it is sound.
// Balls may still squash one another where hands do not move: then the tick becomes a strict one.
TickOutcome Solver::State::advance_by_trial(World& world, bool has_hands, bool has_movers,
                                            const std::function<bool()>& keep_going) {
    before = world;
    bool is_strict = false;
    bool is_repeated = false;
    for (double share = hands.first_share();; is_repeated = true) {
        if (has_hands) hands.aim(world, share);
        if (has_movers) movers.aim(world);
        const TickOutcome outcome = advance(world, keep_going, is_strict, is_repeated);
        if (outcome == TickOutcome::cancelled) return outcome;
        const bool suits_hands =
            !has_hands || is_strict ||
            (share > 0.0 ? hands.is_sound(before, world)
                         : !method->can_be_strict() || hands.is_free_of_overlap(before, world));
        const bool suits_movers = !has_movers || is_sound_for_movers(world);
        if (suits_hands && suits_movers) {
            if (has_hands) hands.end(world, share);
            if (has_movers) movers.end(world);
            return outcome;
        }
        note_standing(world);
        is_strict = is_strict || (!suits_hands && share == 0.0);
        if (!suits_hands) share = HandStep::next_share(share);
        world = before;
    }
}

Solver::Solver(const SolverSettings& settings) : state_(std::make_unique<State>()) {
    state_->settings = settings;
    state_->method = row_of(settings.kind).make(settings);
}
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;
Solver::~Solver() = default;

const SolverSettings& Solver::settings() const {
    return state_->settings;
}
std::span<const Contact> Solver::contacts() const {
    return state_->contacts;
}
std::span<const Contact> Solver::pressing() const {
    return state_->pressing;
}
std::span<const BallId> Solver::standing() const {
    return state_->standing;
}
std::size_t Solver::standing_seesaws() const {
    return state_->standing_seesaws;
}
const CellFrame& Solver::cells() const {
    return state_->method->cells();
}

TickOutcome Solver::tick(World& world, const std::function<bool()>& keep_going) {
    State& state = *state_;
    const bool can_cancel = keep_going && row_of(state.settings.kind).can_cancel(world);
    if (can_cancel) state.undo.note(world);
    emit(world);
    drive_flippers(world);
    release_seesaws(world);
    const bool has_movers = state.movers.begin(world);
    const bool has_hands = state.hands.begin(world);
    state.standing.clear();
    state.standing_seesaws = 0;
    const std::function<bool()> never_asked;
    const std::function<bool()>& asked = can_cancel ? keep_going : never_asked;
    const TickOutcome outcome = has_hands || has_movers
                                    ? state.advance_by_trial(world, has_hands, has_movers, asked)
                                    : state.advance(world, asked);
    if (outcome == TickOutcome::cancelled) {
        state.contacts.clear();
        state.pressing.clear();
        state.undo.take_back(world);
        return outcome;
    }
    state.note_standing(world);
    rest_flippers(world);
    keep_seesaws(world);
    if (!state.method->standing().empty()) stall_flippers(world);
    stop_slow_balls(world, state.touched);
    ++world.edit_tick();
    state.pressing.assign(state.method->pressing().begin(), state.method->pressing().end());
    name_bodies(world, state.contacts);
    name_bodies(world, state.pressing);
    count_collisions(world, state.contacts);
    wrap_points(world.model().wrap, state.contacts);
    wrap_points(world.model().wrap, state.pressing);
    state.sinks.drain(world);
    return state.standing.empty() && state.standing_seesaws == 0 ? outcome
                                                                 : TickOutcome::stood_still;
}

}  // namespace carom
