#pragma once

#include <string_view>
#include <vector>

#include "level/text/reporter.h"
#include "level/text/words.h"

/// The round brackets of a word. Arithmetic in them may contain the separators of lists.
namespace carom {

/// Splits a word at each `separator` that is outside of brackets.
std::vector<Word> split_outside_brackets(const Word& word, std::string_view separator);

/// Reports an open bracket, which hides the commas behind it, in place of a wrong count of numbers.
/// Whether there is none.
bool are_brackets_closed(const Word& word, Reporter& reporter);

}  // namespace carom
