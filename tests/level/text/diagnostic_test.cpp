#include "level/text/diagnostic.h"

#include <doctest/doctest.h>

#include "level/text/spelling.h"

using namespace carom;

TEST_CASE("a diagnostic renders with line, caret, remedy and includes") {
    Diagnostic d;
    d.file = "levels/canyon.level";
    d.line = 12;
    d.column = 22;
    d.length = 4;
    d.message = "r must not be negative, but is -0.2";
    d.remedy = "write a length, such as r=0.2";
    d.source = "edge wood 1,2 4,2  r=-0.2";
    CHECK(render(d) ==
          "levels/canyon.level:12:22: error: r must not be negative, but is -0.2\n"
          "   12 | edge wood 1,2 4,2  r=-0.2\n"
          "      |                      ^~~~\n"
          "      = write a length, such as r=0.2\n");
    d.severity = Severity::warning;
    d.remedy.clear();
    d.line = 1234567;
    d.included_from = {{"inner.level", 3}, {"outer.level", 9}};
    CHECK(render(d) ==
          "levels/canyon.level:1234567:22: warning: r must not be negative, but is -0.2\n"
          "1234567 | edge wood 1,2 4,2  r=-0.2\n"
          "        |                      ^~~~\n"
          "        included from inner.level:3\n"
          "        included from outer.level:9\n");
}

TEST_CASE("rendering replaces control characters and invalid UTF-8") {
    Diagnostic d;
    d.file = "a\x1b[2J";
    d.message = "'\x1b[31m' is \xff";
    d.remedy =
        "see \xc2\x9b"
        "1m";
    d.source = "\x9b\xc3\xa4";
    d.included_from = {{"b\r", 3}};
    CHECK(render(d) ==
          "a?[2J:1:1: error: '?[31m' is ?\n"
          "    1 | ?\xc3\xa4\n"
          "      | ^\n"
          "      = see ?1m\n"
          "      included from b?:3\n");
}

TEST_CASE("control characters of the source line are replaced") {
    Diagnostic d;
    d.file = "a";
    d.message = "m";
    d.source = "x\x1b[31m\ty\x7f\xc2\x9bz";
    const std::string text = render(d);
    CHECK(text.find('\x1b') == std::string::npos);
    CHECK(text.find("\xc2\x9b") == std::string::npos);
    CHECK(text.find("x?[31m y??z") != std::string::npos);
}

TEST_CASE("carets count characters, and long lines are cut around the span") {
    Diagnostic d;
    d.file = "a";
    d.message = "m";
    d.source =
        "gr\xc3\xb6\xc3\x9f"
        "e=x";
    d.column = 7;
    CHECK(render(d) ==
          "a:1:7: error: m\n    1 | gr\xc3\xb6\xc3\x9f"
          "e=x\n      |       ^\n");
    d.source = std::string(300, '.') + "HERE" + std::string(300, '.');
    d.column = 301;
    d.length = 4;
    const std::string text = render(d);
    CHECK(text.size() < 300);
    const std::size_t line = text.find("HERE") - text.find("    1 |");
    const std::size_t caret = text.find("^~~~") - text.find("      |");
    CHECK(line == caret);
    d.column = 9999;
    CHECK(!render(d).empty());
}

TEST_CASE("did_you_mean suggests the nearest word") {
    CHECK(edit_distance("bumper", "bumper") == 0);
    CHECK(edit_distance("bmuper", "bumper") == 1);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(nearest_word("bumpr", {"ball", "bumper", "box"}) == "bumper");
    CHECK_FALSE(nearest_word("xyz", {"ball", "bumper", "box"}));
    CHECK_FALSE(nearest_word("", {"ball"}));
    CHECK(did_you_mean("bal", {"ball"}, "no") == "did you mean 'ball'?");
    CHECK(did_you_mean("zzz", {"ball"}, "no") == "no");
}
