#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "carom/play/player.h"

namespace carom::test {

inline bool always() {
    return true;
}

/// Without colours, in ASCII.
inline ViewOptions ascii_view() {
    ViewOptions view;
    view.renderer = &ascii_renderer();
    view.look = {0, false, false};
    return view;
}

/// A player at a window, who presses keys and moves the mouse.
struct PersonAtWindow {
    PersonAtWindow(Session session, int columns, int rows)
        : player(std::move(session), ascii_view(), KeyMap()), window(columns, rows) {
        look();
    }

    std::string look() {
        player.draw(window, 2.0);
        return window.text();
    }
    bool sees(const std::string& text) { return look().find(text) != std::string::npos; }
    PlayRequest key(char32_t code, std::uint8_t modifiers = no_modifier) {
        InputEvent event;
        event.key = code;
        event.modifiers = modifiers;
        return player.handle(event);
    }
    void mouse(InputEvent::Action action, Vec2 at, std::uint8_t button = 1,
               std::uint8_t modifiers = no_modifier) {
        mouse_in_cells(action, to_cells(player.camera(), at), button, modifiers);
    }
    void mouse_in_cells(InputEvent::Action action, CellPoint place, std::uint8_t button,
                        std::uint8_t modifiers) {
        InputEvent event;
        event.kind = InputEvent::Kind::mouse;
        event.action = action;
        event.button = button;
        event.modifiers = modifiers;
        event.column = place.column;
        event.row = place.row;
        player.handle(event);
    }
    void drag(Vec2 from, Vec2 to, std::uint8_t button = 1, std::uint8_t modifiers = no_modifier) {
        const Camera camera = player.camera();  // the camera at the start, whatever is dragged
        const auto at = [&](Vec2 place) { return to_cells(camera, place); };
        mouse_in_cells(InputEvent::Action::press, at(from), button, modifiers);
        mouse_in_cells(InputEvent::Action::move, at((from + to) * 0.5), button, modifiers);
        mouse_in_cells(InputEvent::Action::move, at(to), button, modifiers);
        mouse_in_cells(InputEvent::Action::release, at(to), button, modifiers);
    }
    void pass(double seconds) {
        player.fade_messages(0.0);  // of the turn in which a message came up
        player.fade_messages(seconds);
        player.advance(seconds, always);
    }
    const World& world() const { return player.session().world(); }

    Player player;
    Canvas window;
};

}  // namespace carom::test
