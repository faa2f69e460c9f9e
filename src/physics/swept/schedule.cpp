#include "physics/swept/schedule.h"

namespace carom {

void SweptSchedule::clear() {
    unsorted_.clear();
    next_initial_ = initial_.size();
    took_initial_ = false;
    queue_.clear();
}

// Bins of time hold about one event each.
void SweptSchedule::sort_initial(double duration) {
    const std::size_t count = unsorted_.size();
    next_initial_ = 0;
    initial_.resize(count);
    bin_start_.assign(count + 1, 0);
    const double bins = static_cast<double>(count) / duration;
    const auto bin = [&](const SweptEvent& event) {
        return std::min(count - 1, static_cast<std::size_t>(event.time * bins));
    };
    for (const SweptEvent& event : unsorted_)
        ++bin_start_[bin(event)];
    std::uint32_t end = 0;
    for (std::uint32_t& start : bin_start_)
        start = end += start;
    for (const SweptEvent& event : unsorted_)
        initial_[--bin_start_[bin(event)]] = event;
    for (std::size_t s = 0; s < count; ++s)
        if (bin_start_[s + 1] > bin_start_[s] + 1)
            std::sort(initial_.begin() + bin_start_[s], initial_.begin() + bin_start_[s + 1],
                      [](const SweptEvent& a, const SweptEvent& b) { return is_earlier(a, b); });
}

}  // namespace carom
