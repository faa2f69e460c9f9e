#pragma once

#include <cstddef>
#include <deque>
#include <utility>

#include "terminal/input/input.h"

/// Input that waits to be handled.
namespace carom {

/// First in, first out, but for the end of the game and a hang-up, which come first. Bounded: when
/// `most_waiting` events wait, further ones are dropped and counted, except for a new size, the end
/// and a hang-up. So a pasted file costs little, and delays neither the end nor what is typed later
/// by more than the bound.
class InputQueue {
  public:
    static constexpr std::size_t most_waiting = 512;

    void push(const InputEvent& event);
    bool empty() const { return events_.empty(); }
    /// The next event. Pre: not empty.
    InputEvent pop();
    /// How many events were dropped since the last call.
    std::size_t take_dropped() { return std::exchange(dropped_, 0); }

  private:
    std::deque<InputEvent> events_;
    std::size_t dropped_ = 0;
};

}  // namespace carom
