// What the program keeps from one game to the next: settings, and the recordings that are kept.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/play/program.h"

namespace carom {

void Program::keep_setting(std::string_view name, std::string_view value) {
    const std::optional<std::string> fault = write_preference(name, value);
    auto* game = std::get_if<RunningGame>(&page_);
    if (!fault || !game || has_told_lost_settings_) return;
    has_told_lost_settings_ = true;
    game->player.say(fmt::format("such choices are not kept: {}", *fault));
}

std::string_view Program::next_theme() {
    // A theme for the other background would hide the words, so it is no choice here.
    std::vector<std::string_view> names;
    for (const std::string_view name : theme_choice_names())
        if (!theme_choice(name)->is_light) names.push_back(name);
    const auto now = std::ranges::find(
        names, theme_.name, [](std::string_view name) { return theme_choice(name)->name; });
    const auto place = static_cast<std::size_t>(now - names.begin());
    const std::string_view next = names[(place + 1) % names.size()];
    theme_ = *theme_choice(next);
    set_capabilities(capabilities_);  // renews what is drawn
    keep_setting("theme", next);
    return next;
}

void Program::answer_key(RunningGame& game, const InputEvent& event) {
    const auto changed = game.answer_key(event, preferences_.keys);
    if (!changed) return;
    const auto bind = [&](const Key& key, const Action& action) {
        preferences_.keys.bind(key, &action);
        keep_setting(key_text(key), action.name);
    };
    std::string done = fmt::format("{}: {}.", shown_key(changed->key), changed->action->help);
    if (changed->other) {
        bind(changed->before, *changed->other);
        done += fmt::format("  {}: {}.", shown_key(changed->before), changed->other->help);
    }
    bind(changed->key, *changed->action);
    game.player.set_keys(preferences_.keys);
    game.player.say(done);
}

// What was learnt is written when the game ends, not while a ball is in play.
void Program::keep_key_repeat(const RunningGame& game) {
    constexpr double like = 0.15;
    const std::optional<KeyRepeatTimes>& before = preferences_.key_repeat;
    const std::optional<KeyRepeatTimes>& now = game.player.terminal().key_repeat;
    if (!now || (before && std::abs(now->delay - before->delay) <= like * before->delay &&
                 std::abs(now->period - before->period) <= like * before->period))
        return;
    preferences_.key_repeat = now;
    keep_setting("key-repeat", text_of(*now));
}

void Program::watch_or_tell(const std::string& recording) {
    if (auto problems = open_recording(recording)) {
        tell("This recording cannot be played", std::move(*problems));
        std::get<Notice>(page_).entry = recording;
        return;
    }
    std::get<RunningGame>(page_).entry = recording;
}

}  // namespace carom
