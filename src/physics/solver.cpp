#include "physics/solver.h"

#include "physics/contact/solver.h"
#include "physics/contact/swept_fallback.h"
#include "physics/discrete/solver.h"
#include "physics/event/engine.h"
#include "physics/event/hybrid_step.h"
#include "physics/swept/solver.h"
#include "physics/tick/emitters_and_sinks.h"
#include "physics/tick/undo.h"

namespace carom {
namespace {

constexpr std::array<std::string_view, 5> names{"discrete", "substep", "swept", "contact", "event"};
constexpr std::array available{SolverKind::discrete, SolverKind::substep, SolverKind::swept,
                               SolverKind::contact, SolverKind::event};

// `discrete` does no more than look at each ball once, and `contact` a fixed number of times where
// anything can press.
bool may_give_up(SolverKind kind, const World& world) {
    if (kind == SolverKind::contact) return is_flight_only(world);
    return kind != SolverKind::discrete;
}

// Inside a solver bodies go by index; outside by id. Looked up one by one, the ids of many balls
// would have to come from far away in memory.
void name_bodies(World& world, std::span<Contact> contacts) {
    const std::vector<BallId>& ids = world.balls.id;
    const bool are_counted = !ids.empty() && are_consecutive(ids);
    const auto id_of = [&](std::uint32_t ball) {
        return are_counted ? number(ids.front()) + ball : number(ids[ball]);
    };
    for (Contact& contact : contacts) {
        contact.a = id_of(contact.a);
        if (contact.kind == ContactKind::ball_ball) {
            contact.b = id_of(contact.b);
            ++world.ball_ball_collisions;
        } else {
            contact.b = number(world.capsules.id[contact.b]);
            ++world.ball_edge_collisions;
        }
    }
}

}  // namespace

std::string_view name(SolverKind kind) {
    return names[static_cast<std::size_t>(kind)];
}

std::optional<SolverKind> solver_named(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return static_cast<SolverKind>(i);
    return std::nullopt;
}

std::span<const SolverKind> solvers_available() {
    return available;
}

bool knows_cloth(SolverKind kind) {
    return kind != SolverKind::contact;
}

bool suits(SolverKind kind, const Model& model) {
    return !model.cloth || knows_cloth(kind);
}

bool hands_heaps_over(const Model& model, const SolverSettings& settings) {
    return settings.kind == SolverKind::event && !settings.extended && model.gravity &&
           model.lossy && model.ball_ball;
}

int substeps_of(const SolverSettings& settings) {
    return settings.kind == SolverKind::contact ? settings.contact_substeps : settings.substeps;
}

void set_substeps(SolverSettings& settings, int substeps) {
    (settings.kind == SolverKind::contact ? settings.contact_substeps : settings.substeps) =
        substeps;
}

struct Solver::State {
    SolverSettings settings;
    OverlapSolver overlap;
    SweptSolver swept;
    ContactSolver contact;
    EventEngine<double> event;
    std::unique_ptr<EventEngine<Wide>> extended;  // large, and seldom asked for
    Handover handover;
    std::vector<Contact> contacts;
    std::vector<std::uint8_t> touched;
    TickUndo undo;
    bool flies = false;  // the last tick was one of `contact` that went by `swept`

    EventOutcome tick_by_event(World& world, const std::function<bool()>& keep_going) {
        if (extended) return extended->tick(world, contacts, touched, keep_going);
        if (!hands_heaps_over(world.model, settings)) world.heaped.clear();
        if (!world.heaped.empty())
            return handover.tick(world, event, contact, contacts, touched, keep_going);
        const EventOutcome outcome = event.tick(world, contacts, touched, keep_going);
        if (outcome != EventOutcome::given_up) world.pressed.clear();
        return outcome;
    }
};

Solver::Solver(const SolverSettings& settings) : state_(std::make_unique<State>()) {
    state_->settings = settings;
    if (settings.kind == SolverKind::event && settings.extended)
        state_->extended = std::make_unique<EventEngine<Wide>>();
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

const CellFrame& Solver::cells() const {
    switch (state_->settings.kind) {
        case SolverKind::swept:
            return state_->swept.cells();
        case SolverKind::contact:
            return state_->flies ? state_->swept.cells() : state_->contact.cells();
        case SolverKind::event:
            return state_->extended ? state_->extended->cells() : state_->event.cells();
        default:
            return state_->overlap.cells();
    }
}

TickOutcome Solver::tick(World& world, const std::function<bool()>& keep_going) {
    State& state = *state_;
    state.contacts.clear();
    const bool can_give_up = keep_going && may_give_up(state.settings.kind, world);
    if (can_give_up) state.undo.note(world);
    emit(world);
    drive_flippers(world);
    state.touched.assign(world.balls.size(), 0);
    TickOutcome outcome = TickOutcome::done;
    const std::function<bool()> nobody;
    Patience patience(can_give_up ? keep_going : nobody);
    state.flies = state.settings.kind == SolverKind::contact && is_flight_only(world);
    switch (state.settings.kind) {
        case SolverKind::discrete:
            state.overlap.tick(world, 1, 1, state.contacts, state.touched, patience);
            break;
        case SolverKind::substep:
            state.overlap.tick(world, state.settings.updates, state.settings.steps, state.contacts,
                               state.touched, patience);
            break;
        case SolverKind::contact:
            if (state.flies) {
                state.swept.tick(world, flight_substeps(world, state.settings.contact_substeps),
                                 state.contacts, state.touched, patience);
                break;
            }
            state.contact.tick(world, state.settings.contact_substeps, state.contacts,
                               state.touched);
            break;
        case SolverKind::event: {
            const auto ended = state.tick_by_event(world, keep_going);
            if (ended == EventOutcome::given_up) outcome = TickOutcome::given_up;
            if (ended == EventOutcome::too_dense) outcome = TickOutcome::too_dense;
            break;
        }
        default:
            state.swept.tick(world, state.settings.substeps, state.contacts, state.touched,
                             patience);
    }
    if (patience.is_out() || outcome == TickOutcome::given_up) {
        state.contacts.clear();
        state.undo.take_back(world);
        return TickOutcome::given_up;
    }
    if (state.settings.kind != SolverKind::event) forget_paths(world);
    const bool has_heaps = state.settings.kind == SolverKind::event && !state.extended;
    if (!has_heaps) world.heaped.clear();
    const bool may_press = state.settings.kind == SolverKind::contact && !state.flies;
    if (!has_heaps && !may_press) world.pressed.clear();
    if (!may_press) world.homes.clear();
    rest_flippers(world);
    stop_slow_balls(world, state.touched);
    ++world.tick;
    name_bodies(world, state.contacts);
    drain_sinks(world);
    return outcome;
}

}  // namespace carom
