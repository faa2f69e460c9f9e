#pragma once

#include <vector>

#include "carom/context/action.h"
#include "carom/files/high_scores.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/draw/draw.h"
#include "terminal/input/input.h"
#include "terminal/panels/hud.h"

/// A way of playing: free play, pool, pinball, or watching a recording. The player (carom/play)
/// holds one and asks it at fixed moments; what it answers lives in carom/controllers.
namespace carom {

/// A controller never owns the game: every call gets the context that the player owns. Each
/// function has a default that does nothing, so a controller says only what is its own.
class Controller {
  public:
    virtual ~Controller() = default;

    /// A key or a report of the mouse, before it is looked up as an action. True: it was for this
    /// controller. Not called while a page covers the game.
    virtual bool take(PlayContext&, const InputEvent&) { return false; }
    /// Does what the action means here, or says why it does not apply.
    virtual void perform(PlayContext&, const Action&) = 0;

    /// A button of the mouse went down, or came up, at the pointer.
    virtual void press(PlayContext&, const InputEvent&) {}
    virtual void release(PlayContext&, const InputEvent&) {}
    /// The pointer has moved.
    virtual void point(PlayContext&) {}

    /// `seconds` of the player's time pass, whether ticks are computed or not.
    virtual void pass(PlayContext&, double /*seconds*/) {}
    virtual void before_tick(PlayContext&) {}
    /// The ticks of these seconds are computed: what the game has to say.
    virtual void after_ticks(PlayContext&, double /*seconds*/) {}
    /// Something is to be computed, or time counts, even while the game is paused.
    virtual bool has_work() const { return false; }

    /// Cuts what the controller draws for itself from the area of the world.
    virtual void cut_panel(const PlayContext&, CellArea&) {}
    /// The camera that shows the scene as a whole.
    virtual Camera fit(const PlayContext&, const CellArea& area, double aspect);
    /// Before a picture: brings what mark() shows up to date.
    virtual void look(PlayContext&) {}
    virtual void mark(const PlayContext&, Marks&) const;
    virtual void draw_panel(const PlayContext&, Canvas&) const {}
    virtual void add_status(const PlayContext&, HudInfo&) const {}
    virtual void add_hints(const PlayContext&, std::vector<KeyHelp>&) const {}

    /// The mouse drags any ball and edge, which the hints say.
    virtual bool drags_anything() const { return false; }
    /// The high scores of the table, as they are kept.
    virtual void set_high_scores(HighScores) {}
    /// The same scene, changed on disk, is played on: takes over what `before` held of the player.
    virtual void continue_from(PlayContext&, const Controller& /*before*/) {}
};

}  // namespace carom
