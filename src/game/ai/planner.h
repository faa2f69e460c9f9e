#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/ai/play_style.h"
#include "game/ai/pool_shots.h"
#include "game/ai/shot_noise.h"
#include "game/pool/pool.h"
#include "game/session/forecast.h"

/// The planner of the AI player at pool. It proposes candidate shots by geometry, simulates each on
/// the engine, then simulates the best ones again with execution noise, and ranks them by the
/// position they leave. Shots that fall behind get fewer of these trials. The work is bounded by a
/// number of shots, never by a clock, so a position gives the same shot on every machine.
namespace carom {

/// Levels of skill, which set the execution noise of the AI player.
inline constexpr int least_skill = 1;
inline constexpr int most_skill = 4;
ShotNoise shot_noise(int skill);
std::string_view skill_text(int skill);

/// A shot that the planner proposes.
struct CandidateShot {
    enum class Kind : std::uint8_t { break_off, straight, cut, bank, kick, safety, push_out };
    Kind kind = Kind::cut;
    std::optional<Vec2> place;  ///< where to place the cue ball first
    PoolCall call;
    command::Strike strike;   ///< without noise
    std::optional<int> ball;  ///< the number of the ball that is aimed at
    int pocket = 0;           ///< the pocket aimed at, if any
    double value = 0.0;  ///< -1 (lost) to 1 (won), mean over the trials with noise, and the style
    /// Share of the trials with noise after which the player continues or has won.
    double success = 0.0;
    std::optional<int> leaves;  ///< the easiest ball afterwards, without noise
};

/// "cut the 4 into the top left, 2.0 m/s  83 % chance to continue, then the 6  draw": two blanks
/// divide it into parts, the most important first (HudInfo::game).
std::string candidate_text(const Scene& scene, const CandidateShot& shot);

/// One decision, computed in pieces of any size.
class ShotPlanner {
  public:
    /// One decision simulates about this many shots.
    static constexpr int most_tries = 270;

    /// Pre: the balls are at rest, the phase is breaking or playing; the scene outlives the
    /// planner.
    ShotPlanner(const Scene& scene, const World& world, const PoolPlay& play,
                const SolverSettings& solver, const ShotNoise& error, std::uint64_t seed,
                const PlayStyle& style = {});

    /// Simulates up to `tries` more shots. How the work is divided does not change the result.
    void work(int tries);
    bool is_done() const { return stage_ == Stage::done; }
    /// The best shots, best first: one to three once it is done, none before.
    const std::vector<CandidateShot>& best() const { return best_; }

  private:
    enum class Stage : std::uint8_t { trying, testing, done };
    struct Trial {
        CandidateShot shot;
        double chance = 1.0;  ///< probability of success, by geometry
        double first_value = 0.0;
        double sum = 0.0;
        int continued = 0;
    };

    void propose();
    void propose_break();
    void propose_pots(std::optional<Vec2> place, std::span<const PotLine> lines);
    void propose_opening(Vec2 from);
    void propose_hits(Vec2 from, std::optional<Vec2> place);
    void propose_placed();
    void add_pot(const PotLine& line, std::optional<Vec2> place, Vec2 direction, double speed,
                 double side, double follow);
    Vec2 corrected(const PotLine& line, std::optional<Vec2> place, double speed);
    std::vector<BallId> nearest_balls(Vec2 from) const;
    bool may_place(Vec2 place) const;
    World world_with(const std::optional<Vec2>& place) const;
    Forecast try_out(const Trial& trial, const command::Strike& strike);
    double value_of(const Forecast& ahead) const;
    bool continues_turn(const Forecast& ahead) const;
    double liking_for(const CandidateShot& shot, double success) const;
    void try_next();
    void begin_testing();
    void test_next();
    void rank_finalists();
    void finish();

    const Scene& scene_;
    World world_;
    PoolPlay play_;
    Solver solver_;
    ShotNoise error_;
    PlayStyle style_;
    std::uint64_t seed_;
    Box cloth_;
    double most_speed_;
    Stage stage_ = Stage::trying;
    std::vector<Trial> trials_;
    std::size_t next_ = 0;
    int round_ = 0;
    std::size_t finalists_ = 0;  ///< the first of trials_, which are still tested
    std::vector<CandidateShot> best_;
};

/// The choice of the AI player where the rules ask for one: that with the best outlook, the first
/// of equals. Pre: the phase is choosing.
PoolChoice choice_of(const Scene& scene, const World& world, const PoolPlay& play,
                     const ShotNoise& error);

/// The commands that carry out a shot, with execution noise.
std::vector<Command> commands_of(const Scene& scene, const PoolPlay& play,
                                 const CandidateShot& shot, const ShotNoise& error,
                                 std::uint64_t seed);

/// The random seed of a decision, different for each shot of each frame.
std::uint64_t decision_seed(const World& world, const PoolPlay& play);

}  // namespace carom
