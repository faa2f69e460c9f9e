#include "carom/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "carom/cli/interrupt.h"

namespace carom {
namespace {

constexpr int bar_columns = 24;

void write_to_terminal(std::string_view text) {
    // A failure to draw the bar is not worth an error.
    [[maybe_unused]] const ssize_t put = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

Progress::Progress(std::uint64_t total_ticks)
    : total_(total_ticks),
      is_terminal_(::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      next_(start_ + std::chrono::seconds(1)) {}

Progress::~Progress() {
    clear();
}

void Progress::update(std::uint64_t ticks_done) {
    if (!is_terminal_ || ticks_done == 0) return;
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);

    const double share = static_cast<double>(ticks_done) / static_cast<double>(total_);
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const int filled = static_cast<int>(share * bar_columns);
    std::string line = fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %  tick {} of {}, {:.0f} s to go", "",
                                   filled, "", bar_columns - filled, share * 100.0, ticks_done,
                                   total_, elapsed * (1.0 / share - 1.0));
    const std::size_t columns = line.size();
    line.resize(std::max(columns, drawn_), ' ');
    drawn_ = columns;
    write_to_terminal('\r' + line);
}

void Progress::clear() {
    if (drawn_ == 0) return;
    write_to_terminal('\r' + std::string(drawn_, ' ') + '\r');
    drawn_ = 0;
}

bool ProgressOrSignal::operator()(std::uint64_t done, std::uint64_t total) {
    if (!progress_) progress_.emplace(total);
    progress_->update(done);
    return InterruptGuard::signal() == 0;
}

}  // namespace carom
