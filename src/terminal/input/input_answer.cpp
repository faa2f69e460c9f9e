#include "terminal/input/input_answer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

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
    // VTE before 0.76 tells its version only here, as in "> 65 ; 7006 ; 1".
    constexpr int vte = 65;
    if (sequence.prefix == '>' && sequence.final == 'c' && sequence.number(0) == vte) {
        answer.kind = version;
        answer.text = "vte(" + std::to_string(sequence.number(1)) + ")";
        return answer;
    }
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

std::optional<Answer> answer_in_device_control(std::string_view body) {
    Answer answer;
    if (body.starts_with(">|")) {
        answer.kind = Answer::Kind::version;
        answer.text = body.substr(2);
        return answer;
    }
    // XTGETTCAP: "1+r", and names in hexadecimal digits that the terminal has.
    if (body.starts_with("1+r524742") || body.starts_with("1+r5463")) {
        answer.kind = Answer::Kind::colors;
        answer.colors = direct_colors;
        return answer;
    }
    // DECRQSS: "1$r" and the style. The question sets the foreground 250, 130, 5; a terminal
    // without 24-bit colour answers with the nearest that it has, or without any.
    constexpr std::string_view start = "1$r";
    if (!body.starts_with(start) || !body.ends_with('m')) return std::nullopt;
    answer.kind = Answer::Kind::colors;
    std::string fields(body.substr(start.size()));
    std::ranges::replace(fields, ':', ';');
    const auto has = [&](std::string_view text) { return fields.find(text) != std::string::npos; };
    if (has("38;2;250;130;5m") || has("38;2;;250;130;5m") || has("38;2;0;250;130;5m") ||
        has("38;2;1;250;130;5m")) {
        answer.colors = direct_colors;
    } else if (has("38;5;")) {
        answer.colors = 256;
    }
    return answer;
}

std::string capability_questions(bool passes_strings_on) {
    std::string questions =
        "\033]11;?\033\\"
        "\033[?2026$p"
        "\033[?1016$p"
        "\033[16t"
        "\033[?u"
        "\033[>c"
        "\033[>q";
    if (!passes_strings_on) {
        questions +=
            "\033[38;2;250;130;5m\033P$qm\033\\\033[m"
            "\033P+q524742\033\\"
            "\033P+q5463\033\\";
    }
    return questions + "\033[c";
}

}  // namespace carom
