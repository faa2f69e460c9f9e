#pragma once

#include <cstddef>
#include <cstdint>

#include "game/session/session.h"

/// When the terminal's bell rings at a pinball table.
namespace carom {

class PinballBell {
  public:
    /// Whether the bell shall ring now: something kicked the ball, or a hole took it, since the
    /// last call, and the bell has been silent for a while. `seconds`: since the last call.
    bool rings(const Session& session, double seconds);

  private:
    std::uint64_t heard_flash_ = 0;  ///< tick at which the last light that a kick lit goes out
    std::size_t heard_held_ = 0;     ///< balls in holes
    double since_bell_ = 1e9;        ///< s
};

}  // namespace carom
