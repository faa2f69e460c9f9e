#include "lab/measure/trial.h"

#include <cmath>

namespace carom {

Trial::Trial(const Scene& scene, const Choice& choice, const std::vector<TimedCommand>& commands)
    : scene_(scene),
      commands_(commands),
      world_(scene.world),
      game_(begin_game(scene)),
      solver_(choice.solver) {
    world_.edit_definition().rate = choice.rate;
    execute_due();
}

void Trial::execute_due() {
    const double scale = world_.rate() / scene_.world.rate();
    for (; next_ < commands_.size(); ++next_) {
        const auto& [tick, command] = commands_[next_];
        if (std::round(static_cast<double>(tick) * scale) > static_cast<double>(world_.tick()))
            return;
        if (std::holds_alternative<command::SetSolver>(command)) continue;
        if (refusal(scene_, world_, game_, command))
            ++refused_;
        else
            execute(scene_, world_, game_, command);
    }
}

TickOutcome Trial::tick(const std::function<bool()>& keep_going) {
    const TickOutcome outcome = solver_.tick(world_, keep_going);
    if (outcome == TickOutcome::cancelled) return outcome;
    update_game(scene_, world_, game_, solver_.contacts());
    execute_due();
    return outcome;
}

}  // namespace carom
