#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "carom/play/player.h"
#include "lab/run/report.h"

/// What runs beside the game: the same under another solver, and the butterfly.
namespace carom {
namespace {

/// The most exact first.
constexpr std::array comparison_kinds = {SolverKind::event, SolverKind::swept, SolverKind::contact,
                                         SolverKind::substep, SolverKind::discrete};

/// Most memory for the butterfly's copies as they begin.
constexpr std::size_t most_ensemble_bytes = std::size_t{512} << 20;

/// The first kind after `last` that there is, that knows what the model says and that is not the
/// game's own; none after the last.
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

void Player::next_comparison() {
    const std::optional<SolverKind> last =
        comparison_ ? std::optional(comparison_->solver().kind) : std::nullopt;
    const auto next = next_kind(last, session_.solver().kind, session_.world().model);
    comparison_.reset();
    comparison_memory_ = {};
    if (!next) return say("one solver alone");
    ensemble_.reset();
    comparison_.emplace(session_, settings_of(*next, session_.scene()));
}

void Player::toggle_butterfly() {
    if (ensemble_) {
        ensemble_.reset();
        return say("the butterfly is gone");
    }
    if (bytes_of(session_.world()) > most_ensemble_bytes / Ensemble::copy_count)
        return complain("too many balls for 200 copies of them");
    comparison_.reset();
    ensemble_.emplace(session_);
}

/// Whether what runs beside the game has got to where the game is.
bool Player::keep_up(const MayGoOn& may_go_on) {
    if (!comparison_ && !ensemble_) return true;
    const bool was_ahead = is_ahead();
    const bool is_there = comparison_ ? comparison_->follow(session_, may_go_on, keep_going_)
                                      : ensemble_->follow(session_, may_go_on, keep_going_);
    needs_draw_ = needs_draw_ || (was_ahead && is_there);
    return is_there;
}

/// What runs beside the game has still to catch up.
bool Player::is_ahead() const {
    return (comparison_ && comparison_->world().tick != session_.world().tick) ||
           (ensemble_ && ensemble_->is_behind(session_));
}

std::string Player::beside() const {
    if (comparison_) {
        const auto& divergence = comparison_->divergence();
        if (!divergence) return fmt::format("together since t={:.3f}", comparison_->start_time());
        return fmt::format("parted at t={:.3f}, ball {}", divergence->time,
                           number(divergence->ball));
    }
    if (!ensemble_) return {};
    // Its width stays, and so does what stands behind it.
    const std::string now = fmt::format("{:<7.2g}", ensemble_->spread());
    if (!ensemble_->time_of_a_radius())
        return fmt::format("{} copies, radii apart: {}", Ensemble::copy_count, now);
    return fmt::format("{} copies, a radius apart at t={:.3f}, now {}", Ensemble::copy_count,
                       *ensemble_->time_of_a_radius(), now);
}

/// For the page that says how the game is computed.
std::vector<std::string> Player::explanation_lines() const {
    const Scene& scene = session_.scene();
    const std::string text =
        explanation(session_.world().model, session_.world().rate, pick_solver(scene.world),
                    solver_is_picked_ ? std::nullopt : std::optional(session_.solver()));
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        lines.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return lines;
}

void Player::draw_comparison(Canvas& canvas) {
    const World& own = session_.world();
    const World& other = comparison_->world();
    Camera camera = camera_;
    camera.area = split_.second;
    Marks marks;
    marks.parting =
        comparison_->divergence() ? std::optional(comparison_->divergence()->place) : std::nullopt;
    if (selected_ && index_of(other, *selected_)) marks.selected_ball = selected_;
    draw_world(canvas, camera, session_.scene(), other, comparison_->contacts(), marks, view_,
               comparison_memory_);
    const auto title = [](const SolverSettings& solver, const World& world) {
        return HalfTitle{solver_text(solver), world.tick,
                         world.ball_ball_collisions + world.ball_edge_collisions};
    };
    draw_split(canvas, split_, title(session_.solver(), own), title(comparison_->solver(), other),
               view_.look);
}

/// Both halves show the same places: the one under the mouse counts as in the first.
CellPoint Player::in_first_half(CellPoint place) const {
    if (!comparison_) return place;
    const CellArea& second = split_.second;
    const bool is_in_second = place.column >= second.column && place.row >= second.row;
    if (!is_in_second) return place;
    return {place.column - second.column + split_.first.column,
            place.row - second.row + split_.first.row};
}

}  // namespace carom
