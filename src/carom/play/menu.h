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

#include "carom/files/level_files.h"
#include "carom/play/challenge.h"
#include "carom/play/player.h"
#include "carom/play/resume.h"
#include "terminal/input/input.h"
#include "terminal/panels/menu.h"

/// The menu: unfinished games first, then the groups of the levels that ship (files/menu_list.h),
/// and one's own levels and recordings; with a small moving picture of what is selected.
namespace carom {

/// An entry that can be chosen.
struct MenuItem {
    std::string name;
    std::string title;
    std::string group;
    std::string path;                              ///< of the level
    std::string line{};                            ///< about the level
    std::string badge{};                           ///< at the right of the title: a score, a time
    std::optional<InterruptedGame> interrupted{};  ///< the unfinished game to resume, if it is one
    std::optional<Challenge> challenge{};          ///< if it is one
    bool is_recording = false;                     ///< `path` is one, to be watched
};

/// The group of one's own levels and recordings. It is there even while it is empty.
inline constexpr std::string_view own_group = "Yours";

/// Items for unfinished games, the levels that ship, the levels of the current folder, and the
/// recordings that were kept; the items of a group stand together.
std::vector<MenuItem> menu_items(std::span<const InterruptedGame> interrupted);

class Menu {
  public:
    using Load = std::function<LoadedLevel(const MenuItem&)>;

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
    /// Shows a message in the last line, until the next key.
    void tell(std::string message);
    void tell_keys();
    void draw(Canvas& canvas, double aspect, const ViewOptions& view);

    /// The items of the open group, or those of all groups that match the search; and the selected
    /// one (null if there is none).
    std::vector<const MenuItem*> shown() const;
    const MenuItem* selected() const;

  private:
    /// What is known of a level that was loaded.
    struct LoadedEntry {
        std::string goal;
        std::vector<std::string> notes;
        std::vector<PageItem> about;
        bool is_broken = false;
    };
    void select(std::size_t index);
    void open_group(std::size_t index);
    void open_group_beside(int step);
    void search(std::string text);
    void look_at_selected();
    void look_at_recording(const MenuItem& item);
    Choice handle_key(const InputEvent& event);
    Choice handle_escape(bool was_asked);
    Choice handle_mouse(const InputEvent& event);
    MenuPage page() const;

    std::vector<MenuItem> items_;
    std::vector<std::string> groups_;  ///< in the order of the items; never empty
    Load load_;
    std::string search_;
    std::string message_;
    bool asks_to_quit_ = false;  ///< the next escape quits
    std::size_t group_ = 0;      ///< the open one
    std::size_t selected_ = 0;   ///< index into shown()
    std::map<std::string, LoadedEntry> loaded_;

    double seconds_on_selected_ = 0.0;
    std::string pictured_;  ///< the item in the picture, as in `loaded_`; empty: none yet
    std::optional<Player> picture_;
    /// The size of the last picture, so that words below it stay while the next one is loaded.
    Vec2 picture_size_;

    int columns_ = 0;
    int rows_ = 0;
    bool needs_draw_ = true;
};

}  // namespace carom
