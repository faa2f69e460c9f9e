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

/// The companion runs beside the game and follows it: either a comparison run, which is the same
/// game under another solver, or an ensemble of perturbed copies. At most one of them exists at a
/// time.
namespace carom {

class Companion {
  public:
    /// Starts the next comparison run from the present state: solvers in turn, the most accurate
    /// first, and after the last none. Returns whether one runs now.
    bool next_comparison(const Session& session);
    enum class EnsembleState : std::uint8_t {
        running,   ///< started, from the present state
        ended,     ///< the ensemble that ran has been ended
        too_large  ///< not started: the copies would not fit into memory
    };
    EnsembleState toggle_ensemble(const Session& session);

    const std::optional<ComparisonRun>& comparison() const { return comparison_; }

    /// Advances the companion to the game's tick. Returns false if `may_go_on` or `keep_going`
    /// stopped it; the next call continues.
    bool follow(const Session& session, const MayGoOn& may_go_on, const KeepGoing& keep_going);
    /// Advances only a comparison run, so that it misses no divergence; an ensemble catches up
    /// later.
    void follow_closely(const Session& session, const KeepGoing& keep_going);
    /// Whether the companion's tick differs from the game's, so that follow() has work.
    bool is_behind(const Session& session) const;
    /// The comparison with the game, for the status line; empty without a companion.
    std::string text() const;

    /// With a comparison run, splits the window and returns the half for the game.
    CellArea split_area(const CellArea& area, const Box& view, double aspect);
    /// Both halves show the same part of the world. Maps a position in the second half to the
    /// first.
    CellPoint in_first_half(CellPoint place) const;
    /// Adds to the game's picture the copies, and the position of the divergence.
    void annotate(Annotations& annotations) const;
    /// Draws the second half and both titles. Pre: comparison().
    void draw(Canvas& canvas, const Session& session, Camera camera, std::optional<BallId> selected,
              const ViewOptions& view);

  private:
    std::optional<ComparisonRun> comparison_;
    std::optional<Ensemble> ensemble_;
    ViewMemory memory_;  ///< of the second half
    Split split_;
};

}  // namespace carom
