#pragma once

#include <string_view>

/// How many columns of a terminal text takes, by a table of our own: the C library's depends on the
/// locale and on its age (Debian 12's does not know the octants of Unicode 16).
namespace carom {

/// Whether a terminal shows the character, and in exactly one column. False for control characters,
/// for marks that combine with the character before them, and for scripts and emoji that take two
/// columns.
bool is_one_column(char32_t character);

/// How many columns Canvas::write takes for `text`.
int columns_of(std::string_view text);

}  // namespace carom
