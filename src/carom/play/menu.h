#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "carom/context/playback_clock.h"
#include "carom/files/level_files.h"
#include "carom/play/resume.h"
#include "game/session/session.h"
#include "terminal/draw/draw.h"
#include "terminal/input/input.h"
#include "terminal/panels/pages.h"

/// The menu: unfinished games, the levels of the current folder and those that ship, with a small
/// moving picture of the selected level.
namespace carom {

/// An entry that can be chosen.
struct MenuItem {
    std::string name;
    std::string title;
    std::string group;
    std::string path;                              ///< of the level
    std::optional<InterruptedGame> interrupted{};  ///< the unfinished game to resume, if it is one
};

/// Items for unfinished games, the levels of the current folder, and the levels that ship.
std::vector<MenuItem> menu_items(std::span<const InterruptedGame> interrupted);

class Menu {
  public:
    using Load = std::function<LoadedLevel(const std::string& path)>;

    /// `load` loads a level for its picture. `choose`: the name of the item to select first, or its
    /// level's path; an unfinished game takes precedence over its level.
    Menu(std::vector<MenuItem> items, Load load, std::string_view choose = {});

    struct Quit {};
    /// monostate: nothing is chosen yet.
    using Choice = std::variant<std::monostate, Quit, MenuItem>;
    Choice handle(const InputEvent& event);

    void advance(double seconds, const MayGoOn& may_go_on);
    bool needs_draw() const { return needs_draw_; }
    void touch() { needs_draw_ = true; }
    void draw(Canvas& canvas, double aspect, const ViewOptions& view);

    /// The items that match the search, and the selected one (null if none match).
    std::vector<const MenuItem*> shown() const;
    const MenuItem* selected() const;

  private:
    /// The loaded data of a level.
    struct LoadedEntry {
        std::vector<std::string> preview;
        bool is_broken = false;
    };
    void select(std::size_t index);
    void search(std::string text);
    void look_at_selected();
    Choice handle_key(const InputEvent& event);
    Choice handle_mouse(const InputEvent& event);
    std::vector<MenuEntry> entries() const;

    std::vector<MenuItem> items_;
    Load load_;
    std::string search_;
    std::size_t selected_ = 0;  ///< index into shown()
    std::map<std::string, LoadedEntry> loaded_;

    double seconds_on_selected_ = 0.0;
    std::string pictured_;  ///< path of the level in the picture; empty: none yet
    std::optional<Session> picture_;
    PlaybackClock clock_;
    ViewMemory memory_;

    int columns_ = 0;
    int rows_ = 0;
    bool needs_draw_ = true;
};

}  // namespace carom
