#include "terminal/screen/environment.h"

#include <doctest/doctest.h>

#include <map>
#include <string>
#include <string_view>

using namespace carom;

namespace {

std::string described(const std::map<std::string, std::string>& variables) {
    return described_terminal([&](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() ? std::string{} : found->second;
    });
}

}  // namespace

TEST_CASE("a terminal that sets TERM to xterm and has 256 colours gets them") {
    CHECK(described({{"TERM", "xterm"}}) == "xterm");
    CHECK(described({{"TERM", "xterm"}, {"XTERM_VERSION", "XTerm(379)"}}) == "xterm-256color");
    CHECK(described({{"TERM", "xterm"}, {"VTE_VERSION", "7006"}}) == "xterm-256color");
    CHECK(described({{"TERM", "xterm"}, {"COLORTERM", "truecolor"}}) == "xterm-256color");
}

TEST_CASE("COLORTERM promises 24-bit colours, but not for GNU screen") {
    const auto promises = [](const char* term, const char* colorterm) {
        return has_direct_colors([&](const char* name) {
            return std::string(std::string_view(name) == "TERM" ? term : colorterm);
        });
    };
    CHECK(promises("xterm-256color", "truecolor"));
    CHECK(promises("tmux-256color", "24bit"));
    CHECK_FALSE(promises("xterm-256color", "yes"));
    CHECK_FALSE(promises("xterm-256color", ""));
    CHECK_FALSE(promises("screen-256color", "truecolor"));
}

TEST_CASE("a size in the environment counts if it is one") {
    CHECK(cells_from("132") == 132);
    CHECK(cells_from("99999999") == 99999999);
    CHECK(cells_from("") == 0);
    CHECK(cells_from("-5") == 0);
    CHECK(cells_from("80x24") == 0);
    CHECK(cells_from("99999999999999999999") == 0);
}

TEST_CASE("all other terminals keep their description") {
    CHECK(described({}) == "");
    CHECK(described({{"TERM", "vt100"}, {"COLORTERM", "truecolor"}}) == "vt100");
    CHECK(described({{"TERM", "screen"}, {"XTERM_VERSION", "XTerm(379)"}}) == "screen");
    CHECK(described({{"TERM", "xterm-direct"}, {"COLORTERM", "24bit"}}) == "xterm-direct");
}
