// The forecast of a shot that is being set up, and its scatter.
#include <utility>

#include "carom/pool/pool_aim.h"
#include "carom/pool/pool_status.h"
#include "game/ai/shot_noise.h"

namespace carom {
namespace {

/// The time for which a shot is predicted, s: balls roll for half a minute at most.
constexpr double foresight = 40.0;
constexpr std::uint64_t cloud_size = 20;

}  // namespace

void PoolAim::look(const Session& session) {
    const PoolPlay* game = pool_of(session);
    const ShotsState* shots = shots_of(session);
    if (!may_aim(session)) {
        is_seen_ = false;
        forecast_.reset();
        cloud_.clear();
        return;
    }
    // A number that identifies the turn and the rack.
    const std::uint64_t now = game ? std::uint64_t{game->shots} * 64 +
                                         static_cast<std::uint64_t>(game->rules.phase) * 8 +
                                         static_cast<std::uint64_t>(game->rules.player)
                              : shots ? std::uint64_t{shots->games} << 32 | shots->shots
                                      : 0;
    if (std::exchange(turn_, now) != now) begin_turn(session);
    setup_.speed = std::min(setup_.speed, cue_in_turn(session).most_power);
    // The ball in hand was moved: aim anew.
    if (!has_aimed_ && may_place(session) && positions_ != session.world().balls().position)
        aim_first(session);
    if (is_seen_ && seen_setup_ == setup_ && positions_ == session.world().balls().position) return;
    is_seen_ = true;
    seen_setup_ = setup_;
    positions_ = session.world().balls().position;
    cloud_.clear();
    cloud_shots_ = 0;
    forecast_.reset();
    if (is_match_ || is_break(session)) return;
    Solver solver(session.solver());
    forecast_ = forecast(session.scene(), session.world(), session.game(), solver, strike(session),
                         foresight, Tracks::all);
}

bool PoolAim::has_work() const {
    return setup_.aids == Aids::cloud && forecast_ && cloud_shots_ < cloud_size;
}

bool PoolAim::work(const Session& session) {
    if (!has_work() || !may_aim(session)) return false;
    const ShotNoise usual;
    const command::Strike off = with_noise(strike(session), usual, cue_in_turn(session).most_power,
                                           session.world().seed(), cloud_shots_++);
    Solver solver(session.solver());
    const Forecast ahead = forecast(session.scene(), session.world(), session.game(), solver, off,
                                    foresight, Tracks::all);
    for (const Forecast::Track& track : ahead.tracks)
        cloud_.push_back({track.ball, track.way.back(), track.zone.has_value()});
    return true;
}

}  // namespace carom
