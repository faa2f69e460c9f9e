#include "level/ir/arguments.h"

#include <algorithm>

namespace carom {

std::optional<double> Arguments::number(std::string_view key) const {
    const auto found = values.find(key);
    if (found == values.end()) return std::nullopt;
    return found->second.numbers[0];
}

double Arguments::number_or(std::string_view key, double otherwise) const {
    return number(key).value_or(otherwise);
}

std::uint32_t Arguments::count(std::string_view key) const {
    constexpr double most = 4e9;
    return static_cast<std::uint32_t>(std::min(most, number_or(key, 0.0)));
}

std::optional<Rgb24> Arguments::color(std::string_view key) const {
    const auto found = number(key);
    if (!found) return std::nullopt;
    return static_cast<Rgb24>(*found);
}

Vec2 Arguments::pair_or(std::string_view key, Vec2 otherwise) const {
    const auto found = values.find(key);
    if (found == values.end()) return otherwise;
    return {found->second.numbers[0], found->second.numbers[1]};
}

std::optional<Word> Arguments::word(std::string_view key) const {
    const auto found = values.find(key);
    if (found == values.end()) return std::nullopt;
    return found->second.value;
}

Span Arguments::span_of(std::string_view key) const {
    const auto found = values.find(key);
    return found == values.end() ? node->keyword().span() : found->second.value.span();
}

}  // namespace carom
