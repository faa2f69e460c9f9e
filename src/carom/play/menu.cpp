#include "carom/play/menu.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "carom/files/high_scores.h"
#include "carom/files/recording.h"
#include "carom/text/level_words.h"
#include "game/rules/goal.h"
#include "game/rules/rules.h"
#include "terminal/canvas/character_width.h"
#include "terminal/panels/pages.h"

namespace carom {
namespace {

/// The time that an entry must stay selected before its level is loaded, s, so that holding an
/// arrow key does not wait for pictures.
constexpr double load_delay = 0.12;
/// High scores that are shown.
constexpr std::size_t most_notes = 3;

/// The last line: the longest that fits.
constexpr std::array<std::string_view, 4> footers = {
    "enter play   <- -> groups   type to search   f1 help   f2 theme   q quit",
    "enter play  <- -> groups  f1 help  f2 theme  q quit", "enter play  f1 help  q quit",
    "enter play"};

constexpr std::array<std::string_view, 2> empty_group = {
    "No level in this folder, and no recording, yet.",
    "In play, w saves a level and W keeps a recording."};
constexpr std::array<std::string_view, 2> nothing_matches = {"Nothing matches.", ""};

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

// How well the item matches: what it is called before what is said about it.
enum class Match : std::uint8_t { is_called, begins, within_name, within_text, none };

Match match_of(const MenuItem& item, const std::string& search) {
    const std::string wanted = lower_case(search);
    Match best = Match::none;
    for (const std::string& text : {lower_case(item.name), lower_case(item.title)}) {
        if (text == wanted) return Match::is_called;
        const std::size_t at = text.find(wanted);
        if (at != std::string::npos)
            best = std::min(best, at == 0 ? Match::begins : Match::within_name);
    }
    const std::string all = lower_case(item.name + " " + item.title + " " + item.line);
    return std::min(best, all.find(wanted) != std::string::npos ? Match::within_text : Match::none);
}

std::vector<std::string> score_notes(const std::string& path, std::size_t most) {
    const HighScoresText kept = load_high_scores(high_scores_name(path), most);
    if (kept.problem) return {*kept.problem};
    std::vector<std::string> notes;
    for (const HighScore& score : kept.scores.lines)
        if (notes.size() < most_notes)
            notes.push_back(fmt::format("{:>2}  {} {:>12}", notes.size() + 1, score.initials,
                                        grouped(score.score)));
    return notes;
}

// Under which it is known what was loaded for an item.
std::string key_of(const MenuItem& item) {
    if (item.interrupted) return item.interrupted->file;
    return item.challenge ? item.challenge->name : item.path;
}

// Why an unfinished game cannot be resumed; empty if nothing is known to be in the way.
std::vector<std::string> obstacle_of(const InterruptedGame& game, const LoadedLevel& loaded) {
    if (!loaded.error.empty())
        return {"Its level cannot be read, so it cannot be resumed:", game.replay.level};
    if (!loaded.result.scene) return {"Its level has errors now. Press enter to see them."};
    return {};
}

}  // namespace

Menu::Menu(std::vector<MenuItem> items, Load load, std::string_view choose)
    : items_(std::move(items)), load_(std::move(load)) {
    for (const MenuItem& item : items_)
        if (groups_.empty() || groups_.back() != item.group) groups_.push_back(item.group);
    if (groups_.empty() || groups_.back() != own_group) groups_.emplace_back(own_group);
    const auto chosen = std::ranges::find_if(items_, [&](const MenuItem& item) {
        const bool was_interrupted = item.interrupted && !item.interrupted->was_left;
        return !choose.empty() && (item.path == choose || item.name == choose) && !was_interrupted;
    });
    if (chosen == items_.end()) return;
    group_ = static_cast<std::size_t>(std::ranges::find(groups_, chosen->group) - groups_.begin());
    const auto all = shown();
    selected_ = static_cast<std::size_t>(std::ranges::find(all, &*chosen) - all.begin());
}

std::vector<const MenuItem*> Menu::shown() const {
    std::vector<const MenuItem*> shown;
    if (search_.empty()) {
        for (const MenuItem& item : items_)
            if (item.group == groups_[group_]) shown.push_back(&item);
        return shown;
    }
    std::array<std::vector<const MenuItem*>, static_cast<std::size_t>(Match::none)> found;
    for (const MenuItem& item : items_)
        if (const Match match = match_of(item, search_); match != Match::none)
            found[static_cast<std::size_t>(match)].push_back(&item);
    for (const auto& alike : found)
        shown.insert(shown.end(), alike.begin(), alike.end());
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

void Menu::open_group(std::size_t index) {
    if (index >= groups_.size()) return;
    search_.clear();
    group_ = index;
    selected_ = 0;
    seconds_on_selected_ = 0.0;
    needs_draw_ = true;
}

void Menu::open_group_beside(int step) {
    const std::size_t count = groups_.size();
    if (count > 0) open_group((group_ + count + static_cast<std::size_t>(step)) % count);
}

void Menu::tell(std::string message) {
    message_ = std::move(message);
    needs_draw_ = true;
}

void Menu::search(std::string text) {
    const MenuItem* before = selected();
    search_ = std::move(text);
    selected_ = 0;  // what matches best
    // What was found stays selected when the search ends.
    if (search_.empty() && before) {
        group_ =
            static_cast<std::size_t>(std::ranges::find(groups_, before->group) - groups_.begin());
        const auto all = shown();
        selected_ = static_cast<std::size_t>(std::ranges::find(all, before) - all.begin());
    }
    seconds_on_selected_ = 0.0;
    needs_draw_ = true;
}

void Menu::look_at_selected() {
    const MenuItem& item = *selected();
    pictured_ = key_of(item);
    picture_.reset();
    needs_draw_ = true;
    if (item.is_recording) return look_at_recording(item);
    LoadedLevel loaded = load_(item);
    LoadedEntry& known = loaded_[pictured_];
    if (item.interrupted) known.notes = obstacle_of(*item.interrupted, loaded);
    known.is_broken = !loaded.result.scene || !known.notes.empty();
    if (!loaded.result.scene) {
        if (!loaded.error.empty() && known.notes.empty()) known.notes = {loaded.error};
        if (known.notes.empty()) known.notes = {"This level has errors. Press enter to see them."};
        return;
    }
    Scene& scene = *loaded.result.scene;
    LevelWords words = words_of(scene.comment);
    known.goal = std::move(words.goal);
    known.about.clear();
    for (LevelWords::Item& about : words.items)
        known.about.push_back({std::move(about.left), std::move(about.text)});
    if (known.goal.empty() && !scene.rules.goals.empty())
        known.goal = scene.rules.goals.front().text;
    if (item.interrupted && !known.is_broken)
        known.notes = {fmt::format("Enter resumes it at {}.", item.badge)};
    else if (scene.table.is_game)
        known.notes = score_notes(item.path, scene.table.highscores);
    const SolverSettings solver = scene.solver.value_or(pick_solver(scene.world).settings);
    picture_.emplace(Session(std::move(scene), solver, 0), ViewOptions{}, KeyMap());
    picture_->demonstrate();
}

// The picture plays the recording.
void Menu::look_at_recording(const MenuItem& item) {
    LoadedEntry& known = loaded_[pictured_];
    auto opened = open_replay(item.path);
    auto* const read = std::get_if<OpenedReplay>(&opened);
    known.is_broken = !read;
    if (!read) {
        known.notes = {"This recording has errors. Press enter to see them."};
        return;
    }
    Session session(std::move(read->scene), read->replay.solver, 0);
    session.follow(std::move(read->replay.commands), read->replay.end,
                   read->replay.fingerprint_version);
    picture_.emplace(std::move(session), ViewOptions{}, KeyMap());
}

void Menu::advance(double seconds, const MayGoOn& may_go_on) {
    const MenuItem* item = selected();
    if (!item) {
        picture_.reset();
        pictured_.clear();
        return;
    }
    seconds_on_selected_ += seconds;
    if (key_of(*item) != pictured_) {
        if (seconds_on_selected_ >= load_delay) look_at_selected();
        return;
    }
    if (!picture_) return;
    picture_->advance(seconds, may_go_on);
    needs_draw_ = needs_draw_ || picture_->needs_draw();
}

MenuPage Menu::page() const {
    MenuPage page{.groups = groups_,
                  .group = group_,
                  .selected = selected_,
                  .search = search_,
                  .footer = std::string(footers.back())};
    const auto footer = std::ranges::find_if(
        footers, [&](std::string_view text) { return columns_of(text) + 2 <= columns_; });
    if (footer != footers.end()) page.footer = *footer;
    if (!search_.empty()) page.footer = fmt::format("search: {}   esc clears", search_);
    page.message = message_;
    for (const MenuItem* item : shown()) {
        MenuEntry entry{item->title, item->line, item->badge};
        const auto known = loaded_.find(key_of(*item));
        entry.is_broken = known != loaded_.end() && known->second.is_broken;
        page.entries.push_back(std::move(entry));
    }
    const MenuItem* item = selected();
    const auto known = item ? loaded_.find(key_of(*item)) : loaded_.end();
    if (item && item->challenge) page.goal = item->challenge->goal;
    if (known == loaded_.end()) return page;
    if (page.goal.empty()) page.goal = known->second.goal;
    page.notes = known->second.notes;
    page.about = known->second.about;
    return page;
}

void Menu::draw(Canvas& canvas, double aspect, const ViewOptions& view) {
    needs_draw_ = false;
    columns_ = canvas.columns();
    rows_ = canvas.rows();
    if (is_too_small(columns_, rows_)) return draw_too_small(canvas);
    if (picture_) picture_size_ = picture_->preview_size();
    MenuPage now = page();
    if (picture_size_.x > 0.0) now.picture_shape = picture_size_.y / picture_size_.x / aspect;
    draw_menu(canvas, now, view.look);
    if (now.entries.empty()) {
        const std::array lines = search_.empty() ? empty_group : nothing_matches;
        for (std::size_t i = 0; i < lines.size(); ++i)
            canvas.write(3, 3 + static_cast<int>(i), lines[i]);
    }
    const MenuItem* item = selected();
    if (!item || key_of(*item) != pictured_ || !picture_) return;
    const CellArea area = menu_picture_area(columns_, rows_, now);
    if (area.columns <= 0 || area.rows <= 0) return;
    picture_->set_view(view);
    picture_->draw_preview(canvas, area, aspect);
}

}  // namespace carom
