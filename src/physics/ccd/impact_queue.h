#pragma once

#include <algorithm>
#include <vector>

/// Impacts predicted within a substep, earliest first: for the solvers `swept` and `contact`.
namespace carom {

/// The order in which impacts are resolved: by time, then by `Event::tie_break()`, a tuple that is
/// total over the events of a substep (kind, lower number, higher number, predicting body). So the
/// result depends neither on cells nor on the order of predictions.
template <typename Event>
bool is_earlier(const Event& a, const Event& b) {
    if (a.time != b.time) return a.time < b.time;
    return a.tie_break() < b.tie_break();
}

/// A binary heap. A prediction whose body has changed its path since stays in it until it comes
/// up: compare versions then. Memory is kept from substep to substep.
template <typename Event>
class ImpactQueue {
  public:
    void clear() { events_.clear(); }
    bool is_empty() const { return events_.empty(); }
    /// Pre: not empty.
    const Event& first() const { return events_.front(); }

    void push(const Event& event) {
        events_.push_back(event);
        std::push_heap(events_.begin(), events_.end(), Later{});
    }
    /// Takes out the first event. Pre: not empty.
    Event pop() {
        std::pop_heap(events_.begin(), events_.end(), Later{});
        const Event event = events_.back();
        events_.pop_back();
        return event;
    }

  private:
    // A function object, which the algorithms inline, as they do not a pointer to a function.
    struct Later {
        bool operator()(const Event& a, const Event& b) const { return is_earlier(b, a); }
    };

    std::vector<Event> events_;
};

}  // namespace carom
