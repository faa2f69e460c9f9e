// What the menu lists.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "carom/files/high_scores.h"
#include "carom/files/kept_recordings.h"
#include "carom/files/menu_list.h"
#include "carom/files/pool_record.h"
#include "carom/play/menu.h"
#include "game/ai/opponents.h"
#include "game/rules/goal.h"
#include "game/rules/rules.h"

namespace carom {
namespace {

std::string time_text(double seconds) {
    const auto whole = static_cast<long>(seconds);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

/// The best score of a table, or the stars of a goal; empty: there is none.
std::string best_score(const std::string& path) {
    const int stars = std::min(load_stars(path), most_stars);
    if (stars > 0)
        return std::string(static_cast<std::size_t>(stars), '*') +
               std::string(static_cast<std::size_t>(most_stars - stars), '.');
    const HighScoresText kept = load_high_scores(high_scores_name(path), 1);
    return kept.scores.lines.empty() ? "" : grouped(kept.scores.lines.front().score);
}

// The newest game of each level, or of each match of the ladder. An older one takes its place when
// that has ended.
void add_unfinished(std::vector<MenuItem>& items, std::span<const InterruptedGame> interrupted,
                    std::span<const LevelEntry> levels) {
    for (const InterruptedGame& game : interrupted) {
        const std::string name = std::filesystem::path(game.replay.level).stem().string();
        const auto level = std::ranges::find(levels, name, &LevelEntry::name);
        const double seconds = static_cast<double>(game.replay.position) / game.replay.rate;
        std::string title = level == levels.end() || level->title.empty() ? name : level->title;
        // The level's title would leave no room: "8-ball to 2" says as much.
        const auto rung = std::ranges::find(ladder(), game.replay.opponent, &LadderRung::opponent);
        if (rung != ladder().end())
            title = fmt::format("{}: {}", ai_player(rung->opponent).name, rung->game);
        const bool is_older = std::ranges::any_of(items, [&](const MenuItem& item) {
            return item.path == game.replay.level && item.title == title;
        });
        if (is_older) continue;
        items.push_back({name, std::move(title), "Unfinished", game.replay.level, "",
                         time_text(seconds), game});
    }
}

void add_challenges(std::vector<MenuItem>& items, std::span<const LevelEntry> levels) {
    for (Challenge& challenge : challenges(levels, load_pool_record().record, today()))
        items.push_back({challenge.name, challenge.title, std::string(challenge_group),
                         challenge.level, challenge.line, challenge.badge, std::nullopt,
                         std::move(challenge)});
}

// The first group, then the challenges, then the others.
void add_shipped(std::vector<MenuItem>& items, const std::string& folder,
                 std::span<const LevelEntry> levels) {
    const auto add = [&](const LevelEntry& level, std::string group, std::string line) {
        items.push_back({level.name, level.title.empty() ? level.name : level.title,
                         std::move(group), level.path, std::move(line), best_score(level.path)});
    };
    const std::vector<ListedLevel> list = menu_list_in(folder);
    bool has_challenges = false;
    const auto add_once = [&] {
        if (!std::exchange(has_challenges, true)) add_challenges(items, levels);
    };
    for (const ListedLevel& listed : list) {
        if (listed.group != list.front().group) add_once();
        const auto level = std::ranges::find(levels, listed.name, &LevelEntry::name);
        if (level != levels.end()) add(*level, listed.group, listed.line);
    }
    add_once();
    for (const LevelEntry& level : levels)
        if (level.name != daily_level && !std::ranges::count(list, level.name, &ListedLevel::name))
            add(level, "More", "");
}

void add_recordings(std::vector<MenuItem>& items) {
    for (const KeptRecording& recording : kept_recordings()) {
        MenuItem item{recording.name, recording.name, std::string(own_group), recording.path,
                      "A recording"};
        if (!recording.level.empty()) item.line += " of " + recording.level;
        if (recording.seconds) item.badge = "watch " + time_text(*recording.seconds);
        item.is_recording = true;
        items.push_back(std::move(item));
    }
}

}  // namespace

std::vector<MenuItem> menu_items(std::span<const InterruptedGame> interrupted) {
    namespace fs = std::filesystem;
    std::vector<MenuItem> items;
    const auto folder = shipped_levels_folder();
    const std::vector<LevelEntry> shipped = folder ? levels_in(*folder) : std::vector<LevelEntry>{};
    add_unfinished(items, interrupted, shipped);
    if (folder) add_shipped(items, *folder, shipped);
    std::error_code error;
    if (!folder || !fs::equivalent(".", *folder, error))
        for (const LevelEntry& level : levels_in("."))
            items.push_back({level.name, level.title.empty() ? level.name : level.title,
                             std::string(own_group), level.path, level.name + ".level",
                             best_score(level.path)});
    add_recordings(items);
    return items;
}

}  // namespace carom
