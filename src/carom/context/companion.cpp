#include "carom/context/companion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "carom/context/solver_choice.h"
#include "game/commands/picking.h"

namespace carom {
namespace {

/// The most accurate first.
constexpr std::array comparison_kinds = {SolverKind::event, SolverKind::swept, SolverKind::contact,
                                         SolverKind::substep, SolverKind::discrete};

/// The memory limit for the copies of an ensemble at its start.
constexpr std::size_t most_ensemble_bytes = std::size_t{512} << 20;

/// The first kind after `last` that is available, supports the model and differs from the game's
/// own; none after the last.
std::optional<SolverKind> next_kind(std::optional<SolverKind> last, SolverKind own,
                                    const Model& model) {
    auto from = comparison_kinds.begin();
    if (last) from = std::next(std::ranges::find(comparison_kinds, *last));
    const auto available = solvers_available();
    const auto next = std::find_if(from, comparison_kinds.end(), [&](SolverKind kind) {
        return kind != own && supports(kind, model) &&
               std::ranges::find(available, kind) != available.end();
    });
    return next == comparison_kinds.end() ? std::nullopt : std::optional(*next);
}

}  // namespace

bool Companion::next_comparison(const Session& session) {
    const std::optional<SolverKind> last =
        comparison_ ? std::optional(comparison_->solver().kind) : std::nullopt;
    const auto next = next_kind(last, session.solver().kind, session.world().model());
    comparison_.reset();
    memory_ = {};
    if (!next) return false;
    ensemble_.reset();
    comparison_.emplace(session, settings_of(*next, session.scene()));
    return true;
}

Companion::EnsembleState Companion::toggle_ensemble(const Session& session) {
    if (ensemble_) {
        ensemble_.reset();
        return EnsembleState::ended;
    }
    if (bytes_of(session.world()) > most_ensemble_bytes / Ensemble::copy_count)
        return EnsembleState::too_large;
    comparison_.reset();
    ensemble_.emplace(session);
    return EnsembleState::running;
}

bool Companion::follow(const Session& session, const MayGoOn& may_go_on,
                       const KeepGoing& keep_going) {
    if (comparison_) return comparison_->follow(session, may_go_on, keep_going);
    return !ensemble_ || ensemble_->follow(session, may_go_on, keep_going);
}

void Companion::follow_closely(const Session& session, const KeepGoing& keep_going) {
    if (comparison_) comparison_->follow(session, keep_going, keep_going);
}

bool Companion::is_behind(const Session& session) const {
    return (comparison_ && comparison_->world().tick() != session.world().tick()) ||
           (ensemble_ && ensemble_->is_behind(session));
}

std::string Companion::text() const {
    if (comparison_) {
        const auto& divergence = comparison_->divergence();
        if (!divergence) return fmt::format("identical since t={:.3f}", comparison_->start_time());
        return fmt::format("diverged at t={:.3f}, ball {}", divergence->time,
                           number(divergence->ball));
    }
    if (!ensemble_) return {};
    // The number has a fixed width, so that the text after it does not move.
    const std::string now = fmt::format("{:.1e}", ensemble_->spread());
    if (!ensemble_->time_of_a_radius())
        return fmt::format("{} copies, spread {} radii", Ensemble::copy_count, now);
    return fmt::format("{} copies, a radius apart at t={:.3f}, now {}", Ensemble::copy_count,
                       *ensemble_->time_of_a_radius(), now);
}

CellArea Companion::split_area(const CellArea& area, const Box& view, double aspect) {
    if (!comparison_) return area;
    split_ = split(area, view, aspect);
    return split_.first;
}

CellPoint Companion::in_first_half(CellPoint place) const {
    if (!comparison_) return place;
    const CellArea& second = split_.second;
    const bool is_in_second = place.column >= second.column && place.row >= second.row;
    if (!is_in_second) return place;
    return {place.column - second.column + split_.first.column,
            place.row - second.row + split_.first.row};
}

void Companion::annotate(Annotations& annotations) const {
    if (ensemble_) annotations.copies = ensemble_->copies();
    if (comparison_ && comparison_->divergence())
        annotations.marks.push_back(comparison_->divergence()->place);
}

void Companion::draw(Canvas& canvas, const Session& session, Camera camera,
                     std::optional<BallId> selected, const ViewOptions& view) {
    const World& own = session.world();
    const World& other = comparison_->world();
    camera.area = split_.second;
    Annotations annotations;
    annotate(annotations);
    if (selected && index_of(other, *selected)) annotations.selected_ball = selected;
    draw_world(canvas, camera, session.scene(), other, comparison_->contacts(), annotations, view,
               memory_);
    const auto title = [](const SolverSettings& solver, const World& world) {
        return HalfTitle{solver_text(solver), world.tick(),
                         world.ledger().ball_ball_collisions + world.ledger().ball_edge_collisions};
    };
    draw_split(canvas, split_, title(session.solver(), own), title(comparison_->solver(), other),
               view.look);
}

}  // namespace carom
