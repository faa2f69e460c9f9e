#pragma once

#include <string_view>

/// The width of text in terminal columns. The table is carom's own, because the C library's depends
/// on the locale and on the library's age (Debian 12's does not know the octants of Unicode 16).
namespace carom {

/// Whether a terminal shows the character in exactly one column. False for control characters,
/// combining marks, and scripts and emoji that take two columns.
bool is_one_column(char32_t character);

/// The number of columns that Canvas::write takes for `text`.
int columns_of(std::string_view text);

}  // namespace carom
