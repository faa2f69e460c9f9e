#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vec2.h"
#include "physics/world/world.h"

/// The paths of the balls of a golden run, which explain a fingerprint that differs. A trace has
/// one line a ball, in order of ball number:
///
///     NUMBER X,Y DIGESTS
///
/// X,Y is the last position of the ball. DIGESTS has one character for each window of the run: 6
/// bits of a digest of position, velocity and spin at the window's end, or `.` while the ball does
/// not exist. A ball that diverges changes each later character with a probability of 63 in 64.
namespace carom::test {

class TraceRecorder {
  public:
    static constexpr int windows = 60;
    static constexpr std::uint32_t most_balls = 24;  ///< at the start; larger scenes are sampled

    TraceRecorder(const World& start, std::uint64_t ticks);

    /// To be called after each tick. Cost: nothing except at the end of a window.
    void note(const World& world);
    std::vector<std::string> lines() const;

  private:
    struct Ball {
        Vec2 position;
        std::string digests;
    };
    std::uint64_t window_ = 1;  ///< ticks
    std::uint32_t stride_ = 1;  ///< one of so many balls is traced
    std::map<std::uint32_t, Ball> balls_;
    std::string absent_;  ///< a dot for each window so far
};

/// Compares two traces of one run: the ball that diverged first, in which tick, how far it is off
/// at the end, and how many differ. None if they agree.
std::optional<std::string> difference(const std::vector<std::string>& golden,
                                      const std::vector<std::string>& now, std::uint64_t ticks);

}  // namespace carom::test
