#include "frames.h"

#include <array>
#include <bit>

namespace carom::bench {

static_assert(std::endian::native == std::endian::little && sizeof(BallState) == 32);

void write_frame(std::ostream& file, const Frame& frame) {
    const std::array<std::int64_t, 2> head{frame.tick,
                                           static_cast<std::int64_t>(frame.balls.size())};
    file.write(reinterpret_cast<const char*>(head.data()), sizeof head);
    file.write(reinterpret_cast<const char*>(frame.balls.data()),
               static_cast<std::streamsize>(frame.balls.size() * sizeof(BallState)));
}

std::vector<Frame> read_frames(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<Frame> frames;
    std::array<std::int64_t, 2> head{};
    while (file.read(reinterpret_cast<char*>(head.data()), sizeof head)) {
        Frame frame{.tick = head[0],
                    .balls = std::vector<BallState>(static_cast<std::size_t>(head[1]))};
        file.read(reinterpret_cast<char*>(frame.balls.data()),
                  static_cast<std::streamsize>(frame.balls.size() * sizeof(BallState)));
        if (!file) break;
        frames.push_back(std::move(frame));
    }
    return frames;
}

}  // namespace carom::bench
