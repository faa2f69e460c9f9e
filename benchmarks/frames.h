#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

/// The states of an engine's balls at some ticks of a run.
///
/// File format, little-endian: for each frame the ticks done and the number of balls (64-bit
/// integers), then x, y, vx, vy of each ball (doubles), in the order in which balls were added.
namespace carom::bench {

struct BallState {
    double x = 0.0;
    double y = 0.0;
    double vx = 0.0;
    double vy = 0.0;
};

struct Frame {
    std::int64_t tick = 0;  ///< ticks done
    std::vector<BallState> balls;
};

void write_frame(std::ostream& file, const Frame& frame);

/// All complete frames of the file; none where the file does not exist.
std::vector<Frame> read_frames(const std::string& path);

}  // namespace carom::bench
