#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// UTF-8 to code points and back (RFC 3629). The only place that knows the byte layout.
namespace carom {

/// The result of decode_utf8 for a byte that is not part of valid UTF-8: U+FFFD, the replacement
/// character.
inline constexpr char32_t not_a_character = 0xFFFD;

struct DecodedCharacter {
    char32_t character = not_a_character;
    std::size_t bytes = 0;  ///< bytes read, >= 1
};

/// The length in bytes of a sequence that starts with this byte, 1 to 4; 0 if none does.
std::size_t sequence_length(char lead);

/// Whether the byte is the second or a later byte of a sequence.
bool continues_sequence(char byte);

/// The length in bytes of the valid sequence at `i`, or 0: overlong forms, surrogates, code points
/// beyond U+10FFFF and truncated sequences are not valid. Pre: i < text.size().
std::size_t character_length(std::string_view text, std::size_t i = 0);

/// The first code point of `text`; `not_a_character` and one byte if character_length is 0. Pre:
/// text is not empty.
DecodedCharacter decode_utf8(std::string_view text);

/// Pre: character <= U+10FFFF and not a surrogate.
void append_utf8(std::string& text, char32_t character);

/// The number of code points in `text`; bytes that start none are not counted.
int characters(std::string_view text);

}  // namespace carom
