#include <fmt/format.h>

#include <array>

#include "game/ai/planner.h"
#include "game/ai/pool_value.h"
#include "game/pool/pool_words.h"
#include "game/referees/referee.h"
#include "physics/world/random.h"

/// Describes a shot in words, and turns it into commands.
namespace carom {
namespace {

constexpr std::array<double, 4> factors = {7.0, 3.5, 1.7, 0.5};
constexpr std::array<std::string_view, 4> texts = {"a beginner's hand", "a fair hand",
                                                   "a good hand", "a master's hand"};

std::size_t row_of(int skill) {
    return static_cast<std::size_t>(skill - least_skill);
}

// The best of several estimates is too high: it is announced as if one more of its 14 trials had
// failed. Of 480 pots of a beginner's hand the trials foretold 42 %, and 36 % fell; of the 41 that
// never failed in a trial, 95 % fell.
constexpr double announced_share = 14.0 / 15.0;

// A smaller chance would be announced as 0 %.
constexpr double least_chance = 0.005;

// The executed shot draws noise that no simulation has used.
constexpr std::uint64_t execution_draw = 1u << 20;

}  // namespace

ShotNoise shot_noise(int skill) {
    return ShotNoise{} * factors[row_of(skill)];
}

std::string_view skill_text(int skill) {
    return texts[row_of(skill)];
}

std::string candidate_text(const Scene& scene, const CandidateShot& shot) {
    const double speed = length(shot.strike.velocity);
    std::string text;
    const Referee* const referee = referee_of(scene.game);
    const auto name_of = [&](int number) {
        return referee ? referee->ball_name(number) : fmt::format("the {}", number);
    };
    const std::string ball = shot.ball ? name_of(*shot.ball) : "the rack";
    const auto into = [&] { return pocket_name(scene, shot.pocket); };
    using enum CandidateShot::Kind;
    // A pot that is not expected to fall is chosen for how the balls lie after it.
    const bool is_pot = shot.kind == straight || shot.kind == cut || shot.kind == bank ||
                        (shot.kind == kick && shot.ball);
    const bool is_safety = shot.kind == safety || (is_pot && shot.success < least_chance);
    switch (is_safety ? safety : shot.kind) {
        case break_off:
            text = "break";
            break;
        case straight:
            text = fmt::format("{} straight into the {}", ball, into());
            break;
        case cut:
            text = fmt::format("cut {} into the {}", ball, into());
            break;
        case bank:
            text = fmt::format("bank {} into the {}", ball, into());
            break;
        case kick:
            text = shot.ball ? fmt::format("kick {} into the {}", ball, into()) : "round the table";
            break;
        case safety:
            text = fmt::format("safety on {}", ball);
            break;
        case push_out:
            text = fmt::format("push out by {}", ball);
            break;
    }
    text += fmt::format(", {:.1f} m/s", speed);
    // Who plays safe does not mean to continue.
    if (!is_safety && shot.kind != push_out) {
        text +=
            fmt::format("  {:.0f} % chance to continue", 100.0 * announced_share * shot.success);
        if (shot.leaves) text += ", then " + name_of(*shot.leaves);
    }
    const double follow = shot.strike.follow;
    const double side = shot.strike.side;
    if (follow != 0.0) text += fmt::format("  {}", follow > 0.0 ? "follow" : "draw");
    if (side != 0.0) text += fmt::format("  {} side", side > 0.0 ? "right" : "left");
    return text;
}

PoolChoice choice_of(const Scene& scene, const World& world, const PoolPlay& play,
                     const ShotNoise& error) {
    const std::vector<PoolChoice>& choices = play.rules.choices;
    const auto cloth = cloth_box(scene);
    if (choices.front() != PoolChoice::take_table || !cloth) return choices.front();
    PoolChoice best = choices.front();
    double most = -2.0;
    for (const PoolChoice choice : choices) {
        World after = world;
        PoolPlay chosen = play;
        make_choice(scene, after, chosen, choice);
        const double value =
            value_to(play.rules.player, scene, after, chosen, *cloth, error.bearing);
        if (value <= most) continue;
        most = value;
        best = choice;
    }
    return best;
}

std::vector<Command> commands_of(const Scene& scene, const PoolPlay& play,
                                 const CandidateShot& shot, const ShotNoise& error,
                                 std::uint64_t seed) {
    std::vector<Command> commands;
    if (shot.place) commands.push_back(command::PlaceBall{shot.strike.ball, *shot.place});
    if (!(shot.call == play.call)) commands.push_back(command::CallShot{shot.call});
    commands.push_back(
        with_noise(shot.strike, error, scene.pool.cue->most_power, seed, execution_draw));
    return commands;
}

std::uint64_t decision_seed(const World& world, const PoolPlay& play) {
    return random_bits(world.seed(), RandomStream::player,
                       std::uint64_t{play.frames[0]} << 32 | play.frames[1], play.shots);
}

}  // namespace carom
