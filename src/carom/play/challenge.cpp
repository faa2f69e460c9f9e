#include "carom/play/challenge.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "carom/files/high_scores.h"
#include "carom/pool/record_page.h"
#include "game/ai/daily_shot.h"
#include "game/ai/opponents.h"
#include "game/rules/goal.h"

namespace carom {
namespace {

constexpr std::string_view match_for_two = "two";

std::string name_of(const LadderRung& rung) {
    return fmt::format("ladder-{}", rung.opponent);
}

std::string_view person_of(const LadderRung& rung) {
    return ai_player(rung.opponent).name;
}

Challenge daily_challenge(const std::string& path, int date) {
    const auto stars = static_cast<std::size_t>(std::min(load_stars(daily_name(date)), most_stars));
    return {.kind = Challenge::Kind::daily,
            .name = std::string(daily_level),
            .level = path,
            .title = "Shot of the day",
            .line = fmt::format("{}-{:02}-{:02}: a new shot every day", date / 10000,
                                date / 100 % 100, date % 100),
            .goal = "Pocket the ball, and stop in the ring. Three tries.",
            .badge =
                stars == 0 ? "new" : std::string(stars, '*') + std::string(most_stars - stars, '.'),
            .date = date};
}

Challenge rung_challenge(const std::string& path, std::size_t rung, const PoolRecord& record) {
    const LadderRung& match = ladder()[rung];
    const AiPlayer& player = ai_player(match.opponent);
    const std::size_t climbed = rungs_climbed(record);
    const auto& results = record.matches[static_cast<std::size_t>(match.opponent - 1)];
    Challenge challenge{.name = name_of(match),
                        .level = path,
                        .title = fmt::format("{}  {}", rung + 1, player.name),
                        .line = fmt::format("{}; {}", match.game, player.manner),
                        .goal = fmt::format("Win the match: {}.", match.game),
                        .badge = rung < climbed    ? "beaten"
                                 : rung == climbed ? "next"
                                                   : "locked",
                        .amendments = {std::string(match.rules)},
                        .opponent = match.opponent};
    if (results != PoolRecord::Results{})
        challenge.goal += fmt::format(" So far {}.", results_text(results));
    if (rung > climbed)
        challenge.obstacle = fmt::format("{} plays you once you have beaten {}.", player.name,
                                         person_of(ladder()[climbed]));
    return challenge;
}

}  // namespace

std::vector<Challenge> challenges(std::span<const LevelEntry> shipped, const PoolRecord& record,
                                  int date) {
    const auto path_of = [&](std::string_view name) {
        const auto level = std::ranges::find(shipped, name, &LevelEntry::name);
        return level == shipped.end() ? std::string{} : level->path;
    };
    std::vector<Challenge> all;
    if (const std::string path = path_of(daily_level); !path.empty())
        all.push_back(daily_challenge(path, date));
    for (std::size_t rung = 0; rung < ladder().size(); ++rung)
        if (const std::string path = path_of(ladder()[rung].level); !path.empty())
            all.push_back(rung_challenge(path, rung, record));
    const std::string path = path_of("eight-ball");
    if (path.empty()) return all;
    all.push_back({.name = std::string(match_for_two),
                   .level = path,
                   .title = "Two at the keyboard",
                   .line = "8-ball to 3, hot seat: turn about",
                   .goal = "Win three frames before the other does.",
                   .badge = "",
                   .amendments = {"game eightball race=3"}});
    all.push_back({.kind = Challenge::Kind::record,
                   .name = "record",
                   .level = path,
                   .title = "Your record",
                   .line = "Pots, runs, safeties, pace; the ladder",
                   .goal = "Enter shows it. In a game: T.",
                   .badge = ""});
    return all;
}

std::string next_challenge(const PoolRecord& record) {
    const std::size_t climbed = rungs_climbed(record);
    return climbed < ladder().size() ? name_of(ladder()[climbed]) : std::string{};
}

std::string climb_text(const PoolRecord& record) {
    const std::size_t climbed = rungs_climbed(record);
    const std::string_view beaten = person_of(ladder()[climbed - 1]);
    if (climbed == ladder().size())
        return fmt::format("{} is beaten, and nobody is left on the ladder.", beaten);
    const LadderRung& next = ladder()[climbed];
    return fmt::format("{} is beaten. Next on the ladder: {}, {}.", beaten, person_of(next),
                       next.game);
}

std::string daily_name(int date) {
    return fmt::format("{}-{}", daily_level, date);
}

int today() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    localtime_r(&now, &parts);
    return (parts.tm_year + 1900) * 10000 + (parts.tm_mon + 1) * 100 + parts.tm_mday;
}

LevelSource source_of(const PlayOptions& options, const Challenge& challenge) {
    LevelSource source = source_of(options, challenge.level);
    std::vector<std::string> amendments = challenge.amendments;
    if (challenge.kind == Challenge::Kind::daily) {
        const LoadedLevel loaded = load(source);
        const auto shot =
            loaded.result.scene ? daily_shot(*loaded.result.scene, challenge.date) : std::nullopt;
        if (shot) amendments = amendments_of(*shot, challenge.date);
    }
    source.overrides.insert(source.overrides.end(), amendments.begin(), amendments.end());
    return source;
}

}  // namespace carom
