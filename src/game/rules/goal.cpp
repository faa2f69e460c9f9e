#include "game/rules/goal.h"

#include <fmt/format.h>

#include "game/digest.h"

namespace carom {
namespace {

using Counts = LevelGoal::Counts;

std::string shots_text(double shots) {
    return fmt::format("{:.0f} {}", shots, shots == 1.0 ? "shot" : "shots");
}

std::string amount(const LevelGoal& goal, double spent) {
    if (goal.counts == Counts::seconds) return fmt::format("in {:.1f} s", spent);
    if (goal.counts == Counts::value || goal.counts == Counts::cost)
        return fmt::format("with {:.0f}", spent);
    return "in " + shots_text(spent);
}

// What the next stars take, where there are stars to lose: "1 for 3 stars".
std::string next_stars(const LevelGoal& goal, double shots) {
    if (goal.limits.size() < 2) return {};
    int stars = most_stars;
    for (const double limit : goal.limits) {
        if (limit > shots)
            return fmt::format("; {:.0f} for {} {}", limit, stars, stars == 1 ? "star" : "stars");
        --stars;
    }
    return {};
}

}  // namespace

int stars_within(const LevelGoal& goal, double spent) {
    if (goal.limits.empty()) return most_stars;
    int stars = most_stars;
    for (const double limit : goal.limits) {
        if (goal.counts == Counts::value ? spent >= limit : spent <= limit) return stars;
        --stars;
    }
    return 0;
}

void note_goal(const RuleBook& book, const RuleState& rules, const RuleHost& host,
               GoalState& goal) {
    if (book.goals.empty() || goal.done) return;
    const LevelGoal& wanted = book.goals.front();
    if (!hold(book, rules, host, wanted.needs)) return;
    const double spent = wanted.counts == Counts::seconds
                             ? static_cast<double>(host.now() - goal.begun) / host.rate()
                         : wanted.counts == Counts::value || wanted.counts == Counts::cost
                             ? static_cast<double>(value_of(book, rules, host, wanted.value))
                             : static_cast<double>(goal.shots);
    goal.done = {goal.shots, host.now(), stars_within(wanted, spent), spent};
}

std::string goal_text(const RuleBook& book, const GoalState& goal) {
    if (book.goals.empty()) return {};
    const LevelGoal& wanted = book.goals.front();
    if (goal.done && goal.done->stars == 0)
        return fmt::format("No star {}: it takes {:.0f}", amount(wanted, goal.done->spent),
                           wanted.limits.back());
    if (goal.done)
        return fmt::format("Done {}: {} of {} stars", amount(wanted, goal.done->spent),
                           goal.done->stars, most_stars);
    if (wanted.limits.empty() || wanted.counts != Counts::shots) return wanted.text;
    return fmt::format("{} ({} of {}{})", wanted.text, goal.shots, shots_text(wanted.limits.back()),
                       next_stars(wanted, goal.shots));
}

void add_to(Digest& digest, const GoalState& goal) {
    digest.add(goal.done ? goal.done->tick : ~std::uint64_t{0});
    digest.add(goal.begun);
}

}  // namespace carom
