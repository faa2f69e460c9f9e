#include "carom/pool/record_page.h"

#include <fmt/format.h>

#include "carom/pool/power_bar.h"

namespace carom {
namespace {

double share(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

const PoolRecord::Results& of(const std::array<PoolRecord::Results, most_opponent>& results,
                              int opponent) {
    return results[static_cast<std::size_t>(opponent - 1)];
}

void add_figures(const PoolRecord& record, const Look& look, std::vector<std::string>& lines) {
    const auto shots = static_cast<double>(record.shots);
    const double made = share(record.made, record.attempts);
    lines.push_back(fmt::format("Pots      {:>3.0f} %  {}  {} of {} tries", 100.0 * made,
                                power_bar(made, look), record.made, record.attempts));
    lines.push_back(fmt::format("Runs      {:>5.1f}  balls a turn; the best {}",
                                share(record.pots, record.turns), record.best_run));
    lines.push_back(
        fmt::format("          {:>5}  frames won from the break", record.breaks_and_runs));
    lines.push_back(fmt::format("Safeties  {:>5}  called, without a foul", record.safeties));
    lines.push_back(fmt::format("Fouls     {:>3.0f} %  {} of {} shots",
                                100.0 * share(record.fouls, record.shots), record.fouls,
                                record.shots));
    lines.push_back(fmt::format("Pace      {:>3.0f} s  a shot", record.seconds / shots));
}

std::string rung_text(const PoolRecord& record, std::size_t rung) {
    const LadderRung& match = ladder()[rung];
    const AiPlayer& player = ai_player(match.opponent);
    const std::size_t climbed = rungs_climbed(record);
    const std::string_view state = rung < climbed ? "beaten" : rung == climbed ? "next" : "";
    return fmt::format("{}  {:<5} {:<13} {:<7} {:>5}  {}", rung + 1, player.name, match.game, state,
                       results_text(of(record.matches, match.opponent)), player.manner);
}

}  // namespace

std::string results_text(const PoolRecord::Results& results) {
    if (results == PoolRecord::Results{}) return "-";
    return fmt::format("{}:{}", results.won, results.lost);
}

std::vector<std::string> record_lines(const PoolRecord& record, const Look& look) {
    std::vector<std::string> lines;
    if (record.shots == 0)
        lines.emplace_back("No shot in a match against carom yet: O at a table chooses one.");
    else
        add_figures(record, look, lines);
    lines.emplace_back();
    lines.emplace_back("Frames against carom");
    for (int skill = 1; !is_of_ladder(skill); ++skill)
        lines.push_back(fmt::format("{}  {:<18} {:>5}", skill, ai_player(skill).manner,
                                    results_text(of(record.frames, skill))));
    lines.emplace_back();
    lines.emplace_back("The ladder: matches won and lost");
    for (std::size_t rung = 0; rung < ladder().size(); ++rung)
        lines.push_back(rung_text(record, rung));
    return lines;
}

}  // namespace carom
