#include "carom/context/ensemble.h"

#include "carom/context/comparison_run.h"
#include "lab/measure/difference.h"

namespace carom {
namespace {

WorldEnsemble butterfly_of(const World& start, const SolverSettings& solver) {
    return {start,
            solver,
            {.copies = Ensemble::copy_count,
             .size = Ensemble::nudge_radii * mean_radius(start),
             .seed = start.seed()}};
}

}  // namespace

Ensemble::Ensemble(const Session& session)
    : start_(session.world()),
      start_solver_(session.solver()),
      butterfly_(butterfly_of(start_, start_solver_)),
      tick_(start_.tick()),
      spread_(butterfly_.spread()) {}

bool Ensemble::follow(const Session& session, const MayGoOn& may_go_on,
                      const KeepGoing& keep_going) {
    const World& lead = session.world();
    const bool is_at_start = lead.tick() == start_.tick() && is_same_state(lead, start_) &&
                             session.solver() == start_solver_;
    if (lead.tick() < tick_ || (lead.tick() <= start_.tick() && !is_at_start))
        *this = Ensemble(session);
    while (tick_ < lead.tick()) {
        if (!is_within_tick_ && tick_ > start_.tick())
            for (const TimedCommand& timed : commands_at(session, tick_))
                butterfly_.execute(timed.command);
        is_within_tick_ = !butterfly_.step(may_go_on, keep_going);
        if (is_within_tick_) return false;
        ++tick_;
        spread_ = butterfly_.spread();
        if (!time_of_a_radius_ && spread_ >= 1.0) time_of_a_radius_ = butterfly_.time();
        if (tick_ < lead.tick() && may_go_on && !may_go_on()) return false;
    }
    return true;
}

}  // namespace carom
