#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// UTF-8 to code points and back.
namespace carom {

/// Stands for bytes that are no UTF-8.
inline constexpr char32_t not_a_character = 0xFFFD;

struct DecodedCharacter {
    char32_t character = not_a_character;
    std::size_t bytes = 0;  ///< how many were read, >= 1
};

/// The first code point of `text`. Overlong forms, surrogates, what is beyond U+10FFFF and cut
/// sequences give `not_a_character` for one byte. Pre: text is not empty.
DecodedCharacter decode_utf8(std::string_view text);

/// Pre: character <= U+10FFFF and no surrogate.
void append_utf8(std::string& text, char32_t character);

/// Whether a terminal shows it, and in exactly one column: no control character, nothing that joins
/// the character before it, nothing from the scripts and pictures that are two columns wide.
bool is_one_column(char32_t character);

/// How many columns Canvas::write takes for `text`.
int columns_of(std::string_view text);

}  // namespace carom
