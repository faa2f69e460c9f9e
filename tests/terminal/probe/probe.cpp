/// A small program for the tests of the screen: it opens one, does as its arguments say, and tells
/// file descriptor 3 what it sees. Every write() of this process, ncurses' own included, passes
/// through here and is counted.
///
///     probe [option...] events          shows a mark, logs every event, ends with q, hangup or
///     end;
///                                       m switches the mouse off and to motion, b rings the bell
///     probe [option...] frames N        shows N frames of 200 moving discs, or of level=FILE, and
///                                       logs writes and bytes
///     probe [option...] crash SIGNAL    raises the signal with the screen open
///     probe [option...] stuck           fills the terminal until it takes no more, raises TERM,
///                                       and draws
///     probe [option...] capabilities    logs what the terminal can do
///     probe [option...] random N        shows N random pictures, logs the last cell by cell, waits
///     probe [option...] cells           shows cells of many colours and attributes, waits for a
///     key
///
/// Options: supervised, a renderer and level=FILE (of frames), colors=N, motion,
/// nopixels, noqueries.

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "level/load.h"
#include "terminal/draw/draw.h"
#include "terminal/process/supervisor.h"
#include "terminal/screen/screen.h"

namespace {
unsigned long terminal_writes = 0;
unsigned long terminal_bytes = 0;
}  // namespace

// Replaces the C library's write() in this program and the libraries that it loads.
extern "C" ssize_t write(int handle, const void* bytes, size_t length) {
    const ssize_t written = syscall(SYS_write, handle, bytes, length);
    // isatty() may change errno.
    const int error = errno;
    if (handle != 3 && isatty(handle) != 0) {
        ++terminal_writes;
        // A terminal that is full takes a part, and the rest comes again.
        if (written > 0) terminal_bytes += static_cast<unsigned long>(written);
    }
    errno = error;
    return written;
}

namespace {

using namespace carom;

void log(const std::string& line) {
    const std::string text = line + '\n';
    if (::write(3, text.data(), text.size()) < 0) std::abort();
}

std::string described(const InputEvent& event) {
    constexpr std::string_view actions[] = {"press", "repeat",   "release",
                                            "move",  "wheel_up", "wheel_down"};
    const std::string_view action = actions[static_cast<int>(event.action)];
    switch (event.kind) {
        case InputEvent::Kind::key: {
            const bool is_plain = event.key > U' ' && event.key < 0x7f;
            const std::string name = is_plain
                                         ? std::string(1, static_cast<char>(event.key))
                                         : fmt::format("{:x}", static_cast<unsigned>(event.key));
            return fmt::format("key {} {} {}", name, action, event.modifiers);
        }
        case InputEvent::Kind::mouse:
            return fmt::format("mouse {} {} {:.2f} {:.2f} {}", action, event.button, event.column,
                               event.row, event.modifiers);
        case InputEvent::Kind::resize:
            return "resize";
        case InputEvent::Kind::hangup:
            return "hangup";
        case InputEvent::Kind::end:
            return "end";
    }
    return {};
}

bool is_end(const InputEvent& event) {
    return event.kind == InputEvent::Kind::end || event.kind == InputEvent::Kind::hangup;
}

int echo_events(Screen& screen) {
    bool is_ready = false;
    for (unsigned events = 0;;) {
        const Capabilities& capabilities = screen.capabilities();
        Canvas canvas(capabilities.columns, capabilities.rows);
        canvas.write(0, 0, fmt::format("probe {}x{}", canvas.columns(), canvas.rows()));
        canvas.write(0, canvas.rows() - 1, fmt::format("events {}", events));
        screen.show(canvas, FrameEnd::asks);
        if (!std::exchange(is_ready, true)) log(fmt::format("ready {}", getpid()));
        for (const InputEvent& event : screen.wait(1.0)) {
            ++events;
            log(described(event));
            if (event.kind == InputEvent::Kind::key && event.key == U'm' &&
                event.action == InputEvent::Action::press) {
                const bool is_off = screen.mouse() == MouseMode::off;
                screen.set_mouse(is_off ? MouseMode::motion : MouseMode::off);
            }
            if (event.kind == InputEvent::Kind::key && event.key == U'b') screen.bell();
            if (is_end(event) || (event.kind == InputEvent::Kind::key && event.key == U'q'))
                return 7;
        }
    }
}

// 200 discs that bounce in a box, as in the table of what a frame may cost.
// Or a level from a file, drawn at 60 frames a second.
int show_frames(Screen& screen, int count, RendererChoice renderer, const std::string& level) {
    std::string text =
        "carom 1 \"Discs\"\n"
        "kind disc r=1\n"
        "box r=0 0,0 160,96\n"
        "fill disc count=200 box=2,2,158,94 speed=20\n"
        "rate 60\n";
    if (!level.empty()) {
        std::ifstream file(level);
        text.assign(std::istreambuf_iterator<char>(file), {});
    }
    const LoadResult loaded = load_level(text, "discs");
    const Capabilities& capabilities = screen.capabilities();
    Canvas canvas(capabilities.columns, capabilities.rows);
    if (!loaded.scene) {
        for (const Diagnostic& diagnostic : loaded.diagnostics) {
            log(diagnostic.message);
        }
        return 1;
    }
    World world = loaded.scene->world;
    const int ticks = level.empty() ? 1 : static_cast<int>(world.rate() / 60.0 + 0.5);
    Solver solver(
        {.kind = level.empty() ? SolverKind::discrete : pick_solver(world).settings.kind});
    if (!level.empty() && world.balls().velocity[0] == Vec2{}) {
        world.edit_balls().velocity[0] = {0.7 * size(loaded.scene->view).x, 0.01};
    }
    ViewOptions options;
    options.renderer = renderer;
    options.look = {capabilities.direct_color ? direct_colors : capabilities.colors,
                    capabilities.utf8, capabilities.light_background};
    ViewMemory memory;
    const Camera camera =
        fit_camera(level.empty() ? Box{{0, 0}, {160, 96}} : loaded.scene->view,
                   {0, 0, canvas.columns(), canvas.rows()}, capabilities.cell_aspect);
    unsigned asked = 0;
    unsigned long first_writes = 0;
    unsigned long first_bytes = 0;
    unsigned long most_writes = 0;
    for (int frame = 0; frame <= count; ++frame) {
        if (frame == 1) {
            first_writes = terminal_writes;
            first_bytes = terminal_bytes;
        }
        const unsigned long before = terminal_writes;
        draw_world(canvas, camera, *loaded.scene, world, {}, {}, options, memory);
        if (screen.show(canvas, FrameEnd::asks) > 0) ++asked;
        if (frame > 0) most_writes = std::max(most_writes, terminal_writes - before);
        for (int i = 0; i < ticks; ++i)
            solver.tick(world);
        // A terminal that is gone takes no frame, so nothing is asked of it: events come also then.
        do {
            const double seconds = screen.frames_answered() < asked ? 0.1 : 0.0;
            if (std::ranges::any_of(screen.wait(seconds), is_end)) return 7;
        } while (screen.frames_answered() < asked);
    }
    log(fmt::format("frames {} writes {} most {} bytes {}", count, terminal_writes - first_writes,
                    most_writes, (terminal_bytes - first_bytes) / static_cast<unsigned>(count)));
    return 0;
}

// Many random pictures, each differing in a few cells; then the last one, cell by cell.
int show_random(Screen& screen, int count) {
    const Capabilities& capabilities = screen.capabilities();
    Canvas canvas(capabilities.columns, capabilities.rows);
    std::uint64_t state = 42;
    const auto random = [&](int below) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<int>((state >> 33) % static_cast<std::uint64_t>(below));
    };
    constexpr std::u32string_view glyphs = U"     xo#.\u2588\u2580\u28ff";
    for (int frame = 0; frame < count; ++frame) {
        if (random(20) == 0) canvas.fill({});
        for (int change = random(60); change >= 0; --change) {
            Cell cell;
            cell.glyph = glyphs[static_cast<std::size_t>(random(static_cast<int>(glyphs.size())))];
            if (random(2) == 0) cell.foreground = static_cast<Color>(random(16) * 16);
            if (random(4) == 0) cell.background = static_cast<Color>(random(16) * 16);
            if (random(6) == 0) cell.attributes = static_cast<std::uint8_t>(random(16));
            const int column = random(canvas.columns());
            const int row = random(canvas.rows());
            for (int i = random(6); i >= 0; --i) {
                canvas.put(column + i, row, cell);
            }
        }
        if (random(50) == 0) screen.redraw();
        screen.show(canvas);
        if (std::ranges::any_of(screen.wait(0.0), is_end)) return 7;
    }
    for (int row = 0; row < canvas.rows(); ++row) {
        for (int column = 0; column < canvas.columns(); ++column) {
            const Cell& cell = canvas.at(column, row);
            log(fmt::format("cell {} {} {:x} {} {} {}", column, row,
                            static_cast<unsigned>(cell.glyph), cell.foreground, cell.background,
                            cell.attributes));
        }
    }
    log("shown");
    screen.wait(-1.0);
    return 0;
}

int show_cells(Screen& screen) {
    const Capabilities& capabilities = screen.capabilities();
    Canvas canvas(capabilities.columns, capabilities.rows);
    for (int color = 0; color < 256; ++color) {
        canvas.put(color % 64, color / 64,
                   {.glyph = U'x', .foreground = static_cast<Color>(color)});
        canvas.put(color % 64, 4 + color / 64,
                   {.glyph = U'y', .background = static_cast<Color>(color)});
    }
    canvas.put(0, 9, {.glyph = U'\u2580', .foreground = 1, .background = 4});
    canvas.put(1, 9, {.glyph = U'b', .attributes = bold});
    canvas.put(2, 9, {.glyph = U'u', .attributes = underline});
    canvas.put(3, 9, {.glyph = U'r', .attributes = reverse});
    const Color orange = direct_color({250, 130, 5});
    canvas.put(4, 9, {.glyph = U'd', .foreground = orange, .background = 4});
    canvas.put(5, 9, {.glyph = U'\U0001CD00', .foreground = 2, .background = orange});
    canvas.put(6, 9, {.glyph = U'x'});
    canvas.put(canvas.columns() - 1, canvas.rows() - 1, {.glyph = U'#'});
    screen.show(canvas);
    log("shown");
    screen.wait(-1.0);
    return 0;
}

// The signal comes before the write that the terminal does not take.
int draw_when_stuck(Screen& screen) {
    const int terminal = ::open(ttyname(STDOUT_FILENO), O_WRONLY | O_NONBLOCK | O_NOCTTY);
    const std::string blanks(4096, ' ');
    while (::write(terminal, blanks.data(), blanks.size()) > 0) {
    }
    ::close(terminal);
    log("stuck");
    std::raise(SIGTERM);
    Canvas canvas(screen.capabilities().columns, screen.capabilities().rows);
    canvas.write(0, 0, "drawn");
    screen.redraw();
    screen.show(canvas);
    return std::ranges::any_of(screen.wait(1.0), is_end) ? 7 : 1;
}

struct Arguments {
    ScreenOptions screen;
    RendererChoice renderer = &ascii_renderer();
    bool is_supervised = false;
    std::string level;
    std::vector<std::string_view> words;
};

Arguments parsed(int count, char** values) {
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string_view word = values[i];
        if (word == "supervised") {
            arguments.is_supervised = true;
        } else if (renderer_choice(word)) {
            arguments.renderer = *renderer_choice(word);
        } else if (word == "motion") {
            arguments.screen.mouse = MouseMode::motion;
        } else if (word == "nopixels") {
            arguments.screen.mouse_pixels = false;
        } else if (word == "noqueries") {
            arguments.screen.queries = false;
        } else if (word.starts_with("level=")) {
            arguments.level = word.substr(6);
        } else if (word.starts_with("colors=")) {
            arguments.screen.colors = std::atoi(values[i] + 7);
        } else {
            arguments.words.push_back(word);
        }
    }
    return arguments;
}

int run(const Arguments& arguments) {
    auto opened = Screen::open(arguments.screen);
    if (const auto* const error = std::get_if<ScreenError>(&opened)) {
        log(error->message);
        return 2;
    }
    Screen screen = std::get<Screen>(std::move(opened));
    const std::string_view what = arguments.words.empty() ? "events" : arguments.words[0];
    const int number = arguments.words.size() > 1 ? std::atoi(arguments.words[1].data()) : 0;
    if (what == "events") return echo_events(screen);
    if (what == "frames") return show_frames(screen, number, arguments.renderer, arguments.level);
    if (what == "random") return show_random(screen, number);
    if (what == "cells") return show_cells(screen);
    if (what == "stuck") return draw_when_stuck(screen);
    if (what == "crash") {
        Canvas canvas(screen.capabilities().columns, screen.capabilities().rows);
        canvas.write(0, 0, "about to crash");
        screen.show(canvas);
        std::raise(number);
        return 0;
    }
    const Capabilities& c = screen.capabilities();
    log(
        fmt::format("size {}x{} colors {} utf8 {:d} aspect {:.2f} light {:d} release {:d} "
                    "pixels {:d} answers {:d} ssh {:d}",
                    c.columns, c.rows, c.colors, c.utf8, c.cell_aspect, c.light_background,
                    c.key_release, c.mouse_pixels, c.answers, c.ssh));
    return 0;
}

}  // namespace

int main(int count, char** values) {
    const Arguments arguments = parsed(count, values);
    if (!arguments.is_supervised) return run(arguments);
    return run_supervised([&] { return run(arguments); }, "Go on with: probe");
}
