#pragma once

#include <vector>

#include "carom/context/action.h"
#include "carom/context/help_page.h"
#include "carom/files/high_scores.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/draw/draw.h"
#include "terminal/input/input.h"
#include "terminal/panels/hud.h"

/// A controller is a way of playing: free play, pool, pinball, or watching a recording. The player
/// (carom/play) holds one and calls it at fixed moments; the implementations are in
/// carom/controllers.
namespace carom {

/// A controller never owns the game: every call gets the context that the player owns. Most
/// functions have a default that does nothing, so a controller overrides only what it needs.
class Controller {
  public:
    virtual ~Controller() = default;

    /// The way of playing, for the help page and the status lines.
    virtual PlayKind kind() const = 0;

    /// Offers a key or a mouse report before it is looked up as an action. Returns whether the
    /// controller consumed it. Not called while a page covers the game.
    virtual bool take(PlayContext&, const InputEvent&) { return false; }
    /// Performs an action, or tells the player why it does not apply.
    virtual void perform(PlayContext&, const Action&) = 0;

    /// A mouse button was pressed, or released, at the pointer.
    virtual void press(PlayContext&, const InputEvent&) {}
    virtual void release(PlayContext&, const InputEvent&) {}
    /// The pointer has moved.
    virtual void point(PlayContext&) {}

    /// `seconds` of wall-clock time pass, whether or not ticks are computed.
    virtual void pass(PlayContext&, double /*seconds*/) {}
    virtual void before_tick(PlayContext&) {}
    /// The ticks of these `seconds` have been computed: the controller may tell what happened.
    virtual void after_ticks(PlayContext&, double /*seconds*/) {}
    /// Whether it has computations to do, or a timer running, even while the game is paused.
    virtual bool has_work() const { return false; }

    /// Takes the room for the controller's own panel from the area of the world.
    virtual void cut_panel(const PlayContext&, CellArea&) {}
    /// The camera that shows the scene as a whole.
    virtual Camera fit(const PlayContext&, const CellArea& area, double aspect);
    /// Called before each picture: updates what annotate() shows.
    virtual void look(PlayContext&) {}
    virtual void annotate(const PlayContext&, Annotations&) const;
    virtual void draw_panel(const PlayContext&, Canvas&) const {}
    virtual void add_status(const PlayContext&, HudInfo&) const {}
    virtual void add_hints(const PlayContext&, std::vector<KeyHelp>&) const {}
    /// Words of the help page that depend on the game that is played.
    virtual std::vector<HelpWords> help_words(const PlayContext&) const { return {}; }
    /// Whether the controller's own hints are all that hold: keys are typed into a text, or the
    /// next key must not be missed.
    virtual bool has_all_hints() const { return false; }

    /// Whether the mouse drags every ball and edge, which the hints then mention.
    virtual bool drags_anything() const { return false; }
    /// Receives the stored high scores of the table.
    virtual void set_high_scores(HighScores) {}
    /// The level was changed on disk and play continues: takes over the player's state from
    /// `before`.
    virtual void continue_from(PlayContext&, const Controller& /*before*/) {}
};

}  // namespace carom
