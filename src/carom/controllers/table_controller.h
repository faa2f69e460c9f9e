#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/controllers/table_keys.h"
#include "carom/files/high_scores.h"
#include "game/ai/demo_player.h"
#include "game/session/session.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/table_camera.h"
#include "terminal/draw/table_marks.h"
#include "terminal/input/input.h"
#include "terminal/panels/score_panel.h"

/// Where a person stands at a table of pinball: the hands on its buttons, the eyes that follow the
/// ball, the score that is read, and the initials that are left behind. Knows no files.
namespace carom {

class TableSeat {
  public:
    static bool is_at(const Session& session);

    // Hands. What they press is for the caller to apply.
    std::vector<command::Press> take(const InputEvent& event);
    /// The left button of the mouse is the left flipper, and so on; where a ball lies on the
    /// plunger, a press there pulls it. `at`: where the mouse is, in the world. None: the press is
    /// meant for something else.
    std::optional<std::vector<command::Press>> take_mouse(const InputEvent& event, Vec2 at,
                                                          const Session& session);
    /// A press on the plunger that is drawn on pulls it by hand: the further, the stronger.
    /// `row`: height of a row of the screen, length. None: the event is meant for something else.
    std::optional<command::Pull> drag_plunger(const InputEvent& event, Vec2 at, double row);
    std::vector<command::Press> pass(double seconds) { return keys_.pass(seconds); }
    std::vector<command::Press> let_go() { return keys_.let_go(); }
    /// Flippers stay where a press puts them, or only while it lasts. Returns what is so now.
    std::string next_hold();
    /// "up while held", how buttons are held, for the status line.
    std::string hold_text() const;
    void set_tells_release(bool tells) { keys_.set_tells_release(tells); }

    // Ears.
    /// Whether a bell shall ring now: something kicked or took the ball since the last call, and
    /// the bell has been still for a while. `seconds`: since the last call.
    bool rings(const Session& session, double seconds);

    // carom plays by itself.
    void demonstrate(bool does) { demo_ = does ? std::optional(DemoPlayer{}) : std::nullopt; }
    bool is_demonstrating() const { return demo_.has_value(); }
    /// Before each tick.
    std::vector<command::Press> play(const Session& session);

    // Eyes.
    void follow(const Session& session, double seconds);
    void toggle_whole() { shows_whole_ = !shows_whole_; }
    /// Takes the room for the score from the right of `area`.
    void cut_panel(CellArea& area);
    /// `fine`: so many dots to a cell that the ball can be seen on all of the table.
    Camera look(const Session& session, const CellArea& area, double aspect, bool fine);
    TableMarks marks(const Session& session) const;
    void draw_panel(Canvas& canvas, const Session& session, const Look& look) const;
    /// What the table has said since the last call; none: nothing new.
    std::optional<std::string> hear(const Session& session);
    bool has_panel() const { return panel_.columns > 0; }

    // The table of honour.
    void set_high_scores(HighScores scores) { high_scores_ = std::move(scores); }
    /// The same table, changed on disk: how it is held and seen stays, and so do its scores, of
    /// which it shows this many now.
    void continue_from(const TableSeat& before, std::size_t most_scores);
    /// The game is over, and the score is among the best: letters are awaited.
    void watch_end(const Session& session);
    bool asks_initials() const { return initials_.has_value(); }
    /// A letter, a correction, or the end of it.
    void type_initials(const InputEvent& event);
    /// The line that has been written, once.
    std::optional<HighScore> take_high_score();

  private:
    TableKeys keys_;
    /// The mouse has pressed on the plunger here, and has drawn it on or not.
    struct Grip {
        Vec2 from;
        Vec2 direction;  ///< in which balls are sent
        bool has_pulled = false;
    };
    std::optional<Grip> grip_;
    std::uint64_t heard_flash_ = 0;  ///< what kicks: see rings()
    std::size_t heard_held_ = 0;     ///< balls in holes
    double since_bell_ = 1e9;        ///< s
    std::optional<DemoPlayer> demo_;
    bool was_demonstrated_ = false;  ///< some of this game: it leaves no initials
    TableCamera camera_;
    bool shows_whole_ = false;
    CellArea panel_;
    std::string heard_;

    HighScores high_scores_;
    std::optional<std::string> initials_;
    std::int64_t asked_for_ = 0;  ///< score
    std::optional<HighScore> written_;
    std::optional<HighScore> newest_;
    std::uint64_t last_game_ = 0;  ///< whose end has been seen
};

/// 1234567 as 1,234,567.
std::string grouped(std::int64_t number);

}  // namespace carom
