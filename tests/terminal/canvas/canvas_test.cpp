#include "terminal/canvas/canvas.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

using namespace carom;

TEST_CASE("a canvas starts blank, and negative sizes count as none") {
    CHECK(Canvas(3, 2).text() == "\n\n");
    CHECK(Canvas(3, 2).at(2, 1) == Cell{});
    CHECK(Canvas(-3, 2).columns() == 0);
    CHECK(Canvas(3, -2).rows() == 0);
    CHECK(Canvas().text().empty());
}

TEST_CASE("writing outside a canvas does nothing") {
    Canvas canvas(3, 2);
    for (const auto& [column, row] : {std::pair{-1, 0}, {3, 0}, {0, -1}, {0, 2}}) {
        canvas.put(column, row, {U'x'});
        CHECK_FALSE(canvas.holds(column, row));
    }
    canvas.write(-1, 0, "abcdef");
    canvas.write(0, 2, "abc");
    CHECK(canvas.text() == "bcd\n\n");
}

TEST_CASE("text is cut at the right edge, and the column after it is returned") {
    Canvas canvas(4, 1);
    CHECK(canvas.write(0, 0, "ab") == 2);
    CHECK(canvas.write(2, 0, "cdef") == 4);
    CHECK(canvas.text() == "abcd\n");
}

TEST_CASE("text keeps its colours and attributes") {
    Canvas canvas(4, 1);
    canvas.write(1, 0, "x", 3, 4, bold);
    CHECK(canvas.at(1, 0) == Cell{U'x', 3, 4, bold});
    CHECK(canvas.at(0, 0) == Cell{});
}

TEST_CASE("a character that is not one column wide becomes a question mark") {
    struct Row {
        std::string text;
        std::string shown;
    };
    const std::string escape = "\x1b[2J";
    const std::vector<Row> rows = {
        {"a\tb\nc", "a?b?c"},           // control characters
        {escape, "?[2J"},               // an escape sequence is only text
        {"\xc2\x9b", "?"},              // the C1 form of it
        {"e\xcc\x81", "e?"},            // a combining accent
        {"\xe6\xbc\xa2", "?"},          // a wide character
        {"\xe2\x80\xae", "?"},          // right-to-left override
        {"\xf0\x9f\x8e\xb1", "?"},      // a picture
        {"\xff\xc0\x80", "???"},        // not UTF-8
        {"\xed\xa0\x80", "???"},        // a surrogate
        {"\xe2\x82", "??"},             // truncated
        {"\xc3\xa9\xe2\x96\x88", "é█"}  // one column each
    };
    for (const Row& row : rows) {
        CAPTURE(row.text);
        Canvas canvas(8, 1);
        canvas.write(0, 0, row.text);
        CHECK(canvas.text() == row.shown + "\n");
    }
}
