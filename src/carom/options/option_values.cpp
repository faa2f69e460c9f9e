#include "carom/options/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "carom/text/suggest.h"
#include "level/text/joined.h"
#include "terminal/canvas/renderer.h"

namespace carom {
namespace {

// Parses the whole text as a number; none if it is not one, or is out of range.
template <class Number>
std::optional<Number> parsed(std::string_view text) {
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

template <class Choice>
struct Named {
    std::string_view name;
    Choice choice;
};

template <class Choice>
Choice one_of(std::span<const Named<Choice>> choices, std::string_view option,
              const std::string& text) {
    std::vector<std::string_view> names;
    for (const Named<Choice>& known : choices) {
        if (known.name == text) return known.choice;
        names.emplace_back(known.name);
    }
    throw BadValue(fmt::format("{} must be one of {}, but is '{}'{}", option, joined(names, ", "),
                               text, suggestion(text, names)));
}

SolverKind available_solver(const std::string& text) {
    const std::optional<SolverKind> kind = solver_named(text);
    if (!kind) {
        std::vector<std::string_view> names = available_names();
        names.emplace_back("auto");
        const std::string meant = suggestion(text, names);
        throw BadValue(fmt::format(
            "there is no solver '{}'{}", text,
            meant.empty() ? fmt::format("; there are {}", joined(names, ", ")) : meant));
    }
    if (const std::optional<std::string> why = unavailable(*kind)) throw BadValue(*why);
    return *kind;
}

}  // namespace

double number_in(NumberRange range, std::string_view option, const std::string& text) {
    const std::optional<double> value = parsed<double>(text);
    if (value && *value >= range.least && *value <= range.most) return *value;
    throw BadValue(fmt::format("{} must be a number from {} to {}, but is '{}'", option,
                               range.least, range.most, text));
}

std::uint64_t whole_number_in(std::uint64_t least, std::uint64_t most, std::string_view option,
                              const std::string& text) {
    const auto value = parsed<std::uint64_t>(text);
    if (value && *value >= least && *value <= most) return *value;
    throw BadValue(fmt::format("{} must be a whole number from {} to {}, but is '{}'", option,
                               least, most, text));
}

std::uint64_t whole_number(std::string_view option, const std::string& text) {
    return whole_number_in(0, std::numeric_limits<std::uint64_t>::max(), option, text);
}

std::vector<double> numbers_in(NumberRange range, std::string_view option,
                               const std::string& text) {
    std::vector<double> numbers;
    for (const std::string& part : parts_of(text)) {
        if (part.empty())
            throw BadValue(
                fmt::format("{} must be numbers with commas between, but is '{}'", option, text));
        numbers.push_back(number_in(range, option, part));
    }
    return numbers;
}

double duration(std::string_view option, const std::string& text) {
    struct Unit {
        std::string_view name;
        double seconds;
    };
    // A unit that ends in another unit's name comes before it.
    for (const Unit& unit :
         {Unit{"ns", 1e-9}, Unit{"us", 1e-6}, Unit{"ms", 1e-3}, Unit{"s", 1.0}}) {
        if (!text.ends_with(unit.name)) continue;
        const auto value =
            parsed<double>(std::string_view(text).substr(0, text.size() - unit.name.size()));
        if (value && *value > 0.0 && std::isfinite(*value)) return *value * unit.seconds;
        break;
    }
    throw BadValue(fmt::format("{} must be a time with its unit, such as 2ms or 500us, but is '{}'",
                               option, text));
}

std::optional<SolverSettings> solver_choice(std::string_view, const std::string& text) {
    if (text == "auto") return std::nullopt;
    return SolverSettings{.kind = available_solver(text)};
}

std::vector<CompareOptions::Side> solver_list(std::string_view option, const std::string& text) {
    std::vector<CompareOptions::Side> sides;
    for (const std::string& part : parts_of(text)) {
        const std::size_t at = std::min(part.find('@'), part.size());
        CompareOptions::Side side{.kind = available_solver(part.substr(0, at)), .rate = {}};
        if (at + 1 == part.size())
            throw BadValue(fmt::format("{}: a rate must follow the @", option));
        if (at < part.size())
            side.rate = number_in(rate_range, "the rate after @", part.substr(at + 1));
        sides.push_back(side);
    }
    return sides;
}

RendererChoice renderer_option(std::string_view option, const std::string& text) {
    std::vector<Named<RendererChoice>> choices;
    for (const std::string_view known : renderer_choice_names())
        choices.push_back({known, *renderer_choice(known)});
    return one_of<RendererChoice>(choices, option, text);
}

PictureFormat picture_format(std::string_view option, const std::string& text) {
    static constexpr std::array<Named<PictureFormat>, 3> choices{{{"svg", PictureFormat::svg},
                                                                  {"ansi", PictureFormat::ansi},
                                                                  {"text", PictureFormat::text}}};
    return one_of<PictureFormat>(choices, option, text);
}

CheckFormat check_format(std::string_view option, const std::string& text) {
    static constexpr std::array<Named<CheckFormat>, 2> choices{
        {{"text", CheckFormat::text}, {"json", CheckFormat::json}}};
    return one_of<CheckFormat>(choices, option, text);
}

WindowSize window_size(std::string_view option, const std::string& text) {
    constexpr int most = 1000;
    const std::size_t x = text.find('x');
    if (x != text.npos) {
        const auto columns = parsed<int>(std::string_view(text).substr(0, x));
        const auto rows = parsed<int>(std::string_view(text).substr(x + 1));
        if (columns && rows && *columns >= 1 && *columns <= most && *rows >= 1 && *rows <= most)
            return {*columns, *rows};
    }
    throw BadValue(fmt::format("{} must be columns and rows of 1 to {}, as in 120x40, but is '{}'",
                               option, most, text));
}

ColorChoice color_choice(std::string_view option, const std::string& text) {
    using enum ColorChoice;
    static constexpr std::array<Named<ColorChoice>, 6> choices{{{"auto", automatic},
                                                                {"mono", mono},
                                                                {"8", c8},
                                                                {"16", c16},
                                                                {"256", c256},
                                                                {"truecolor", direct}}};
    return one_of<ColorChoice>(choices, option, text);
}

ThemeChoice theme_option(std::string_view option, const std::string& text) {
    std::vector<Named<ThemeChoice>> choices;
    for (const std::string_view known : theme_choice_names())
        choices.push_back({known, *theme_choice(known)});
    return one_of<ThemeChoice>(choices, option, text);
}

std::optional<std::string> unavailable(SolverKind kind) {
    const std::span<const SolverKind> available = solvers_available();
    if (std::ranges::find(available, kind) != available.end()) return std::nullopt;
    return fmt::format("this version of carom does not have the solver '{}'; it has {}", name(kind),
                       joined(available_names(), ", "));
}

std::vector<SolverKind> solvers_of_measure(std::string_view option, const std::string& text) {
    std::vector<SolverKind> kinds;
    for (const CompareOptions::Side& side : solver_list(option, text)) {
        if (side.rate)
            throw BadValue("--solvers of measure takes no rates: they come from --rates");
        kinds.push_back(side.kind);
    }
    return kinds;
}

std::vector<CompareOptions::Side> two_solvers(std::string_view option, const std::string& text) {
    std::vector<CompareOptions::Side> sides = solver_list(option, text);
    if (sides.size() != 2)
        throw BadValue(
            fmt::format("{} must name two, as in swept,discrete@480, but is '{}'", option, text));
    return sides;
}

std::string guest_name(std::string_view option, const std::string& text) {
    if (is_guest_name(text)) return text;
    throw BadValue(
        fmt::format("{} takes a name of up to 32 small letters, digits, '-' and '_', but is '{}'",
                    option, text));
}

double idle_time(std::string_view option, const std::string& text) {
    const double seconds = duration(option, text);
    if (seconds < 0.1 || seconds > 1e6)
        throw BadValue(fmt::format("{} must be from 0.1s to 1000000s, but is '{}'", option, text));
    return seconds;
}

std::size_t bytes_of_mebibytes(std::string_view option, const std::string& text) {
    return static_cast<std::size_t>(number_in({0, 65536}, option, text) * 1048576.0);
}

std::string solver_names() {
    std::string names;
    for (const SolverKind kind : solvers_available())
        names += fmt::format("{}{}", names.empty() ? "" : ", ", name(kind));
    return names;
}

std::string renderer_names() {
    std::string names;
    for (const Renderer& renderer : renderers())
        names += fmt::format("{}{}", names.empty() ? "" : ", ", renderer.name);
    return names;
}

}  // namespace carom
