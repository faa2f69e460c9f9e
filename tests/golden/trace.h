#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vec2.h"
#include "physics/world/world.h"

/// Where the balls of a golden run went: what a fingerprint that differs cannot tell. A trace is a
/// line a ball, in the order of the balls' numbers:
///
///     NUMBER X,Y DIGESTS
///
/// X,Y is where the ball was last. DIGESTS has one character for each window of the run: 6 bits of
/// a digest of position, velocity and spin at the window's end, or `.` while the ball is not there.
/// A ball that goes astray changes each character with a probability of 63 in 64.
namespace carom::test {

class TraceRecorder {
  public:
    static constexpr int windows = 60;
    static constexpr std::uint32_t most_balls = 24;  ///< of the start; larger scenes are sampled

    TraceRecorder(const World& start, std::uint64_t ticks);

    /// To be called after each tick. Cost: nothing but at the end of a window.
    void note(const World& world);
    std::vector<std::string> lines() const;

  private:
    struct Ball {
        Vec2 position;
        std::string digests;
    };
    std::uint64_t window_ = 1;  ///< ticks
    std::uint32_t stride_ = 1;  ///< of every so many balls one is noted
    std::map<std::uint32_t, Ball> balls_;
    std::string absent_;  ///< a dot for each window so far
};

/// What two traces of one run say: which ball is elsewhere first, since which tick, how far at the
/// end, and how many are. None where they agree.
std::optional<std::string> difference(const std::vector<std::string>& golden,
                                      const std::vector<std::string>& now, std::uint64_t ticks);

}  // namespace carom::test
