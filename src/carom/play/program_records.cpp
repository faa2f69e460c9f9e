// What the program keeps from one game to the next: settings, and the recordings that are kept.

#include <fmt/format.h>

#include <cmath>

#include "carom/play/program.h"

namespace carom {

void Program::keep_setting(std::string_view name, std::string_view value) {
    const std::optional<std::string> fault = write_preference(name, value);
    auto* game = std::get_if<RunningGame>(&page_);
    if (!fault || !game || has_told_lost_settings_) return;
    has_told_lost_settings_ = true;
    game->player.say(fmt::format("such choices are not kept: {}", *fault));
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
