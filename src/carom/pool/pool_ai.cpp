#include "carom/pool/pool_ai.h"

#include "game/ai/opponents.h"

namespace carom {
namespace {

/// Shots tried per frame, which take some milliseconds.
constexpr int tries_a_frame = 6;

const PoolPlay& play_of(const Session& session) {
    return std::get<PoolPlay>(session.game());
}

}  // namespace

bool PoolAi::is_about(const Session& session) const {
    return planner_ && scene_ == &session.scene() &&
           positions_ == session.world().balls().position && rules_ == play_of(session).rules;
}

bool PoolAi::think(const Session& session) {
    const PoolPlay& play = play_of(session);
    if (!is_about(session)) {
        const AiPlayer& player = ai_player(number_);
        scene_ = &session.scene();
        positions_ = session.world().balls().position;
        rules_ = play.rules;
        planner_ = std::make_unique<ShotPlanner>(
            session.scene(), session.world(), play, session.solver(), player.noise,
            decision_seed(session.world(), play), player.style);
    }
    planner_->work(tries_a_frame);
    return planner_->is_done();
}

const std::vector<CandidateShot>& PoolAi::candidates() const {
    static const std::vector<CandidateShot> none;
    return planner_ ? planner_->best() : none;
}

std::vector<Command> PoolAi::decision(const Session& session) const {
    const PoolPlay& play = play_of(session);
    const ShotNoise error = ai_player(number_).noise;
    if (play.rules.phase == PoolPhase::choosing)
        return {command::Decide{choice_of(session.scene(), session.world(), play, error)}};
    return commands_of(session.scene(), play, candidates().front(), error,
                       decision_seed(session.world(), play));
}

}  // namespace carom
