#include "level/text/joined.h"

namespace carom {
namespace {

template <typename Word>
std::string join(std::span<const Word> words, std::string_view separator) {
    std::string text;
    for (const Word& word : words) {
        if (&word != words.data()) text += separator;
        text += word;
    }
    return text;
}

}  // namespace

std::string joined(std::span<const std::string> words, std::string_view separator) {
    return join(words, separator);
}

std::string joined(std::span<const std::string_view> words, std::string_view separator) {
    return join(words, separator);
}

}  // namespace carom
