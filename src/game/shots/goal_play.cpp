#include "game/shots/goal_play.h"

#include <algorithm>

#include "game/digest.h"
#include "game/pool/pool.h"
#include "geometry/closest.h"

namespace carom {
namespace {

/// What the goal of a level without a game may ask.
class GoalAnswers final : public RuleHost {
  public:
    GoalAnswers(const Scene& scene, const World& world, const GoalPlay& play)
        : scene_(scene), world_(world), play_(play) {}

    std::uint64_t now() const override { return world_.tick(); }
    double rate() const override { return world_.rate(); }
    std::int64_t quantity(RuleQuantity what) const override {
        if (what == RuleQuantity::shots) return std::int64_t{play_.goal.shots};
        if (what == RuleQuantity::rest) return is_at_rest(world_) ? 1 : 0;
        return 0;
    }
    std::int64_t count(const RuleBalls& balls, const RulePlace* place) const override {
        std::int64_t there = 0;
        for (std::size_t ball = 0; ball < world_.balls().size(); ++ball)
            if (is_meant(balls, ball) && (!place || lies_in(*place, ball))) ++there;
        return there;
    }
    std::pair<std::int64_t, std::int64_t> lights(std::uint32_t) const override { return {0, 0}; }
    bool moves(std::uint32_t mover) const override { return world_.movers()[mover].runs; }
    void act(const RuleAction&, std::int64_t, int) override {}

  private:
    bool is_meant(const RuleBalls& balls, std::size_t ball) const {
        const BallId id = world_.balls().id[ball];
        if (balls.who == RuleBalls::Who::any) return true;
        if (balls.who == RuleBalls::Who::cue) return scene_.pool.cue && scene_.pool.cue->ball == id;
        if (balls.who != RuleBalls::Who::listed) return false;
        const auto kinds = static_cast<std::int32_t>(scene_.kind_names.size());
        if (balls.kind >= 0) return world_.balls().kind[ball] % kinds == balls.kind;
        return std::ranges::binary_search(balls.balls, id);
    }
    bool lies_in(const RulePlace& place, std::size_t ball) const {
        return std::ranges::any_of(place.zones, [&](std::uint32_t zone) {
            return is_inside(world_.zones()[zone].shape, world_.balls().position[ball]);
        });
    }

    const Scene& scene_;
    const World& world_;
    const GoalPlay& play_;
};

// Whether the command moves something by hand.
bool is_by_hand(const Command& command) {
    return !std::holds_alternative<command::Strike>(command) &&
           !std::holds_alternative<command::SetSolver>(command);
}

}  // namespace

std::optional<GoalPlay> begin_goal(const Scene& scene) {
    if (scene.rules.goals.empty() || scene.rules.is_shots || scene.table.is_game)
        return std::nullopt;
    return GoalPlay{begin_rules(scene.rules), {}, false};
}

void update_goal(const Scene& scene, const World& world, GoalPlay& play) {
    const LevelGoal& goal = scene.rules.goals.front();
    if (goal.counts != LevelGoal::Counts::seconds && (play.is_void || play.goal.shots == 0)) return;
    note_goal(scene.rules, play.rules, GoalAnswers(scene, world, play), play.goal);
}

void execute(const Scene& scene, World& world, GoalPlay& play, const Command& command) {
    execute(world, command);
    if (std::holds_alternative<command::Strike>(command)) ++play.goal.shots;
    const bool counts_shots = scene.rules.goals.front().counts != LevelGoal::Counts::seconds;
    if (counts_shots && !play.goal.done && is_by_hand(command)) play.is_void = true;
}

std::string task_text(const Scene& scene, const GoalPlay& play) {
    if (play.is_void && play.goal.shots > 0) return "Moved by hand: restart for the goal.";
    return goal_text(scene.rules, play.goal);
}

std::uint64_t digest_of(std::uint64_t start, const GoalPlay& play) {
    Digest digest(start);
    digest.add(std::uint64_t{play.goal.shots} * 2 + (play.is_void ? 1 : 0));
    add_to(digest, play.goal);
    return digest.value();
}

}  // namespace carom
