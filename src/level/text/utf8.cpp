#include "level/text/utf8.h"

namespace carom {
namespace {

unsigned byte_at(std::string_view text, std::size_t i) {
    return static_cast<unsigned char>(text[i]);
}

}  // namespace

std::size_t sequence_length(char lead) {
    const auto first = static_cast<unsigned char>(lead);
    if (first < 0x80) return 1;
    if (first < 0xc2 || first > 0xf4) return 0;
    return first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
}

bool continues_sequence(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

std::size_t character_length(std::string_view text, std::size_t i) {
    const std::size_t length = sequence_length(text[i]);
    if (length <= 1) return length;
    if (i + length > text.size()) return 0;
    // The second byte distinguishes overlong forms, surrogates and code points beyond U+10FFFF.
    const unsigned first = byte_at(text, i);
    const unsigned second = byte_at(text, i + 1);
    const unsigned low = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
    const unsigned high = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
    if (second < low || second > high) return 0;
    for (std::size_t k = 2; k < length; ++k)
        if (!continues_sequence(text[i + k])) return 0;
    return length;
}

DecodedCharacter decode_utf8(std::string_view text) {
    const std::size_t length = character_length(text);
    if (length == 0) return {not_a_character, 1};
    if (length == 1) return {byte_at(text, 0), 1};
    char32_t character = byte_at(text, 0) & (0x7fu >> length);
    for (std::size_t k = 1; k < length; ++k)
        character = (character << 6) | (byte_at(text, k) & 0x3fu);
    return {character, length};
}

void append_utf8(std::string& text, char32_t character) {
    const auto add = [&](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (character < 0x80) return add(character);
    if (character < 0x800) {
        add(0xc0 | (character >> 6));
    } else {
        if (character < 0x10000) {
            add(0xe0 | (character >> 12));
        } else {
            add(0xf0 | (character >> 18));
            add(0x80 | ((character >> 12) & 0x3f));
        }
        add(0x80 | ((character >> 6) & 0x3f));
    }
    add(0x80 | (character & 0x3f));
}

int characters(std::string_view text) {
    int count = 0;
    for (const char byte : text)
        count += !continues_sequence(byte);
    return count;
}

}  // namespace carom
