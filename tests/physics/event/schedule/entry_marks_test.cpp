#include "physics/event/schedule/entry_marks.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("entry marks: a ball has one valid entry at most, in the heap or under a generation") {
    EntryMarks marks;
    marks.reset(2);
    CHECK(marks.size() == 2);
    CHECK(!marks.is_in_heap(0));
    const QueuedEvent first{1.0, 0, marks.next_generation(0)};
    const QueuedEvent other{1.0, 1, marks.next_generation(1)};
    CHECK(marks.is_valid(first));
    CHECK(marks.is_valid(other));

    const QueuedEvent second{2.0, 0, marks.next_generation(0)};
    CHECK(!marks.is_valid(first));
    CHECK(marks.is_valid(second));
    CHECK(!marks.is_in_heap(0));

    marks.put_in_heap(0, 5);
    CHECK(marks.is_in_heap(0));
    CHECK(marks.heap_index(0) == 5);
    CHECK(!marks.is_valid(second));

    marks.remove(0);
    CHECK(!marks.is_in_heap(0));
    CHECK(!marks.is_valid(first));
    CHECK(!marks.is_valid(second));
    CHECK(marks.is_valid(other));
}

TEST_CASE("entry marks: reset and restarted, they give generations from the first on") {
    EntryMarks marks;
    marks.reset(1);
    const std::uint32_t first = marks.next_generation(0);
    CHECK(first != 0);  // the mark of a ball without an entry
    CHECK(marks.next_generation(0) != first);
    CHECK(!marks.is_used_up());
    marks.reset(3);
    CHECK(!marks.is_valid({1.0, 0, first}));
    marks.restart_generations();
    CHECK(marks.next_generation(2) == first);
}
