#include "game/rules/goal.h"

#include <fmt/format.h>

#include "game/digest.h"

namespace carom {
namespace {

double spent_on(const LevelGoal& goal, const RuleHost& host, std::uint32_t shots,
                std::uint64_t ticks) {
    return goal.counts_seconds ? static_cast<double>(ticks) / host.rate()
                               : static_cast<double>(shots);
}

std::string amount(const LevelGoal& goal, double spent) {
    if (goal.counts_seconds) return fmt::format("{:.1f} s", spent);
    return fmt::format("{:.0f} {}", spent, spent == 1.0 ? "shot" : "shots");
}

}  // namespace

int stars_within(const LevelGoal& goal, double spent) {
    if (goal.limits.empty()) return most_stars;
    int stars = most_stars;
    for (const double limit : goal.limits) {
        if (spent <= limit) return stars;
        --stars;
    }
    return 0;
}

void note_goal(const RuleBook& book, const RuleState& rules, const RuleHost& host,
               GoalState& goal) {
    if (book.goals.empty() || goal.done) return;
    const LevelGoal& wanted = book.goals.front();
    if (!hold(book, rules, host, wanted.needs)) return;
    const double spent = spent_on(wanted, host, goal.shots, host.now() - goal.begun);
    goal.done = {goal.shots, host.now(), stars_within(wanted, spent)};
}

std::string goal_text(const RuleBook& book, const RuleHost& host, const GoalState& goal) {
    if (book.goals.empty()) return {};
    const LevelGoal& wanted = book.goals.front();
    if (goal.done)
        return fmt::format(
            "Done in {}: {} of {} stars",
            amount(wanted, spent_on(wanted, host, goal.done->shots, goal.done->tick - goal.begun)),
            goal.done->stars, most_stars);
    if (wanted.limits.empty() || wanted.counts_seconds) return wanted.text;
    const double most = wanted.limits.back();
    return fmt::format("{} ({} of {:.0f} {})", wanted.text, goal.shots, most,
                       most == 1.0 ? "shot" : "shots");
}

void add_to(Digest& digest, const GoalState& goal) {
    digest.add(goal.done ? goal.done->tick : ~std::uint64_t{0});
    digest.add(goal.begun);
}

}  // namespace carom
