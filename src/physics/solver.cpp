#include "physics/solver.h"

#include "physics/overlap_solver.h"
#include "physics/surroundings.h"
#include "physics/swept_solver.h"

namespace carom {
namespace {

constexpr std::array<std::string_view, 5> names{"discrete", "substep", "swept", "contact", "event"};
constexpr std::array available{SolverKind::discrete, SolverKind::substep, SolverKind::swept};

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

struct Solver::State {
    SolverSettings settings;
    OverlapSolver overlap;
    SweptSolver swept;
    std::vector<Contact> contacts;
    std::vector<std::uint8_t> touched;
};

Solver::Solver(const SolverSettings& settings) : state_(std::make_unique<State>()) {
    state_->settings = settings;
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
    return state_->settings.kind == SolverKind::swept ? state_->swept.cells()
                                                      : state_->overlap.cells();
}

void Solver::tick(World& world) {
    State& state = *state_;
    state.contacts.clear();
    emit(world);
    state.touched.assign(world.balls.size(), 0);
    switch (state.settings.kind) {
        case SolverKind::discrete:
            state.overlap.tick(world, 1, 1, state.contacts, state.touched);
            break;
        case SolverKind::substep:
            state.overlap.tick(world, state.settings.updates, state.settings.steps, state.contacts,
                               state.touched);
            break;
        default:
            state.swept.tick(world, state.settings.substeps, state.contacts, state.touched);
    }
    stop_slow_balls(world, state.touched);
    ++world.tick;
    // Inside a solver bodies go by index; outside by id.
    for (Contact& contact : state.contacts) {
        contact.a = number(world.balls.id[contact.a]);
        if (contact.kind == ContactKind::ball_ball) {
            contact.b = number(world.balls.id[contact.b]);
            ++world.ball_ball_collisions;
        } else {
            contact.b = number(world.capsules.id[contact.b]);
            ++world.ball_edge_collisions;
        }
    }
    drain_sinks(world);
}

}  // namespace carom
