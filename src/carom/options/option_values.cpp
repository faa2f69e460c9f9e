#include "carom/options/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <vector>

#include "carom/text/suggest.h"

namespace carom {
namespace {

// The whole text as a number; none when it is not one, or does not fit.
template <class Number>
std::optional<Number> parsed(const std::string& text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return number;
}

std::vector<std::string_view> available_names() {
    std::vector<std::string_view> names;
    for (const SolverKind kind : solvers_available())
        names.emplace_back(name(kind));
    return names;
}

std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        parts.push_back(text.substr(from, comma - from));
        from = comma + 1;
    }
    return parts;
}

constexpr NumberRange rate_range{.least = 1e-3, .most = 1e9};

template <class Choice>
struct Named {
    std::string_view name;
    Choice choice;
};

template <class Choice>
std::optional<Choice> choose(OptionReader& reader, std::string_view option, const std::string& text,
                             std::span<const Named<Choice>> choices) {
    if (text.empty()) return std::nullopt;
    std::vector<std::string_view> names;
    for (const Named<Choice>& known : choices) {
        if (known.name == text) return known.choice;
        names.emplace_back(known.name);
    }
    reader.refuse(fmt::format("{} must be one of {}, but is '{}'{}", option, fmt::join(names, ", "),
                              text, suggestion(text, names)));
    return std::nullopt;
}

}  // namespace

std::optional<std::string> unavailable(SolverKind kind) {
    const std::span<const SolverKind> available = solvers_available();
    if (std::ranges::find(available, kind) != available.end()) return std::nullopt;
    return fmt::format("this version of carom does not have the solver '{}'; it has {}", name(kind),
                       fmt::join(available_names(), ", "));
}

void OptionReader::refuse(std::string sentence) {
    if (!mistake_) mistake_ = std::move(sentence);
}

std::optional<double> OptionReader::number(std::string_view option, const std::string& text,
                                           NumberRange range) {
    if (text.empty()) return std::nullopt;
    const std::optional<double> value = parsed<double>(text);
    if (value && *value >= range.least && *value <= range.most) return value;
    refuse(fmt::format("{} must be a number from {} to {}, but is '{}'", option, range.least,
                       range.most, text));
    return std::nullopt;
}

std::optional<std::uint64_t> OptionReader::whole(std::string_view option, const std::string& text) {
    if (text.empty()) return std::nullopt;
    const auto value = parsed<std::uint64_t>(text);
    if (!value) {
        refuse(fmt::format("{} must be a whole number, 0 or more, but is '{}'", option, text));
    }
    return value;
}

std::optional<double> OptionReader::rate(const std::string& text) {
    return number("--rate", text, rate_range);
}

std::optional<SolverKind> OptionReader::available_solver(const std::string& text) {
    const std::optional<SolverKind> kind = solver_named(text);
    if (!kind) {
        std::vector<std::string_view> names = available_names();
        names.emplace_back("auto");
        refuse(fmt::format("there is no solver '{}'{}", text, suggestion(text, names)));
        return std::nullopt;
    }
    if (std::optional<std::string> why = unavailable(*kind)) refuse(std::move(*why));
    return kind;
}

std::optional<SolverSettings> OptionReader::solver(const std::string& text) {
    if (text.empty() || text == "auto") return std::nullopt;
    const std::optional<SolverKind> kind = available_solver(text);
    if (!kind) return std::nullopt;
    return SolverSettings{.kind = *kind};
}

std::vector<CompareOptions::Side> OptionReader::solvers(const std::string& text,
                                                        std::size_t count) {
    std::vector<CompareOptions::Side> sides;
    if (text.empty()) return sides;
    for (const std::string& part : parts_of(text)) {
        const std::size_t at = std::min(part.find('@'), part.size());
        const std::optional<SolverKind> kind = available_solver(part.substr(0, at));
        if (!kind) return {};
        CompareOptions::Side side{.kind = *kind, .rate = {}};
        if (at < part.size()) {
            side.rate = number("the rate after @", part.substr(at + 1), rate_range);
            if (part.size() == at + 1) refuse("--solvers: a rate must follow the @");
        }
        sides.push_back(side);
    }
    if (count != 0 && sides.size() != count)
        refuse(fmt::format("--solvers must name {}, as in swept,discrete@480, but is '{}'",
                           count == 2 ? "two" : fmt::format("{}", count), text));
    return sides;
}

std::vector<double> OptionReader::rates(const std::string& text) {
    std::vector<double> rates;
    if (text.empty()) return rates;
    for (const std::string& part : parts_of(text)) {
        if (part.empty())
            refuse(fmt::format("--rates must be numbers with commas between, but is '{}'", text));
        if (const auto rate = number("--rates", part, rate_range)) rates.push_back(*rate);
    }
    return rates;
}

std::optional<double> OptionReader::duration(std::string_view option, const std::string& text) {
    if (text.empty()) return std::nullopt;
    struct Unit {
        std::string_view name;
        double seconds;
    };
    // Those that end in another's name come first.
    for (const Unit& unit :
         {Unit{"ns", 1e-9}, Unit{"us", 1e-6}, Unit{"ms", 1e-3}, Unit{"s", 1.0}}) {
        if (!text.ends_with(unit.name)) continue;
        const auto value = parsed<double>(text.substr(0, text.size() - unit.name.size()));
        if (value && *value > 0.0 && std::isfinite(*value)) return *value * unit.seconds;
        break;
    }
    refuse(fmt::format("{} must be a time with its unit, such as 2ms or 500us, but is '{}'", option,
                       text));
    return std::nullopt;
}

std::optional<RendererChoice> OptionReader::renderer(const std::string& text) {
    using enum RendererChoice;
    static constexpr std::array<Named<RendererChoice>, 4> choices{
        {{"auto", automatic}, {"ascii", ascii}, {"half", half_blocks}, {"braille", braille}}};
    return choose<RendererChoice>(*this, "--renderer", text, choices);
}

std::optional<ColorChoice> OptionReader::colors(const std::string& text) {
    using enum ColorChoice;
    static constexpr std::array<Named<ColorChoice>, 5> choices{
        {{"auto", automatic}, {"mono", mono}, {"8", c8}, {"16", c16}, {"256", c256}}};
    return choose<ColorChoice>(*this, "--colors", text, choices);
}

}  // namespace carom
