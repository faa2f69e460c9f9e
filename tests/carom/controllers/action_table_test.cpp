#include <doctest/doctest.h>
#include <fmt/format.h>

#include <set>
#include <string>
#include <utility>
#include <variant>

#include "carom/context/key_map.h"
#include "carom/support/process.h"
#include "terminal/draw/overlays.h"

using namespace carom;

namespace {

std::string_view where_text(Where where) {
    constexpr std::string_view texts[] = {"everywhere", "not in a recording",
                                          "not in a recording or a game of pinball", "pool",
                                          "pinball"};
    return texts[static_cast<std::size_t>(where)];
}

/// The keys of the table, each in code quotes.
std::string code_of(std::string_view keys) {
    std::string text = "`";
    for (const char c : keys)
        text += c == ' ' ? std::string("` `") : std::string(1, c);
    return text + "`";
}

/// The list in docs/command-line.md, generated from the table of actions.
std::string list_of_actions() {
    std::string text = "| action | keys | does | applies |\n|---|---|---|---|\n";
    for (const Action& action : actions())
        text += fmt::format("| `{}` | {} | {} | {} |\n", action.name, code_of(action.keys),
                            action.help, where_text(action.where));
    return text;
}

}  // namespace

TEST_CASE("docs/command-line.md lists every action, with its keys and effect") {
    const std::string manual = carom::test::content(CAROM_SOURCE_DIR "/docs/command-line.md");
    const std::string list = list_of_actions();
    INFO("it should hold exactly this:\n", list);
    CHECK(manual.find("\n" + list + "\n") != std::string::npos);
}

TEST_CASE("within a layer, a default key belongs to one action") {
    const KeyMap keys;
    std::set<std::pair<KeyLayer, std::string_view>> seen;
    for (const Action& action : actions()) {
        std::string_view rest = action.keys;
        while (!rest.empty()) {
            const std::string_view key = rest.substr(0, rest.find(' '));
            CAPTURE(action.name);
            CAPTURE(key);
            CHECK(seen.emplace(layer_of(action), key).second);
            REQUIRE(key_named(key));
            CHECK(keys.action_of(*key_named(key), layer_of(action)) == &action);
            rest.remove_prefix(std::min(key.size() + 1, rest.size()));
        }
    }
}

TEST_CASE("an action's effect fits where it applies") {
    for (const Action& action : actions()) {
        CAPTURE(action.name);
        const bool is_for_pool =
            std::holds_alternative<void (*)(PoolController&, PlayContext&)>(action.perform);
        const bool is_for_all = std::holds_alternative<void (*)(PlayContext&)>(action.perform);
        CHECK(is_for_pool == (action.where == Where::pool));
        CHECK(is_for_all == (action.where < Where::pool));
    }
}

TEST_CASE("every overlay has an action of its name, with a key, that toggles it") {
    for (const Overlay& overlay : overlays()) {
        CAPTURE(overlay.name);
        const Action* const action = action_named(overlay.name);
        REQUIRE(action);
        CHECK_FALSE(action->keys.empty());
    }
}
