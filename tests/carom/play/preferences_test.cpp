#include "carom/play/preferences.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "carom/support/home.h"
#include "carom/support/process.h"

using namespace carom;

TEST_CASE("an empty text changes nothing") {
    const PreferencesText read = read_preferences("", "preferences");
    CHECK(read.problems.empty());
    CHECK_FALSE(read.preferences.renderer);
    CHECK(read.preferences.keys.action_of({U'.', no_modifier}) == action_named("step-forward"));
}

TEST_CASE("settings and keys are read") {
    const PreferencesText read = read_preferences(
        "# mine\n"
        "renderer = braille   # dots\n"
        "  colors=16\r\n"
        "background = light\n"
        "fps = 30\n"
        "key-repeat = 250 33\n"
        "mouse = off\n"
        "color-by = speed\n"
        "balls = outline\n"
        "trails = on\n"
        "\n"
        "p = pause\n"
        "q = none\n"
        "equals = slower\n"
        "hash = help\n"
        "ctrl-up = zoom-in",
        "preferences");
    CHECK(read.problems == std::vector<std::string>{});
    const Preferences& p = read.preferences;
    CHECK(p.renderer == &braille_renderer());
    CHECK(p.colors == ColorChoice::c16);
    CHECK(p.light_background == true);
    CHECK(p.fps == 30.0);
    CHECK(p.key_repeat == KeyRepeatTimes{0.25, 0.033});
    CHECK(p.mouse == false);
    CHECK(p.color_by == ColorBy::speed);
    CHECK(p.ball_style == BallStyle::outline);
    CHECK(p.trails);
    CHECK(p.keys.action_of({U'p', no_modifier}) == action_named("pause"));
    CHECK(p.keys.action_of({U'q', no_modifier}) == nullptr);
    CHECK(p.keys.action_of({U'=', no_modifier}) == action_named("slower"));
    CHECK(p.keys.action_of({U'#', no_modifier}) == action_named("help"));
    CHECK(p.keys.action_of({key::up, control}) == action_named("zoom-in"));
}

TEST_CASE("an error is reported with its place, and the rest counts") {
    struct Row {
        const char* text;
        const char* problem;
    };
    const Row table[] = {
        {"renderer = brail",
         "p:1:12: error: 'brail' is none of auto, ascii, half, quadrants, sextants, octants, "
         "braille"},
        {"renderer =",
         "p:1:1: error: '' is none of auto, ascii, half, quadrants, sextants, octants, braille"},
        {"theme = dusk",
         "p:1:9: error: 'dusk' is none of auto, dark, light, contrast, color-blind"},
        {"colors = 24", "p:1:10: error: '24' is none of auto, mono, 8, 16, 256, truecolor"},
        {"fps = fast", "p:1:7: error: 'fast' is not a number in 1..1000"},
        {"key-repeat = 660",
         "p:1:14: error: '660' is not a delay in 100..2000 ms and a period in 1..200 ms, as in "
         "'660 40'"},
        {"fps = 0", "p:1:7: error: '0' is not a number in 1..1000"},
        {"  hello", "p:1:3: error: expected 'key = action' or 'setting = value'"},
        {"= pause", "p:1:1: error: a name is missing before '='"},
        {"xx = pause", "p:1:1: error: there is no key or setting 'xx'"},
        {"color = 16", "p:1:1: error: there is no key or setting 'color'; did you mean 'colors'?"},
        {"x = puase", "p:1:5: error: there is no action 'puase'; did you mean 'pause'?"},
        {"\xc3\xa9 = xyzzy", "p:1:5: error: there is no action 'xyzzy'"},
    };
    for (const Row& row : table) {
        CAPTURE(row.text);
        const PreferencesText read =
            read_preferences(std::string(row.text) + "\ntrails = on\n", "p");
        REQUIRE(read.problems.size() == 1);
        CHECK(read.problems[0] == row.problem);
        CHECK(read.preferences.trails);
    }
}

TEST_CASE("a file of preferences that cannot be read is a problem, and none at all is not") {
    const test::Home home;
    CHECK(load_preferences().problems.empty());
    std::filesystem::create_directories(home.preferences());
    const PreferencesText unread = load_preferences();
    REQUIRE(unread.problems.size() == 1);
    CHECK(unread.problems.front() ==
          "cannot read '" + home.preferences().string() + "': Is a directory");
}

TEST_CASE("a byte order mark before the first setting is no part of it") {
    const PreferencesText read = read_preferences("\xef\xbb\xbfmouse = off\r\n", "preferences");
    CHECK(read.problems.empty());
    CHECK(read.preferences.mouse == false);
    CHECK(with_setting("\xef\xbb\xbfmouse = off\n", "mouse", "on") == "mouse = on\n");
}

TEST_CASE("a setting is changed in place, and everything else stays") {
    const std::string text =
        "# my preferences\n"
        "renderer = ascii  # best\n"
        "p = pause\n"
        "renderer = half\n";
    CHECK(with_setting(text, "renderer", "braille") ==
          "# my preferences\n"
          "renderer = braille  # best\n"
          "p = pause\n");
    CHECK(with_setting(text, "trails", "on") == text + "trails = on\n");
    CHECK(with_setting("", "trails", "on") == "trails = on\n");
    CHECK(with_setting("no end", "trails", "on") == "no end\ntrails = on\n");
}

TEST_CASE("kept settings read back") {
    for (const std::string_view name : renderer_choice_names()) {
        const std::string text = with_setting("", "renderer", name);
        CHECK(read_preferences(text, "p").preferences.renderer == renderer_choice(name));
    }
    for (const ColorBy by : {ColorBy::kind, ColorBy::speed, ColorBy::mass}) {
        const std::string text = with_setting("", "color-by", text_of(by));
        CHECK(read_preferences(text, "p").preferences.color_by == by);
    }
}

TEST_CASE("preferences of an older carom are read: actions keep their names") {
    const std::string text =
        carom::test::content(CAROM_SOURCE_DIR "/tests/carom/play/samples/preferences");
    const PreferencesText read = read_preferences(text, "preferences");
    CHECK(read.problems == std::vector<std::string>{});
    const KeyMap& keys = read.preferences.keys;
    CHECK(keys.action_of(*key_named("ctrl-a")) == action_named("pause"));
    CHECK(keys.action_of(*key_named("f20")) == action_named("take-up"));
    CHECK(keys.action_of(*key_named("q")) == nullptr);
    CHECK(read.preferences.fps == 30.0);
    CHECK(read.preferences.bell);
    std::size_t bound = 0;
    for (const Action& action : actions())
        if (layer_of(action) == KeyLayer::common)
            bound += keys.keys_of(action).size() > 1 || action.name == "quit" ? 1 : 0;
    CHECK(bound == 65);
}
