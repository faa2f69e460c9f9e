#include <doctest/doctest.h>

#include "document.h"
#include "figures.h"
#include "guard_figures.h"

using namespace carom::bench;

TEST_CASE("a document gets new blocks after their marks, and keeps the rest") {
    const std::string text =
        "# Head\n<!-- bench a -->\n```text\nold\nolder\n```\nbetween\n<!-- bench b -->\n"
        "```text\n```\n```\nnot mine\n```\n";
    CHECK(with_blocks(text, {{"a", "new\n"}}) ==
          "# Head\n<!-- bench a -->\n```text\nnew\n```\nbetween\n<!-- bench b -->\n"
          "```text\n```\n```\nnot mine\n```\n");
    CHECK(with_blocks(text, {}) == text);
    const std::string twice = with_blocks(with_blocks(text, {{"b", "x\n"}}), {{"b", "x\n"}});
    CHECK(twice == with_blocks(text, {{"b", "x\n"}}));
}

TEST_CASE("figures are short") {
    CHECK(figure(0.04312) == "0.0431");
    CHECK(figure(3.5312) == "3.53");
    CHECK(figure(1'234'567.0) == "1,230,000");
    CHECK(small_figure(0.0) == "0");
    CHECK(small_figure(0.2149) == "0.21");
    CHECK(small_figure(3.2e-5) == "3e-05");
    CHECK(change(-0.372) == "-37 %");
    CHECK(change(-1e-13) == "1e-13");
    CHECK(grouped(-10'000.0) == "-10,000");
}

TEST_CASE("the guard reports changes beyond the limit, and rows missing on either side") {
    const auto written = parse_guard("# for people\ngas event 1000\ngas swept 1000\nold event 5\n");
    REQUIRE(written.size() == 3);
    const auto none = guard_differences(written, written, 0.0);
    CHECK(none.empty());

    const auto counted = parse_guard("gas event 1029\ngas swept 960\nnew event 7\n");
    const auto differences = guard_differences(written, counted, 0.03);
    REQUIRE(differences.size() == 3);
    CHECK(differences[0].find("gas under swept") == 0);
    CHECK(differences[0].find("-4.0 %") != differences[0].npos);
    CHECK(differences[1].find("new under event") == 0);
    CHECK(differences[2].find("old under event") == 0);
    CHECK(parse_guard(guard_text(counted)).size() == counted.size());
}
