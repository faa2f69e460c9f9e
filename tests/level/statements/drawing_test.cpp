#include "level/statements/drawing.h"

#include <doctest/doctest.h>

using namespace carom;

namespace {

// Lines of a drawing, as words.
struct Lines {
    explicit Lines(std::vector<std::string_view> texts) {
        for (std::size_t i = 0; i < texts.size(); ++i)
            words.push_back({texts[i], &source, static_cast<int>(i) + 1, 1});
    }
    SourceText source;
    std::vector<Word> words;
};

}  // namespace

TEST_CASE("drawing: each character is a cell, however many bytes it has; outside all is blank") {
    const Lines lines({"aé#", "o"});
    const Drawing drawing(lines.words);
    CHECK(drawing.rows() == 2);
    CHECK(drawing.columns() == 3);
    CHECK(drawing.length(1) == 1);
    CHECK(drawing.at(0, 1) == "é");
    CHECK(drawing.at(0, 2) == "#");
    CHECK(drawing.at(1, 2) == " ");
    CHECK(drawing.at(-1, 0) == " ");
    CHECK(drawing.at(2, 0) == " ");
    CHECK(drawing.span(0, 2).column == 3);
    CHECK(drawing.span(1, 0).line == 2);
}

TEST_CASE("drawing: a legend of the level redefines a built-in letter, and makes + a letter") {
    LevelIr ir;
    const DrawingLetters letters(ir);
    CHECK(letters.legend_of("o")->what == LegendIr::What::ball);
    CHECK(letters.legend_of("#")->what == LegendIr::What::solid);
    CHECK(letters.legend_of("*")->what == LegendIr::What::peg);
    CHECK(letters.legend_of("x") == nullptr);
    CHECK(letters.is_joint("+"));
    ir.legends["o"] = {.what = LegendIr::What::peg};
    ir.legends["+"] = {.what = LegendIr::What::ball};
    CHECK(letters.legend_of("o")->what == LegendIr::What::peg);
    CHECK_FALSE(letters.is_joint("+"));
}

TEST_CASE("drawing: an unknown character is reported once, and a comment in place of its letters") {
    const LevelIr ir;
    const DrawingLetters letters(ir);
    const auto errors_in = [&](std::vector<std::string_view> texts) {
        const Lines lines(std::move(texts));
        Reporter reporter;
        const bool is_valid = letters.check(Drawing(lines.words), reporter);
        CHECK(is_valid == !reporter.has_errors());
        return reporter.errors();
    };
    CHECK(errors_in({"##o*", "/-|\\ .+"}) == 0);
    CHECK(errors_in({"xox", "x"}) == 1);
    CHECK(errors_in({"xy"}) == 2);
    CHECK(errors_in({"o  # the ball"}) == 1);
}
