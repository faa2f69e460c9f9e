#include "lab/run/rule_log.h"

#include <fmt/format.h>

#include <utility>
#include <variant>
#include <vector>

namespace carom {
namespace {

std::string message_of(const GameState& game) {
    if (const auto* shots = std::get_if<ShotsState>(&game)) return shots->message;
    if (const auto* pinball = std::get_if<PinballState>(&game)) return pinball->message;
    return {};
}

// The variables first: they lead to what the game counts.
std::vector<std::pair<std::string, std::int64_t>> numbers_of(const Scene& scene,
                                                             const GameState& game) {
    std::vector<std::pair<std::string, std::int64_t>> all;
    for (const auto& [name, values] : variables(scene, game))
        for (std::size_t i = 0; i < values.size(); ++i)
            all.emplace_back(values.size() > 1 ? fmt::format("{}{}", name, i + 1) : name,
                             values[i]);
    for (auto& tally : tallies(game))
        all.push_back(std::move(tally));
    return all;
}

}  // namespace

std::string RuleLog::line(const Scene& scene, const World& world, const GameState& game) {
    std::vector<std::string> changes;
    for (const auto& [name, number] : numbers_of(scene, game)) {
        const auto [known, is_new] = numbers_.try_emplace(name, number);
        if (!is_new && known->second == number) continue;
        known->second = number;
        changes.push_back(fmt::format("{} {}", name, number));
    }
    std::string message = message_of(game);
    if (message != message_ && !message.empty()) changes.push_back(fmt::format("\"{}\"", message));
    message_ = std::move(message);
    if (!std::exchange(has_begun_, true) || changes.empty()) return {};
    return fmt::format("tick {}, {:.3f} s: {}\n", world.tick(),
                       static_cast<double>(world.tick()) / world.rate(), fmt::join(changes, ", "));
}

}  // namespace carom
