#include "level/text/brackets.h"

namespace carom {

std::vector<Word> split_outside_brackets(const Word& word, std::string_view separator) {
    std::vector<Word> pieces;
    int depth = 0;
    std::size_t start = 0;
    for (std::size_t i = 0; i < word.text.size(); ++i) {
        const char c = word.text[i];
        if (c == '(') ++depth;
        if (c == ')') --depth;
        if (depth > 0 || word.text.substr(i, separator.size()) != separator) continue;
        pieces.push_back(word.part(start, i - start));
        i += separator.size() - 1;
        start = i + 1;
    }
    pieces.push_back(word.part(start));
    return pieces;
}

bool are_brackets_closed(const Word& word, Reporter& reporter) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < word.text.size(); ++i) {
        if (word.text[i] == '(') open.push_back(i);
        if (word.text[i] == ')' && !open.empty()) open.pop_back();
    }
    if (open.empty()) return true;
    reporter.error("bracket-not-closed", word.part(open.back(), 1).span(), "the ')' is missing",
                   "arithmetic is written without spaces: (W-2*R)/2");
    return false;
}

}  // namespace carom
