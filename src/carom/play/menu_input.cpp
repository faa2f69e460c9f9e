// What keys and the mouse do in the menu.
#include <utility>

#include "carom/play/menu.h"
#include "level/text/utf8.h"
#include "terminal/canvas/character_width.h"

namespace carom {
namespace {

/// The longest text to search for, bytes.
constexpr std::size_t most_searched = 60;

}  // namespace

Menu::Choice Menu::handle(const InputEvent& event) {
    const bool is_press = event.action == InputEvent::Action::press;
    if (is_press) tell({});
    const bool was_asked = is_press && std::exchange(asks_to_quit_, false);
    if (is_press && event.kind == InputEvent::Kind::key && event.key == key::escape)
        return handle_escape(was_asked);
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
        case key::left:
        case key::backtab:
            open_group_beside(-1);
            return {};
        case key::right:
        case key::tab:
            open_group_beside(1);
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
        case key::backspace:
            while (!search_.empty() && continues_sequence(search_.back()))
                search_.pop_back();
            search(search_.substr(0, search_.empty() ? 0 : search_.size() - 1));
            return {};
        case key::f1:
            tell_keys();
            return {};
        case U'?':
            if (!search_.empty()) break;
            tell_keys();
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

void Menu::tell_keys() {
    tell(columns_ < 60 ? "In a game: ? keys, f1 the level"
                       : "Enter plays. In a game, ? lists the keys, f1 explains the level.");
}

// Escape goes back everywhere else, so a press too many must not end the program.
Menu::Choice Menu::handle_escape(bool was_asked) {
    if (was_asked) return Quit{};
    asks_to_quit_ = search_.empty();
    if (asks_to_quit_) {
        tell("Press esc again to quit.");
    } else {
        search({});
    }
    return {};
}

Menu::Choice Menu::handle_mouse(const InputEvent& event) {
    using enum InputEvent::Action;
    if (event.action == wheel_up) select(selected_ > 0 ? selected_ - 1 : 0);
    if (event.action == wheel_down) select(selected_ + 1);
    if (event.action != press) return {};
    const int column = static_cast<int>(event.column);
    const int row = static_cast<int>(event.row);
    if (const auto group = menu_group_at(columns_, page(), column, row)) {
        open_group(*group);
        return {};
    }
    const auto entry = menu_entry_at(columns_, rows_, page(), column, row);
    if (!entry) return {};
    if (*entry == selected_) return *shown()[selected_];
    select(*entry);
    return {};
}

}  // namespace carom
