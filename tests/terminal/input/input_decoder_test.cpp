#include "terminal/input/input_decoder.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

#include "support/terminal_program.h"

using namespace carom;
using Action = InputEvent::Action;
using Kind = InputEvent::Kind;

namespace {

std::vector<InputEvent> events_of(std::string_view bytes) {
    InputDecoder decoder;
    return decoder.feed(bytes).events;
}

InputEvent key_event(char32_t key, std::uint8_t modifiers = no_modifier,
                     Action action = Action::press) {
    InputEvent event;
    event.key = key;
    event.modifiers = modifiers;
    event.action = action;
    return event;
}

void check_key(const InputEvent& event, const InputEvent& wanted) {
    CHECK(event.kind == Kind::key);
    CHECK(event.key == wanted.key);
    CHECK(event.modifiers == wanted.modifiers);
    CHECK(event.action == wanted.action);
}

}  // namespace

TEST_CASE("legacy key sequences") {
    struct Row {
        std::string_view bytes;
        InputEvent wanted;
    };
    const Row rows[] = {
        {"q", key_event(U'q')},
        {"Q", key_event(U'Q')},
        {"\xc3\xa9", key_event(U'\u00e9')},
        {"\xe2\x96\x88", key_event(U'\u2588')},
        {"\r", key_event(key::enter)},
        {"\n", key_event(key::enter)},
        {"\t", key_event(key::tab)},
        {"\x7f", key_event(key::backspace)},
        {"\b", key_event(key::backspace)},
        {"\x03", key_event(U'c', control)},
        {"\x1a", key_event(U'z', control)},
        {"\x1c", key_event(U'\\', control)},
        {"\033q", key_event(U'q', alt)},
        {"\033\xc3\xa9", key_event(U'\u00e9', alt)},
        {"\033[A", key_event(key::up)},
        {"\033OA", key_event(key::up)},
        {"\033[1;5C", key_event(key::right, control)},
        {"\033[1;2D", key_event(key::left, shift)},
        {"\033[1;3B", key_event(key::down, alt)},
        {"\033[H", key_event(key::home)},
        {"\033[4~", key_event(key::end)},
        {"\033[3~", key_event(key::remove)},
        {"\033[5;5~", key_event(key::page_up, control)},
        {"\033[Z", key_event(key::backtab)},
        {"\033OP", key_event(key::f1)},
        {"\033[15~", key_event(key::f1 + 4)},
        {"\033[24;2~", key_event(key::f1 + 11, shift)},
        {"\033Oj", key_event(U'*')},
        {"\033OM", key_event(key::enter)},
        {"\033\033[A", key_event(key::up, alt)},
        {"\033[27;5;46~", key_event(U'.', control)},
    };
    for (const Row& row : rows) {
        CAPTURE(std::string(row.bytes.substr(row.bytes[0] == '\033' ? 1 : 0)));
        const auto events = events_of(row.bytes);
        REQUIRE(events.size() == 1);
        check_key(events[0], row.wanted);
    }
}

TEST_CASE("keys under the kitty keyboard protocol") {
    struct Row {
        std::string_view bytes;
        InputEvent wanted;
    };
    const Row rows[] = {
        {"\033[113;1;113u", key_event(U'q')},
        {"\033[113;1:3u", key_event(U'q', no_modifier, Action::release)},
        {"\033[113;1:2;113u", key_event(U'q', no_modifier, Action::repeat)},
        {"\033[113;129;113u", key_event(U'q')},  // Num Lock
        {"\033[113;65;81u", key_event(U'Q')},    // Caps Lock
        {"\033[61;2;43u", key_event(U'+')},
        {"\033[97;2u", key_event(U'A')},
        {"\033[97;5u", key_event(U'a', control)},
        {"\033[97;9u", key_event(U'a', alt)},  // Super
        {"\033[27u", key_event(key::escape)},
        {"\033[13u", key_event(key::enter)},
        {"\033[9;2u", key_event(key::backtab)},
        {"\033[127u", key_event(key::backspace)},
        {"\033[32;1;32u", key_event(key::space)},
        {"\033[1;1:3A", key_event(key::up, no_modifier, Action::release)},
        {"\033[3;1:2~", key_event(key::remove, no_modifier, Action::repeat)},
        {"\033[57399;1;48u", key_event(U'0')},
        {"\033[57417u", key_event(key::left)},
        {"\033[57376u", key_event(key::f1 + 12)},
    };
    for (const Row& row : rows) {
        CAPTURE(std::string(row.bytes.substr(1)));
        const auto events = events_of(row.bytes);
        REQUIRE(events.size() == 1);
        check_key(events[0], row.wanted);
    }
}

TEST_CASE("a released key is the key that was pressed") {
    InputDecoder decoder;
    CHECK(decoder.feed("\033[61;2;43u").events.at(0).key == U'+');
    const auto released = decoder.feed("\033[61;1:3u").events;  // Shift was released first
    REQUIRE(released.size() == 1);
    check_key(released[0], key_event(U'+', no_modifier, Action::release));
}

TEST_CASE("modifiers alone, media keys and locks are ignored") {
    CHECK(events_of("\033[57441;2u\033[57441;1:3u\033[57358u\033[57430u").empty());
}

TEST_CASE("mouse reports") {
    const auto pressed = events_of("\033[<0;1;1M");
    REQUIRE(pressed.size() == 1);
    CHECK(pressed[0].kind == Kind::mouse);
    CHECK(pressed[0].action == Action::press);
    CHECK(pressed[0].button == 1);
    CHECK(pressed[0].column == 0.5);
    CHECK(pressed[0].row == 0.5);

    const auto several =
        events_of("\033[<2;300;120M\033[<34;301;120M\033[<2;301;120m\033[<35;4;5M");
    REQUIRE(several.size() == 4);
    CHECK(several[0].button == 3);
    CHECK(several[0].column == 299.5);
    CHECK(several[1].action == Action::move);
    CHECK(several[1].button == 3);
    CHECK(several[2].action == Action::release);
    CHECK(several[2].button == 3);
    CHECK(several[3].action == Action::move);
    CHECK(several[3].button == 0);

    const auto wheel = events_of("\033[<64;4;5M\033[<65;4;5M\033[<66;4;5M\033[<128;4;5M");
    REQUIRE(wheel.size() == 2);
    CHECK(wheel[0].action == Action::wheel_up);
    CHECK(wheel[1].action == Action::wheel_down);

    const auto modified = events_of("\033[<20;4;5M");
    REQUIRE(modified.size() == 1);
    CHECK(modified[0].modifiers == (shift | control));
    CHECK(modified[0].button == 1);
}

TEST_CASE("mouse reports in pixels are converted to cells") {
    InputDecoder decoder;
    decoder.set_mouse_unit({.wide = 10.0, .high = 20.0});
    const auto events = decoder.feed("\033[<0;26;31M").events;
    REQUIRE(events.size() == 1);
    CHECK(events[0].column == doctest::Approx(2.55));
    CHECK(events[0].row == doctest::Approx(1.525));
}

TEST_CASE("X10 mouse reports") {
    const auto events = events_of("\033[M !!\033[M#\"!q");
    REQUIRE(events.size() == 3);
    CHECK(events[0].action == Action::press);
    CHECK(events[0].button == 1);
    CHECK(events[1].action == Action::release);
    CHECK(events[1].button == 1);
    CHECK(events[1].column == 1.5);
    CHECK(events[2].key == U'q');
}

TEST_CASE("a thousand reports in one piece, or byte by byte, are a thousand events in order") {
    std::string burst;
    for (int i = 0; i < 1000; ++i) {
        burst += test::mouse_drag(0, i, 999 - i);
    }
    for (const std::size_t piece : {burst.size(), std::size_t{1}, std::size_t{7}}) {
        InputDecoder decoder;
        std::vector<InputEvent> events;
        for (std::size_t i = 0; i < burst.size(); i += piece) {
            for (const InputEvent& event :
                 decoder.feed(std::string_view(burst).substr(i, piece)).events) {
                events.push_back(event);
            }
        }
        REQUIRE(events.size() == 1000);
        for (int i = 0; i < 1000; ++i) {
            REQUIRE(events[static_cast<std::size_t>(i)].column == i + 0.5);
            REQUIRE(events[static_cast<std::size_t>(i)].row == 999 - i + 0.5);
        }
    }
}

TEST_CASE("the Escape key is told from the start of a sequence by a pause") {
    InputDecoder decoder;
    CHECK(decoder.feed("\033").events.empty());
    CHECK(decoder.pending() == InputDecoder::Pending::escape);
    const auto escape = decoder.flush().events;
    REQUIRE(escape.size() == 1);
    check_key(escape[0], key_event(key::escape));
    CHECK(decoder.pending() == InputDecoder::Pending::nothing);

    CHECK(decoder.feed("\033[").events.empty());
    const auto alt_bracket = decoder.flush().events;
    REQUIRE(alt_bracket.size() == 1);
    check_key(alt_bracket[0], key_event(U'[', alt));

    CHECK(decoder.feed("\033[12;3").events.empty());
    CHECK(decoder.pending() == InputDecoder::Pending::sequence);
    CHECK(decoder.flush().events.empty());

    CHECK(decoder.feed("\033\033").events.empty());
    CHECK(decoder.flush().events.size() == 2);
}

TEST_CASE("the Escape key is not lost to an answer or a report right behind it") {
    for (const std::string_view behind :
         {"\033[0n", "\033[<0;1;1M", "\033[M !!", "\033]11;rgb:0/0/0\007", "\033[?999;1$y"}) {
        InputDecoder decoder;
        const auto events = decoder.feed("\033" + std::string(behind)).events;
        REQUIRE_FALSE(events.empty());
        check_key(events[0], key_event(key::escape));
        CHECK(decoder.pending() == InputDecoder::Pending::nothing);
    }
}

TEST_CASE("unknown sequences are dropped whole") {
    const std::string_view unknown[] = {
        "\033[?1;2;3;4q",
        "\033[>1;95;0c",
        "\033[1;2;3;4;5;6;7;8;9x",
        "\033]52;c;cXE=\007",
        "\033]0;a title\033\\",
        "\033Pq#0;2;0\033\\",
        "\033_Gi=1;OK\033\\",
        "\033[1$q",
        "\033[I",
        "\033[O",
        "\033[999~",
        "\033Oz",
        "\033[99999999999;1u",
        "\033^q\033\\",
        "\xff\xfe\x80",
        "\xc3",
    };
    for (const std::string_view bytes : unknown) {
        InputDecoder decoder;
        CHECK(decoder.feed(bytes).events.empty());
        decoder.flush();
        const auto after = decoder.feed("\033[B").events;
        REQUIRE(after.size() == 1);
        CHECK(after[0].key == key::down);
    }
}

TEST_CASE("a paste is not typing") {
    const auto events = events_of("\033[200~quit everything\033[31m\r\033[201~x");
    REQUIRE(events.size() == 1);
    CHECK(events[0].key == U'x');
}

TEST_CASE("Ctrl-C interrupts any unfinished sequence") {
    for (const std::string_view begun : {"", "\033[12;", "\033O", "\xe2\x96"}) {
        InputDecoder decoder;
        const auto events = decoder.feed(std::string(begun) + "\x03").events;
        REQUIRE(events.size() == 1);
        check_key(events[0], key_event(U'c', control));
    }
}

TEST_CASE("answers are never keys, wherever they come and however they are split") {
    const std::string answers =
        "\033[?62;22c\033[0n\033[?2026;2$y\033[?1016;0$y\033[6;20;10t\033[?1u"
        "\033]11;rgb:ffff/8080/0000\033\\\033]11;rgb:1e/1e/1e\007"
        "\033P>|kitty(0.40.1)\033\\\033P1$r0;38:2::250:130:5m\033\\"
        "\033P1$r38;2;250;130;5m\033\\\033P1$r0;38:5:208m\033\\"
        "\033P1$r0m\033\\\033P0$r\033\\\033P1+r524742=382F382F38\033\\"
        "\033P0+r5463\033\\\033[>41;379;0c\033[>65;7006;1c";
    for (std::size_t cut = 0; cut <= answers.size(); ++cut) {
        InputDecoder decoder;
        DecodedInput first = decoder.feed(answers.substr(0, cut));
        const DecodedInput second = decoder.feed(answers.substr(cut));
        CHECK(first.events.empty());
        CHECK(second.events.empty());
        first.answers.insert(first.answers.end(), second.answers.begin(), second.answers.end());
        const std::vector<Answer> wanted = {
            {.kind = Answer::Kind::attributes},
            {.kind = Answer::Kind::status},
            {.kind = Answer::Kind::mode, .number = 2026, .is_offered = true},
            {.kind = Answer::Kind::mode, .number = 1016},
            {.kind = Answer::Kind::cell_size, .pixels_wide = 10, .pixels_high = 20},
            {.kind = Answer::Kind::key_flags},
            {.kind = Answer::Kind::background, .color = {255, 128, 0}},
            {.kind = Answer::Kind::background, .color = {30, 30, 30}},
            {.kind = Answer::Kind::version, .text = "kitty(0.40.1)"},
            {.kind = Answer::Kind::colors, .colors = direct_colors},
            {.kind = Answer::Kind::colors, .colors = direct_colors},
            {.kind = Answer::Kind::colors, .colors = 256},
            {.kind = Answer::Kind::colors},
            {.kind = Answer::Kind::colors, .colors = direct_colors},
            {.kind = Answer::Kind::version, .text = "vte(7006)"},  // xterm's is no name
        };
        CHECK(first.answers == wanted);
    }
}

TEST_CASE("keys of the terminal's own description take precedence") {
    KeyTable keys;
    keys.add("\033[[A", key::f1);
    keys.add("\033[7$", key::home, shift);
    InputDecoder decoder(true, keys);
    const auto events = decoder.feed("\033[[A\033[7$q").events;
    REQUIRE(events.size() == 3);
    CHECK(events[0].key == key::f1);
    CHECK(events[1].key == key::home);
    CHECK(events[1].modifiers == shift);
    CHECK(events[2].key == U'q');
}

TEST_CASE("outside of UTF-8 a byte is a character") {
    InputDecoder decoder(false);
    const auto events = decoder.feed("\xe9q").events;
    REQUIRE(events.size() == 2);
    CHECK(events[0].key == U'\u00e9');
    CHECK(events[1].key == U'q');
}

TEST_CASE("no sequence, whatever its bytes, becomes plain keys") {
    std::uint64_t state = 1;
    const auto random = [&](std::uint64_t below) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return (state >> 33) % below;
    };
    InputDecoder decoder;
    for (int round = 0; round < 20'000; ++round) {
        std::string sequence = "\033[";
        const std::uint64_t length = random(12);
        for (std::uint64_t i = 0; i < length; ++i) {
            sequence += static_cast<char>(0x20 + random(0x20));
        }
        sequence += static_cast<char>(0x40 + random(0x3f));
        if (sequence == "\033[M" || sequence == "\033[[") continue;  // incomplete
        if (sequence.ends_with('u')) continue;                       // may be keys
        for (const InputEvent& event : decoder.feed(sequence).events) {
            const bool is_plain = event.kind == Kind::key && event.key < key::up;
            CHECK_FALSE(is_plain);
        }
        decoder.flush();
    }
}

TEST_CASE("random bytes do no harm") {
    std::uint64_t state = 7;
    InputDecoder decoder;
    for (int round = 0; round < 20'000; ++round) {
        std::string bytes;
        for (int i = 0; i < 16; ++i) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            const auto byte = static_cast<char>(state >> 56);
            bytes += (state >> 40) % 5 == 0 ? '\033' : byte;
        }
        decoder.feed(bytes);
    }
    decoder.flush();
    CHECK(decoder.pending() == InputDecoder::Pending::nothing);
}
