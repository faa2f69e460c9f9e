#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/canvas/palette.h"

/// The panel beside a pinball table: the score in large characters, and the state of the game.
namespace carom {

struct ScoreLine {
    std::string rank;
    std::string name;
    std::string score;
    bool is_new = false;
};

/// A light of the table that has a name, or several of one name.
struct ScoreLight {
    std::string name;
    std::vector<bool> lamps;   ///< whether each is lit
    bool is_wanted = false;    ///< the task asks for it
    std::optional<Rgb> color;  ///< of its lamps
};

struct ScorePanel {
    /// How the message is drawn: in a line, or higher, in two colours that take turns.
    enum class Moment : std::uint8_t { plain, large, large_bright };

    std::string title;
    std::string score;                   ///< digits and commas
    std::string message;                 ///< drawn in a box; may be empty
    Moment moment = Moment::plain;       ///< of the message
    std::vector<std::string> lines;      ///< the ball, the bonus, ...
    std::string task;                    ///< what to do now; may be empty
    std::string call;                    ///< an announcement such as "SHOOT AGAIN"; may be empty
    std::vector<ScoreLight> lights;      ///< shown where the window is high enough
    std::vector<ScoreLine> high_scores;  ///< the best first
    std::vector<std::string> balls;      ///< of this game: what each of the balls scored
};

/// Widths, in columns.
inline constexpr int score_panel_columns = 34;
inline constexpr int most_score_panel_columns = 72;

/// Draws as much of the panel as fits. Digits are made of half blocks or number signs; a score too
/// long for them is written small.
void draw_score_panel(Canvas& canvas, const CellArea& area, const ScorePanel& panel,
                      const Look& look);

/// A card beside the table with the author's text: paragraphs and lists of a word and what it does.
/// `text`: Scene::comment.
void draw_rules_card(Canvas& canvas, const CellArea& area, std::string_view title,
                     const std::vector<std::string>& text, const Look& look);
inline constexpr int rules_card_columns = 30;
inline constexpr int most_rules_card_columns = 46;

}  // namespace carom
