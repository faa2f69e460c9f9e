#include "carom/context/play_observer.h"

namespace carom {

PlayObserver::PlayObserver(const Session& session) : what_(observed_of(session.scene())) {
    begin(session);
}

void PlayObserver::observe(Observable what, const Session& session) {
    if (what_.has(what)) return;
    what_.add(what);
    begin(session);
}

void PlayObserver::begin(const Session& session) {
    solver_ = session.solver();
    tick_ = session.world().tick();
    if (!what_.is_empty()) observer_.emplace(session.scene(), solver_, what_, session.world());
}

void PlayObserver::note_tick(const Session& session) {
    if (what_.is_empty()) return;
    const bool goes_on = session.world().tick() == tick_ + 1 && session.solver() == solver_;
    if (!goes_on) return begin(session);
    ++tick_;
    observer_->note_tick(session.scene(), session.world(), session.contacts());
}

}  // namespace carom
