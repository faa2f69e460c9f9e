#pragma once

#include <cstdint>
#include <optional>

#include "game/session/session.h"
#include "lab/observe/observer.h"

namespace carom {

/// Observes a game in play, tick by tick, for panels and the status line. What the level does not
/// ask for costs nothing. After a step back, or with another solver, the observation begins anew
/// from there.
class PlayObserver {
  public:
    explicit PlayObserver(const Session& session);

    /// Observes this too, from now on.
    void observe(Observable what, const Session& session);
    /// From now on: for a step back that has arrived, and a restart.
    void begin(const Session& session);
    /// Pre: called after every tick of the session.
    void note_tick(const Session& session);

    /// Null: the level asks for nothing.
    const Observer* observer() const { return observer_ ? &*observer_ : nullptr; }

  private:
    ObservableSet what_;
    std::optional<Observer> observer_;
    SolverSettings solver_;
    std::uint64_t tick_ = 0;
};

}  // namespace carom
