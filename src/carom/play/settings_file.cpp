#include "carom/play/settings_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace carom {

void SettingsFile::keep(std::string_view name, std::string_view value) {
    if (auto fault = write_preference(name, value)) fault_ = std::move(fault);
}

std::optional<std::string> SettingsFile::take_fault() {
    if (!fault_ || has_told_) return std::nullopt;
    has_told_ = true;
    return fmt::format("such choices are not kept: {}", *fault_);
}

std::string_view theme_after(const ThemeChoice& now) {
    // A theme for the other background would hide the words, so it is no choice here.
    std::vector<std::string_view> names;
    for (const std::string_view name : theme_choice_names())
        if (!theme_choice(name)->is_light) names.push_back(name);
    const auto at = std::ranges::find(
        names, now.name, [](std::string_view name) { return theme_choice(name)->name; });
    const auto place = static_cast<std::size_t>(at - names.begin());
    return names[(place + 1) % names.size()];
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
