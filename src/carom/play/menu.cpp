#include "carom/play/menu.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "carom/controllers/pinball_display.h"
#include "carom/files/high_scores.h"
#include "level/text/utf8.h"
#include "terminal/canvas/character_width.h"

namespace carom {
namespace {

/// The time that an entry must stay selected before its level is loaded, s, so that holding an
/// arrow key does not wait for pictures.
constexpr double load_delay = 0.12;
/// The longest text to search for, bytes.
constexpr std::size_t most_searched = 60;

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

bool matches(const MenuItem& item, const std::string& search) {
    return lower_case(item.name + " " + item.title).find(lower_case(search)) != std::string::npos;
}

void add_levels(std::vector<MenuItem>& items, const std::string& folder, const char* group) {
    for (const LevelEntry& level : levels_in(folder))
        items.push_back({level.name, level.title, group, level.path});
}

std::string time_text(double seconds) {
    const auto whole = static_cast<long>(seconds);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

// Adds the high scores of a table below the description.
void add_high_scores(const std::string& path, std::size_t most, std::vector<std::string>& preview) {
    const HighScoresText kept = load_high_scores(high_scores_name(path), most);
    if (kept.problem) preview.push_back(*kept.problem);
    if (kept.scores.lines.empty()) return;
    preview.push_back("");
    preview.push_back("High scores:");
    for (const HighScore& score : kept.scores.lines)
        preview.push_back(fmt::format("{} {}", score.initials, grouped(score.score)));
}

}  // namespace

std::vector<MenuItem> menu_items(std::span<const InterruptedGame> interrupted) {
    namespace fs = std::filesystem;
    std::vector<MenuItem> items;
    for (const InterruptedGame& game : interrupted) {
        const std::string name = fs::path(game.replay.level).stem().string();
        const double seconds = static_cast<double>(game.replay.position) / game.replay.rate;
        items.push_back({name, "go on at " + time_text(seconds),
                         game.was_left ? "to go on with" : "cut off", game.replay.level, game});
    }
    const auto shipped = shipped_levels_folder();
    std::error_code error;
    if (!shipped || !fs::equivalent(".", *shipped, error)) add_levels(items, ".", "in this folder");
    if (shipped) add_levels(items, *shipped, "levels");
    return items;
}

Menu::Menu(std::vector<MenuItem> items, Load load, std::string_view choose)
    : items_(std::move(items)), load_(std::move(load)) {
    const auto chosen = std::ranges::find_if(items_, [&](const MenuItem& item) {
        const bool was_interrupted = item.interrupted && !item.interrupted->was_left;
        return !choose.empty() && (item.path == choose || item.name == choose) && !was_interrupted;
    });
    if (chosen != items_.end()) selected_ = static_cast<std::size_t>(chosen - items_.begin());
}

std::vector<const MenuItem*> Menu::shown() const {
    std::vector<const MenuItem*> shown;
    for (const MenuItem& item : items_)
        if (matches(item, search_)) shown.push_back(&item);
    return shown;
}

const MenuItem* Menu::selected() const {
    const auto all = shown();
    return selected_ < all.size() ? all[selected_] : nullptr;
}

void Menu::select(std::size_t index) {
    const std::size_t count = shown().size();
    index = count == 0 ? 0 : std::min(index, count - 1);
    if (index == selected_) return;
    selected_ = index;
    seconds_on_selected_ = 0.0;
    needs_draw_ = true;
}

void Menu::search(std::string text) {
    const MenuItem* before = selected();
    search_ = std::move(text);
    const auto all = shown();
    const auto same = std::ranges::find(all, before);
    selected_ = same == all.end() ? 0 : static_cast<std::size_t>(same - all.begin());
    seconds_on_selected_ = 0.0;
    needs_draw_ = true;
}

Menu::Choice Menu::handle(const InputEvent& event) {
    if (event.kind == InputEvent::Kind::mouse) return handle_mouse(event);
    if (event.kind == InputEvent::Kind::key && event.action != InputEvent::Action::release)
        return handle_key(event);
    return {};
}

Menu::Choice Menu::handle_key(const InputEvent& event) {
    constexpr std::size_t page = 10;
    switch (event.key) {
        case key::up:
            select(selected_ > 0 ? selected_ - 1 : 0);
            return {};
        case key::down:
            select(selected_ + 1);
            return {};
        case key::page_up:
            select(selected_ > page ? selected_ - page : 0);
            return {};
        case key::page_down:
            select(selected_ + page);
            return {};
        case key::home:
            select(0);
            return {};
        case key::end:
            select(items_.size());
            return {};
        case key::enter:
            if (const MenuItem* item = selected()) return *item;
            return {};
        case key::escape:
            if (search_.empty()) return Quit{};
            search({});
            return {};
        case key::backspace:
            while (!search_.empty() && continues_sequence(search_.back()))
                search_.pop_back();
            search(search_.substr(0, search_.empty() ? 0 : search_.size() - 1));
            return {};
        case U'q':
            if (search_.empty()) return Quit{};
            break;
        default:
            break;
    }
    const char32_t least = search_.empty() ? U' ' + 1 : U' ';
    const bool is_character = event.key >= least && event.key < 0x110000 && event.key != 0x7f &&
                              !(event.modifiers & (control | alt));
    if (is_character && is_one_column(event.key) && search_.size() < most_searched) {
        std::string text = search_;
        append_utf8(text, event.key);
        search(std::move(text));
    }
    return {};
}

Menu::Choice Menu::handle_mouse(const InputEvent& event) {
    using enum InputEvent::Action;
    if (event.action == wheel_up) select(selected_ > 0 ? selected_ - 1 : 0);
    if (event.action == wheel_down) select(selected_ + 1);
    if (event.action != press) return {};
    const auto entry = menu_entry_at(columns_, rows_, entries(), selected_,
                                     static_cast<int>(event.column), static_cast<int>(event.row));
    if (!entry) return {};
    if (*entry == selected_) return *shown()[selected_];
    select(*entry);
    return {};
}

void Menu::look_at_selected() {
    const MenuItem& item = *selected();
    pictured_ = item.path;
    picture_.reset();
    memory_ = {};
    needs_draw_ = true;
    LoadedLevel loaded = load_(item.path);
    LoadedEntry& known = loaded_[item.path];
    known.is_broken = !loaded.result.scene;
    if (known.is_broken) {
        known.preview = {"This level has mistakes; enter shows them."};
        return;
    }
    Scene& scene = *loaded.result.scene;
    known.preview = scene.comment;
    if (scene.table.is_game) add_high_scores(item.path, scene.table.highscores, known.preview);
    const SolverSettings solver = scene.solver.value_or(pick_solver(scene.world).settings);
    picture_.emplace(std::move(scene), solver, 0);
}

void Menu::advance(double seconds, const MayGoOn& may_go_on) {
    const MenuItem* item = selected();
    if (!item) {
        picture_.reset();
        pictured_.clear();
        return;
    }
    seconds_on_selected_ += seconds;
    if (item->path != pictured_) {
        if (seconds_on_selected_ >= load_delay) look_at_selected();
        return;
    }
    if (picture_ && clock_.advance(*picture_, seconds, may_go_on) > 0) needs_draw_ = true;
}

std::vector<MenuEntry> Menu::entries() const {
    std::vector<MenuEntry> entries;
    for (const MenuItem* item : shown()) {
        MenuEntry entry{item->name, item->title, item->group, {}, false};
        if (const auto known = loaded_.find(item->path); known != loaded_.end()) {
            entry.preview = known->second.preview;
            entry.is_broken = known->second.is_broken;
        }
        entries.push_back(std::move(entry));
    }
    return entries;
}

void Menu::draw(Canvas& canvas, double aspect, const ViewOptions& view) {
    needs_draw_ = false;
    columns_ = canvas.columns();
    rows_ = canvas.rows();
    if (is_too_small(columns_, rows_)) return draw_too_small(canvas);
    const std::vector<MenuEntry> all = entries();
    const std::string footer = search_.empty() ? "enter plays   type to search   q quits"
                                               : fmt::format("search: {}   esc clears", search_);
    draw_menu(canvas, all, selected_, footer, view.look);
    if (all.empty()) canvas.write(2, 2, search_.empty() ? "no levels here" : "nothing matches");
    const MenuItem* item = selected();
    if (!item || item->path != pictured_ || !picture_) return;
    const CellArea area = menu_picture_area(columns_, rows_, all, selected_);
    if (area.columns <= 0 || area.rows <= 0) return;
    const Camera camera = fit_camera(
        shown_box(picture_->scene(), memory_.ground.board(picture_->scene())), area, aspect);
    draw_world(canvas, camera, picture_->scene(), picture_->world(), picture_->contacts(), {}, view,
               memory_);
}

}  // namespace carom
