#include "carom/context/comparison_run.h"

#include <algorithm>

#include "physics/broad_phase/nearest_image.h"
#include "physics/world/fingerprint.h"

namespace carom {
namespace {

/// In radii: a ball further from its counterpart in the other run has diverged.
constexpr double tolerance = 0.01;
/// The memory limit for the history.
constexpr std::size_t rewind_bytes = std::size_t{16} << 20;

/// The ball that is furthest, in its own radii, from its counterpart in `b`; none if all are within
/// the tolerance.
std::optional<std::size_t> diverged_ball(const World& a, const World& b) {
    std::optional<std::size_t> found;
    double most = tolerance;
    std::size_t j = 0;
    for (std::size_t i = 0; i < a.balls().size(); ++i) {
        while (j < b.balls().size() && b.balls().id[j] < a.balls().id[i])
            ++j;
        if (j == b.balls().size() || b.balls().id[j] != a.balls().id[i]) continue;
        const Vec2 apart = nearest_image(a, a.balls().position[i] - b.balls().position[j]);
        const double radii = length(apart) / a.balls().radius[i];
        if (radii <= most) continue;
        most = radii;
        found = i;
    }
    return found;
}

}  // namespace

std::span<const TimedCommand> commands_at(const Session& session, std::uint64_t tick) {
    const std::span<const TimedCommand> all = session.commands();
    const auto first = std::ranges::lower_bound(all, tick, {}, &TimedCommand::tick);
    const auto last = std::ranges::upper_bound(all, tick, {}, &TimedCommand::tick);
    return {first, last};
}

bool is_same_state(const World& a, const World& b) {
    return a.model() == b.model() && fingerprint(a) == fingerprint(b);
}

ComparisonRun::ComparisonRun(const Session& session, const SolverSettings& solver)
    : solver_(solver), history_(rewind_bytes) {
    begin(session);
}

void ComparisonRun::begin(const Session& session) {
    start_ = session.world();
    world_ = start_;
    start_game_ = session.game();
    game_ = start_game_;
    contacts_.clear();
    history_.clear();
    obeyed_ = start_.tick();
    divergence_.reset();
}

void ComparisonRun::go_back(std::uint64_t tick) {
    const Snapshot* from = history_.at_or_before(tick);
    world_ = from ? from->world : start_;
    game_ = from ? from->game : start_game_;
    obeyed_ = from ? std::nullopt : std::optional(start_.tick());
    history_.forget_from(tick + 1);
    contacts_.clear();
    if (divergence_ && divergence_->tick > tick) divergence_.reset();
}

bool ComparisonRun::tick(const Session& session, const KeepGoing& keep_going) {
    if (obeyed_ != world_.tick()) {
        if (world_.tick() % History::spacing == 0) history_.keep(world_, solver_.settings(), game_);
        for (const TimedCommand& timed : commands_at(session, world_.tick()))
            if (!refusal(session.scene(), world_, game_, timed.command))
                execute(session.scene(), world_, game_, timed.command);
        obeyed_ = world_.tick();
    }
    if (solver_.tick(world_, keep_going) == TickOutcome::cancelled) return false;
    contacts_.assign(solver_.contacts().begin(), solver_.contacts().end());
    update_game(session.scene(), world_, game_, contacts_);
    return true;
}

bool ComparisonRun::follow(const Session& session, const MayGoOn& may_go_on,
                           const KeepGoing& keep_going) {
    const World& lead = session.world();
    if (lead.tick() < start_.tick() ||
        (lead.tick() == start_.tick() && !is_same_state(lead, start_)))
        begin(session);
    if (lead.tick() < world_.tick()) go_back(lead.tick());
    while (world_.tick() < lead.tick()) {
        if (!tick(session, keep_going)) return false;
        if (world_.tick() < lead.tick() && may_go_on && !may_go_on()) return false;
    }
    if (divergence_) return true;
    if (const auto ball = diverged_ball(lead, world_))
        divergence_ = {lead.tick(), lead.time(), lead.balls().id[*ball],
                       lead.balls().position[*ball]};
    return true;
}

}  // namespace carom
