#include "terminal/panels/panel.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace carom;

TEST_CASE("text is wrapped at blanks, and only longer words are cut") {
    using Lines = std::vector<std::string>;
    CHECK(wrapped("", 10) == Lines{""});
    CHECK(wrapped("one two", 10) == Lines{"one two"});
    CHECK(wrapped("one two", 7) == Lines{"one two"});
    CHECK(wrapped("one two", 6) == Lines{"one", "two"});
    CHECK(wrapped("one   two", 4) == Lines{"one", "two"});
    CHECK(wrapped("onetwothree", 4) == Lines{"onet", "woth", "ree"});
    CHECK(wrapped("  indented", 20) == Lines{"  indented"});
    CHECK(wrapped("äöü äöü", 3) == Lines{"äöü", "äöü"});
    CHECK(wrapped("go for 3 s, then stop", 8) == Lines{"go for", "3 s,", "then", "stop"});
    CHECK(wrapped("go for 3 so", 8) == Lines{"go for 3", "so"});
    CHECK(wrapped("3 s", 1) == Lines{"3", "s"});
    CHECK(wrapped("abc", 0) == Lines{"a", "b", "c"});
}

TEST_CASE("text is cut by columns, not by bytes") {
    CHECK(cut_to("äöü", 2) == "äö");
    CHECK(cut_to("abc", 9) == "abc");
    CHECK(cut_to("abc", 0).empty());
    CHECK(cut_to("abc", -2).empty());
}

TEST_CASE("texts flow, and are kept together where possible") {
    const std::vector<PanelText> texts = {{"one", {}}, {"two", {}}, {"three", {}}};
    CHECK(rows_for(texts, 20) == 1);
    CHECK(rows_for(texts, 8) == 2);
    CHECK(rows_for(texts, 1) == 3);
    CHECK(rows_for({}, 5) == 1);
    Canvas canvas(12, 4);
    write_flowing(canvas, {2, 1, 8, 2}, texts);
    CHECK(canvas.text() == "\n  one  two\n  three\n\n");
    Canvas narrow(12, 4);
    write_flowing(narrow, {2, 1, 4, 2}, texts);
    CHECK(narrow.text() == "\n  one\n  two\n\n");
}

TEST_CASE("text that is too long for its line ends at a word, with an ellipsis") {
    Look look;
    look.utf8 = true;
    const std::string text = "player 1 breaks: ball in hand behind the head string";
    CHECK(shortened(text, 60, look) == text);
    CHECK(shortened(text, 38, look) == "player 1 breaks: ball in hand behind\u2026");
    CHECK(shortened(text, 37, look) == "player 1 breaks: ball in hand behind\u2026");
    CHECK(shortened(text, 36, look) == "player 1 breaks: ball in hand\u2026");
    CHECK(shortened(text, 20, look) == "player 1 breaks\u2026");
    CHECK(shortened(text, 4, look) == "play");
    look.utf8 = false;
    CHECK(shortened(text, 38, look) == "player 1 breaks: ball in hand...");
    CHECK(shortened("", 0, look).empty());
}
