#include "physics/tick/solver_settings.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace carom {
namespace {

constexpr std::array<std::string_view, 5> names{"discrete", "substep", "swept", "contact", "event"};

bool uses(SolverKind kind, std::string_view count) {
    if (count == "substeps") return kind == SolverKind::swept || kind == SolverKind::contact;
    return kind == SolverKind::substep;
}

// Removes the first word and the blank after it from the text, and returns the word.
std::string_view take_word(std::string_view& text) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    return word;
}

std::optional<int> count_in(std::string_view text) {
    int count = 0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, count);
    if (fault != std::errc{} || stop != end || count < 1 || count > most_solver_count)
        return std::nullopt;
    return count;
}

}  // namespace

std::string_view name(SolverKind kind) {
    return names[static_cast<std::size_t>(kind)];
}

std::optional<SolverKind> solver_named(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return static_cast<SolverKind>(i);
    return std::nullopt;
}

std::array<SolverCount, 3> all_counts(SolverKind kind) {
    return {{{"updates", &SolverSettings::updates},
             {"steps", &SolverSettings::steps},
             {"substeps", kind == SolverKind::contact ? &SolverSettings::contact_substeps
                                                      : &SolverSettings::substeps}}};
}

std::vector<SolverCount> counts_of(SolverKind kind) {
    std::vector<SolverCount> counts;
    for (const SolverCount& count : all_counts(kind))
        if (uses(kind, count.name)) counts.push_back(count);
    return counts;
}

bool are_in_range(const SolverSettings& settings) {
    return std::ranges::all_of(all_counts(settings.kind), [&](const SolverCount& count) {
        return settings.*count.value >= 1 && settings.*count.value <= most_solver_count;
    });
}

int substeps_of(const SolverSettings& settings) {
    return settings.kind == SolverKind::contact ? settings.contact_substeps : settings.substeps;
}

std::string settings_text(const SolverSettings& settings, SettingsText which) {
    const SolverSettings usual{.kind = settings.kind};
    std::string text(name(settings.kind));
    for (const SolverCount& count : all_counts(settings.kind)) {
        if (which != SettingsText::recorded && !uses(settings.kind, count.name)) continue;
        const int value = settings.*count.value;
        if (which == SettingsText::unusual && value == usual.*count.value) continue;
        text += ' ';
        text += count.name;
        text += '=';
        text += std::to_string(value);
    }
    const bool is_extended = settings.kind == SolverKind::event && settings.extended;
    if (which == SettingsText::unusual && is_extended) text += " extended";
    return text;
}

std::optional<SolverSettings> parse_solver_settings(std::string_view text) {
    const std::optional<SolverKind> kind = solver_named(take_word(text));
    if (!kind) return std::nullopt;
    SolverSettings settings{.kind = *kind};
    const auto all = all_counts(*kind);
    std::vector<SolverCount> absent(all.begin(), all.end());
    while (!text.empty()) {
        const std::string_view word = take_word(text);
        const std::size_t sign = std::min(word.find('='), word.size());
        const auto count = std::ranges::find(absent, word.substr(0, sign), &SolverCount::name);
        if (count == absent.end() || sign == word.size()) return std::nullopt;
        const std::optional<int> value = count_in(word.substr(sign + 1));
        if (!value) return std::nullopt;
        settings.*count->value = *value;
        absent.erase(count);
    }
    return settings;
}

}  // namespace carom
