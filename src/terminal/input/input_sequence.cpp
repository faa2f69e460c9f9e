#include "terminal/input/input_sequence.h"

#include <charconv>
#include <optional>

namespace carom {
namespace {

// The field of this index in a text split at every `separator`; none when there are fewer.
std::optional<std::string_view> field(std::string_view text, char separator, int index) {
    for (; index > 0; --index) {
        const std::size_t cut = text.find(separator);
        if (cut == std::string_view::npos) return std::nullopt;
        text.remove_prefix(cut + 1);
    }
    return text.substr(0, text.find(separator));
}

}  // namespace

int ControlSequence::number(int index, int part, int otherwise) const {
    const auto parameter = field(parameters, ';', index);
    const auto digits = parameter ? field(*parameter, ':', part) : std::nullopt;
    if (!digits) return otherwise;
    int value = 0;
    const char* const end = digits->data() + digits->size();
    const auto [rest, error] = std::from_chars(digits->data(), end, value);
    const bool is_number = error == std::errc{} && rest == end && value >= 0 && value <= 999'999;
    return is_number ? value : otherwise;
}

ControlSequence parse_control_sequence(std::string_view body) {
    ControlSequence sequence;
    if (body.empty()) return sequence;
    sequence.final = body.back();
    body.remove_suffix(1);
    if (!body.empty() && body.front() >= '<' && body.front() <= '?') {
        sequence.prefix = body.front();
        body.remove_prefix(1);
    }
    const std::size_t cut = body.find_first_not_of("0123456789:;");
    sequence.parameters = body.substr(0, cut);
    if (cut != std::string_view::npos) sequence.intermediates = body.substr(cut);
    return sequence;
}

}  // namespace carom
