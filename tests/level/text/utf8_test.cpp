#include "level/text/utf8.h"

#include <doctest/doctest.h>

#include <string>

using namespace carom;

TEST_CASE("every code point survives UTF-8 and back") {
    for (char32_t character = 1; character <= 0x10FFFF; character += 7) {
        if (character >= 0xD800 && character <= 0xDFFF) continue;
        std::string text;
        append_utf8(text, character);
        const DecodedCharacter decoded = decode_utf8(text);
        REQUIRE(decoded.character == character);
        REQUIRE(decoded.bytes == text.size());
    }
}

TEST_CASE("bytes that are not valid UTF-8 are read one at a time") {
    for (const std::string text : {"\x80", "\xff", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf",
                                   "\xed\xa0\x80", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80",
                                   "\xf5\x80\x80\x80", "\xe2\x82", "\xe2\x82x", "\xc3"}) {
        CAPTURE(text);
        CHECK(character_length(text) == 0);
        CHECK(decode_utf8(text).character == not_a_character);
        CHECK(decode_utf8(text).bytes == 1);
    }
}

TEST_CASE("the first and the last code point of each length are valid") {
    for (const char32_t character : {char32_t{1}, char32_t{0x7f}, char32_t{0x80}, char32_t{0x7ff},
                                     char32_t{0x800}, char32_t{0xd7ff}, char32_t{0xe000},
                                     char32_t{0xffff}, char32_t{0x10000}, char32_t{0x10ffff}}) {
        std::string text = "x";
        append_utf8(text, character);
        CHECK(character_length(text, 1) == text.size() - 1);
        CHECK(decode_utf8(text.substr(1)).character == character);
    }
}

TEST_CASE("bytes that start no code point are not counted") {
    CHECK(characters("") == 0);
    CHECK(characters("a\u2588\U0001CD00") == 3);
    CHECK(characters("\x80\x80z") == 1);
}
