#include "terminal/input/input_answer.h"

#include <array>
#include <charconv>

namespace carom {
namespace {

// One colour of X11's "rgb:RRRR/GGGG/BBBB", 1 to 4 hexadecimal digits, as 0..255.
std::optional<int> channel(std::string_view digits) {
    if (digits.empty() || digits.size() > 4) return std::nullopt;
    int value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [rest, error] = std::from_chars(digits.data(), end, value, 16);
    if (error != std::errc{} || rest != end || value < 0) return std::nullopt;
    const int largest = (1 << (4 * static_cast<int>(digits.size()))) - 1;
    return value * 255 / largest;
}

}  // namespace

std::optional<Answer> answer_in(const ControlSequence& sequence) {
    using enum Answer::Kind;
    Answer answer;
    if (sequence.prefix == '?' && sequence.final == 'c') return answer;
    if (sequence.prefix == '?' && sequence.final == 'u') {
        answer.kind = key_flags;
        return answer;
    }
    if (sequence.prefix == '?' && sequence.final == 'y' && sequence.intermediates == "$") {
        answer.kind = mode;
        answer.number = sequence.number(0);
        // 0: not known, 1: set, 2: reset, 3: always set, 4: always reset
        answer.is_offered = sequence.number(1) == 1 || sequence.number(1) == 2;
        return answer;
    }
    if (sequence.prefix == 0 && sequence.final == 'n') {
        answer.kind = status;
        return answer;
    }
    if (sequence.prefix == 0 && sequence.final == 't' && sequence.number(0) == 6) {
        answer.kind = cell_size;
        answer.pixels_high = sequence.number(1);
        answer.pixels_wide = sequence.number(2);
        return answer;
    }
    return std::nullopt;
}

std::optional<Answer> answer_in_command(std::string_view body) {
    constexpr std::string_view start = "11;rgb";
    if (body.substr(0, start.size()) != start) return std::nullopt;
    const std::size_t colon = body.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    body.remove_prefix(colon + 1);
    std::array<int, 3> channels{};
    for (int& value : channels) {
        const std::size_t cut = body.find('/');
        const auto found = channel(body.substr(0, cut));
        if (!found) return std::nullopt;
        value = *found;
        body.remove_prefix(cut == std::string_view::npos ? body.size() : cut + 1);
    }
    Answer answer;
    answer.kind = Answer::Kind::background;
    answer.color = {channels[0], channels[1], channels[2]};
    return answer;
}

std::string_view capability_questions() {
    return "\033]11;?\033\\"
           "\033[?2026$p"
           "\033[?1016$p"
           "\033[16t"
           "\033[?u"
           "\033[c";
}

}  // namespace carom
