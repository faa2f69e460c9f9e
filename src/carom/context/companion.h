#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "carom/context/comparison_run.h"
#include "carom/context/ensemble.h"
#include "game/session/session.h"
#include "terminal/draw/draw.h"
#include "terminal/panels/split.h"

/// What runs beside the game and follows it: the same game under another solver, or an ensemble of
/// perturbed copies. At most one of them at a time.
namespace carom {

class Companion {
  public:
    /// From here on the next solver runs beside the game, the most exact first; after the last none
    /// does. False: none does now.
    bool next_comparison(const Session& session);
    enum class EnsembleState : std::uint8_t {
        running,   ///< from now on, from the present state
        ended,     ///< there was one
        too_large  ///< the copies would not fit into memory: none runs
    };
    EnsembleState toggle_ensemble(const Session& session);

    const std::optional<ComparisonRun>& comparison() const { return comparison_; }

    /// Follows the game to its tick: true. Where `may_go_on` or `keep_going` says no, the rest is
    /// left to the next call.
    bool follow(const Session& session, const MayGoOn& may_go_on, const KeepGoing& keep_going);
    /// Follows with the comparison run alone, so that it misses no divergence; an ensemble catches
    /// up later.
    void follow_closely(const Session& session, const KeepGoing& keep_going);
    /// The game is at another tick, and follow() has work.
    bool is_behind(const Session& session) const;
    /// How it compares with the game, for the status line; empty where nothing runs.
    std::string text() const;

    /// With a comparison run, splits the window: returns the half of the game.
    CellArea split_area(const CellArea& area, const Box& view, double aspect);
    /// Both halves show the same places. A place in the second half as one in the first.
    CellPoint in_first_half(CellPoint place) const;
    /// Of the game's picture: the copies, and the place of the divergence.
    void mark(Marks& marks) const;
    /// Pre: comparison(). Draws the second half and both titles.
    void draw(Canvas& canvas, const Session& session, Camera camera, std::optional<BallId> selected,
              const ViewOptions& view);

  private:
    std::optional<ComparisonRun> comparison_;
    std::optional<Ensemble> ensemble_;
    ViewMemory memory_;  ///< of the second half
    Split split_;
};

}  // namespace carom
