#include "carom/play/input_queue.h"

#include <doctest/doctest.h>

using namespace carom;

namespace {

InputEvent pressed(char32_t code) {
    InputEvent event;
    event.key = code;
    return event;
}

InputEvent of_kind(InputEvent::Kind kind) {
    InputEvent event;
    event.kind = kind;
    return event;
}

}  // namespace

TEST_CASE("waiting input is handled in order, but the end and a hang-up come first") {
    InputQueue queue;
    queue.push(pressed(U'a'));
    queue.push(pressed(U'b'));
    queue.push(of_kind(InputEvent::Kind::end));
    CHECK(queue.pop().kind == InputEvent::Kind::end);
    CHECK(queue.pop().key == U'a');
    CHECK(queue.pop().key == U'b');
    CHECK(queue.empty());
}

TEST_CASE("waiting input is bounded: what is dropped is counted, and a new size is kept") {
    InputQueue queue;
    for (int i = 0; i < 100'000; ++i) {
        queue.push(pressed(U'x'));
        if (i % 100 == 0) queue.push(of_kind(InputEvent::Kind::resize));
    }
    queue.push(of_kind(InputEvent::Kind::hangup));
    CHECK(queue.pop().kind == InputEvent::Kind::hangup);
    std::size_t keys = 0;
    std::size_t sizes = 0;
    while (!queue.empty())
        ++(queue.pop().kind == InputEvent::Kind::resize ? sizes : keys);
    CHECK(sizes >= 1);
    CHECK(keys + sizes <= InputQueue::most_waiting + 1);
    CHECK(queue.take_dropped() == 100'000 - keys);
    CHECK(queue.take_dropped() == 0);
}
