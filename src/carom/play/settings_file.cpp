#include "carom/play/settings_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace carom {

void SettingsFile::keep(std::string_view name, std::string_view value) {
    if (auto fault = write_preference(name, value)) fault_ = std::move(fault);
}

std::optional<std::string> SettingsFile::take_fault() {
    if (!fault_ || has_told_) return std::nullopt;
    has_told_ = true;
    return fmt::format("such choices are not kept: {}", *fault_);
}

std::string_view theme_after(const ThemeChoice& now, bool is_terminal_light) {
    const std::span<const std::string_view> names = theme_choice_names();
    const auto looks_like = [&](const ThemeChoice& choice) {
        return std::pair(choice.name, choice.is_light.value_or(is_terminal_light));
    };
    const auto at =
        std::ranges::find(names, now, [](std::string_view name) { return *theme_choice(name); });
    auto place = static_cast<std::size_t>(at - names.begin());
    const ThemeChoice automatic;
    do
        place = (place + 1) % names.size();
    while (place > 0 && looks_like(*theme_choice(names[place])) == looks_like(automatic));
    return names[place];
}

std::string change_key(const KeyPrompt::Changed& changed, KeyMap& keys, SettingsFile& file) {
    const auto bind = [&](const Key& key, const Action& action) {
        keys.bind(key, &action);
        file.keep(key_text(key), action.name);
    };
    std::string done = fmt::format("{}: {}.", shown_key(changed.key), changed.action->help);
    if (changed.other) {
        bind(changed.before, *changed.other);
        done += fmt::format("  {}: {}.", shown_key(changed.before), changed.other->help);
    }
    bind(changed.key, *changed.action);
    return done;
}

void keep_key_repeat(const std::optional<KeyRepeatTimes>& learnt, Preferences& preferences,
                     SettingsFile& file) {
    constexpr double like = 0.15;
    const std::optional<KeyRepeatTimes>& before = preferences.key_repeat;
    if (!learnt || (before && std::abs(learnt->delay - before->delay) <= like * before->delay &&
                    std::abs(learnt->period - before->period) <= like * before->period))
        return;
    preferences.key_repeat = learnt;
    file.keep("key-repeat", text_of(*learnt));
}

}  // namespace carom
