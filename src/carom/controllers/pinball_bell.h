#pragma once

#include <cstddef>
#include <cstdint>

#include "game/session/session.h"

/// Decides when the terminal's bell rings at a pinball table.
namespace carom {

class PinballBell {
  public:
    /// Whether the bell should ring now: since the last call the ball was kicked or fell into a
    /// hole, and the bell has been silent for a while. `seconds`: since the last call.
    bool rings(const Session& session, double seconds);

  private:
    std::uint64_t heard_flash_ = 0;  ///< the tick at which the last light lit by a kick goes out
    std::size_t heard_held_ = 0;     ///< balls in holes
    double since_bell_ = 1e9;        ///< s
};

}  // namespace carom
