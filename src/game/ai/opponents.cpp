#include "game/ai/opponents.h"

#include <array>

#include "game/ai/planner.h"

namespace carom {
namespace {

constexpr PlayStyle even{};
constexpr PlayStyle eager{.safety = -0.4, .risk = 0.2};
constexpr PlayStyle safe{.safety = 0.25, .risk = -0.2, .pause = 1.8};
constexpr PlayStyle bold{.safety = -0.5, .risk = 0.35, .pace = 0.02};
constexpr PlayStyle fast{.safety = -0.15, .pace = 0.06, .pause = 0.2};
constexpr PlayStyle runner{.safety = -0.05, .position = 0.3};

AiPlayer of_skill(int skill) {
    return {"carom", shot_noise(skill), even, skill_text(skill)};
}

AiPlayer someone(std::string_view name, double errors, const PlayStyle& style,
                 std::string_view manner) {
    return {name, ShotNoise{} * errors, style, manner};
}

const std::array<AiPlayer, most_opponent>& players() {
    static const std::array<AiPlayer, most_opponent> all{
        of_skill(1),
        of_skill(2),
        of_skill(3),
        of_skill(4),
        someone("Nell", 9.0, eager, "learns, and goes for the pot"),
        someone("Bo", 6.5, bold, "bold: goes for every pot"),
        someone("Ida", 4.5, safe, "safe: leaves you nothing"),
        someone("Rex", 3.3, fast, "fast: hits hard, never waits"),
        someone("Mara", 2.2, bold, "bold: banks and kicks, and makes them"),
        someone("Otto", 1.4, safe, "safe: waits for your mistake"),
        someone("Viv", 0.5, runner, "breaks and runs"),
    };
    return all;
}

constexpr std::array rungs{
    LadderRung{"eight-ball", "8-ball to 2", "game eightball race=2", 5},
    LadderRung{"nine-ball", "9-ball to 2", "game nineball race=2", 6},
    LadderRung{"eight-ball", "8-ball to 3", "game eightball race=3", 7},
    LadderRung{"nine-ball", "9-ball to 4", "game nineball race=4", 8},
    LadderRung{"ten-ball", "10-ball to 3", "game tenball race=3", 9},
    LadderRung{"eight-ball", "8-ball to 4", "game eightball race=4", 10},
    LadderRung{"nine-ball", "9-ball to 5", "game nineball race=5", 11},
};

}  // namespace

const AiPlayer& ai_player(int number) {
    return players()[static_cast<std::size_t>(number - 1)];
}

std::span<const LadderRung> ladder() {
    return rungs;
}

bool is_of_ladder(int number) {
    return number > most_skill;
}

}  // namespace carom
