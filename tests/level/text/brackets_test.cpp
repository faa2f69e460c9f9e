#include "level/text/brackets.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("brackets: splitting ignores separators inside them") {
    SourceText source;
    source.text = "min(1,2),3";
    source.lines = {source.text};
    const auto pieces = split_outside_brackets({source.text, &source, 1, 1}, ",");
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].text == "min(1,2)");
    CHECK(pieces[1].text == "3");
    CHECK(pieces[1].column == 10);
}

TEST_CASE("brackets: the innermost open one is reported, and a surplus ')' is not") {
    struct Row {
        const char* text;
        int column;  // of the bracket that is open; 0: none
    };
    for (const Row& row : {Row{"1,2", 0}, Row{"(1,2)", 0}, Row{"1),2", 0}, Row{"(1,2", 1},
                           Row{"(1+(2,3)", 1}, Row{"((1),(2", 6}}) {
        CAPTURE(row.text);
        SourceText source;
        source.text = row.text;
        source.lines = {source.text};
        Reporter reporter;
        CHECK(are_brackets_closed({source.text, &source, 1, 1}, reporter) == (row.column == 0));
        REQUIRE(reporter.errors() == (row.column == 0 ? 0 : 1));
        if (row.column > 0) CHECK(reporter.diagnostics()[0].column == row.column);
    }
}
