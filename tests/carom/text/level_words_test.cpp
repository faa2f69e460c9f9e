#include "carom/text/level_words.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace carom;

namespace {

std::string text_of(const std::vector<std::string>& comment) {
    const LevelWords words = words_of(comment);
    std::string text = "<" + words.goal + ">\n";
    for (const LevelWords::Item& item : words.items)
        text += (item.left.empty() ? "" : "[" + item.left + "] ") + item.text + "\n";
    return text;
}

}  // namespace

TEST_CASE("a comment is laid out again: goal, paragraphs and lists") {
    CHECK(text_of({"Goal: drag a ball, and see", "what it pushes.", "",
                   "A paragraph of an author whose editor has a window of 80 columns or",
                   "so, which `goes on`.", "", "Try:", "  drag        a ball: it pushes the",
                   "              others away", "  right-drag  a cue"}) ==
          "<drag a ball, and see what it pushes.>\n"
          "A paragraph of an author whose editor has a window of 80 columns or so, which goes on.\n"
          "\n"
          "Try:\n"
          "[drag] a ball: it pushes the others away\n"
          "[right-drag] a cue\n");
}

TEST_CASE("short lines and indented lines stay lines") {
    CHECK(text_of({"A title", "another line", "  a verse", "  of two lines"}) ==
          "<>\nA title\nanother line\na verse\nof two lines\n");
    CHECK(text_of({}) == "<>\n");
    CHECK(text_of({"", "", ""}) == "<>\n");
}
