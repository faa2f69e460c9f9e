#include "carom/play/input_queue.h"

namespace carom {

void InputQueue::push(const InputEvent& event) {
    using enum InputEvent::Kind;
    if (event.kind == end || event.kind == hangup) return events_.push_front(event);
    if (event.kind == resize) {
        // The new size is asked for when it is handled, so one waiting is enough.
        if (events_.empty() || events_.back().kind != resize) events_.push_back(event);
        return;
    }
    if (events_.size() < most_waiting)
        events_.push_back(event);
    else
        ++dropped_;
}

InputEvent InputQueue::pop() {
    const InputEvent event = events_.front();
    events_.pop_front();
    return event;
}

}  // namespace carom
