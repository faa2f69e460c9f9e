#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/ai/hand_error.h"
#include "game/ai/pool_shots.h"
#include "game/pool/pool.h"
#include "game/session/forecast.h"

/// carom's own play at pool: proposes shots, tries them on the engine with the errors of a hand,
/// and looks at what each leaves. The work is bounded by a number of shots, never by a clock, so
/// the same position gives the same shot on every machine.
namespace carom {

/// How well the opponent holds the cue, and so how strong it is.
inline constexpr int least_steadiness = 1;
inline constexpr int most_steadiness = 4;
HandError error_of(int steadiness);
std::string_view steadiness_text(int steadiness);

struct PoolThought {
    enum class Kind : std::uint8_t { break_off, straight, cut, bank, kick, safety, push_out };
    Kind kind = Kind::cut;
    std::optional<Vec2> place;  ///< where the cue ball is put first
    PoolCall call;
    command::Strike strike;     ///< as it is meant
    std::optional<int> ball;    ///< the number of the ball that is aimed at
    int pocket = 0;             ///< where it shall go, if it shall
    double value = 0.0;         ///< -1..1, mean over the tries
    double success = 0.0;       ///< share of the tries after which the player goes on, or has won
    std::optional<int> leaves;  ///< the ball that is easiest then, when all goes as it is meant
};

/// "cut the 4 into the top left, 2.0 m/s, draw 0.30: goes on in 83 of 100; then the 6".
std::string thought_text(const Scene& scene, const PoolThought& thought);

class PoolThinker {
  public:
    /// About so many shots are tried for one decision.
    static constexpr int most_tries = 320;

    /// Pre: the balls lie still, the phase is breaking or playing; the scene outlives it.
    PoolThinker(const Scene& scene, const World& world, const PoolPlay& play,
                const SolverSettings& solver, const HandError& error, std::uint64_t seed);

    /// Tries up to so many shots more. How the work is cut does not change what comes of it.
    void work(int tries);
    bool is_done() const { return stage_ == Stage::done; }
    /// The best first, at most three; none before it is done. Never empty then.
    const std::vector<PoolThought>& best() const { return best_; }

  private:
    enum class Stage : std::uint8_t { trying, testing, done };
    struct Candidate {
        PoolThought thought;
        double chance = 1.0;  ///< by geometry
        double first_value = 0.0;
        double sum = 0.0;
        int went_on = 0;
    };

    void propose();
    void propose_break();
    void propose_pots(std::optional<Vec2> place, std::span<const PotLine> lines);
    void propose_hits(Vec2 from);
    void propose_placed();
    void add_pot(const PotLine& line, std::optional<Vec2> place, Vec2 direction, double speed,
                 double side, double follow);
    Vec2 corrected(const PotLine& line, std::optional<Vec2> place, double speed);
    bool may_place(Vec2 place) const;
    World world_with(const std::optional<Vec2>& place) const;
    Forecast try_out(const Candidate& candidate, const command::Strike& strike);
    double value_of(const Forecast& ahead) const;
    bool goes_on(const Forecast& ahead) const;
    void try_next();
    void begin_testing();
    void test_next();
    void finish();

    const Scene& scene_;
    World world_;
    PoolPlay play_;
    Solver solver_;
    HandError error_;
    std::uint64_t seed_;
    Box cloth_;
    double most_speed_;
    Stage stage_ = Stage::trying;
    std::vector<Candidate> candidates_;
    std::size_t next_ = 0;
    int round_ = 0;
    std::vector<PoolThought> best_;
};

/// What to choose where the rules ask. Pre: the phase is choosing.
PoolChoice choice_of(const Scene& scene, const World& world, const PoolPlay& play,
                     const HandError& error);

/// The commands of a thought, with the error of the hand that carries it out.
std::vector<Command> commands_of(const Scene& scene, const PoolPlay& play,
                                 const PoolThought& thought, const HandError& error,
                                 std::uint64_t seed);

/// Of one decision: another for each shot of each frame.
std::uint64_t decision_seed(const World& world, const PoolPlay& play);

}  // namespace carom
