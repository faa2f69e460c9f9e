#include "carom/play.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <utility>
#include <vector>

#include "carom/cast.h"
#include "carom/files.h"
#include "carom/print.h"
#include "carom/program.h"
#include "terminal/guardian.h"
#include "terminal/pacing.h"
#include "terminal/screen.h"

namespace carom {
namespace {

/// Share of the time between two frames that ticks may take; the rest is for drawing and input.
constexpr double share_of_ticks = 0.75;
/// Time that passed while nobody could see it (a stopped process, a busy machine) does not count
/// beyond this, s.
constexpr double longest_gap = 0.25;
/// With nothing to do, so long, s.
constexpr double longest_wait = 60.0;
/// How often a long tick is interrupted to look for input, s.
constexpr double look_interval = 0.01;

double seconds_now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

std::optional<int> colors_of(std::optional<ColorChoice> choice) {
    switch (choice.value_or(ColorChoice::automatic)) {
        case ColorChoice::mono:
            return 0;
        case ColorChoice::c8:
            return 8;
        case ColorChoice::c16:
            return 16;
        case ColorChoice::c256:
            return 256;
        default:
            return std::nullopt;
    }
}

MouseMode mouse_mode(const ScreenWishes& wishes) {
    if (!wishes.mouse) return MouseMode::off;
    return wishes.motion ? MouseMode::motion : MouseMode::drag;
}

PreferencesText preferences_of_user() {
    const auto path = preferences_path();
    if (!path) return {};
    return read_preferences(read_file(*path).text.value_or(""), *path);
}

/// Of a film: what is played, without the folders, which are the player's own.
std::string title_of(const PlayOptions& options) {
    const auto name = [](const std::string& path) {
        return std::filesystem::path(path).filename().string();
    };
    if (!options.replay.empty()) return "carom replay " + name(options.replay);
    return options.level.empty() ? "carom" : "carom play " + name(options.level);
}

/// Looks for input while a tick is computed, and keeps what came for when the tick is over or given
/// up.
class LookOut {
  public:
    LookOut(const Program& program, Screen& screen) : program_(program), screen_(screen) {}

    /// Whether the tick may go on.
    bool sees_nothing() {
        const double now = seconds_now();
        if (now >= next_look_) {
            next_look_ = now + look_interval;
            for (const InputEvent& event : screen_.wait(0.0)) {
                ends_tick_ = ends_tick_ || program_.ends_tick(event);
                seen_.push_back(event);
            }
        }
        return !ends_tick_;
    }
    std::vector<InputEvent> take() {
        ends_tick_ = false;
        return std::exchange(seen_, {});
    }

  private:
    const Program& program_;
    Screen& screen_;
    double next_look_ = 0.0;
    bool ends_tick_ = false;
    std::vector<InputEvent> seen_;
};

/// The loop: input, time, picture, and again. Returns when the program is over.
void run(Program& program, Screen& screen, const PacingOptions& pacing_options, Cast* cast) {
    Pacing pacing(pacing_options);
    const double frame = 1.0 / pacing_options.frames_per_second;
    LookOut look_out(program, screen);
    program.set_keep_going([&look_out] { return look_out.sees_nothing(); });
    program.set_capabilities(screen.capabilities());
    double last = seconds_now();
    bool input_came = true;
    bool ticks_are_long = false;  // longer than frames, now
    while (!program.is_over()) {
        const double now = seconds_now();
        const double deadline = now + share_of_ticks * frame;
        // A player who sees nothing does not lose the game for it.
        const bool is_stalled = pacing.is_stalled(now);
        const double passed = is_stalled ? 0.0 : std::min(now - last, longest_gap);
        last = now;
        // Where the next tick may take long, what a key has done is shown before it.
        const bool is_answer = input_came && std::exchange(ticks_are_long, false);
        if (!is_answer) {
            program.advance(passed, now, [&] { return seconds_now() < deadline; });
            ticks_are_long = seconds_now() - now > frame;
        }
        std::vector<InputEvent> events = look_out.take();

        bool is_late = false;
        if (program.needs_draw() || is_stalled) {
            const double drawing = seconds_now();
            is_late = !pacing.may_draw(drawing, input_came);
            if (!is_late) {
                if (is_stalled) screen.redraw();  // so that there is something to answer
                Canvas canvas(screen.capabilities().columns, screen.capabilities().rows);
                program.draw(canvas);
                const std::size_t bytes = screen.show(canvas, FrameEnd::asks);
                if (bytes > 0) pacing.drawn(drawing, bytes);
                if (bytes > 0 && cast)
                    cast->add(drawing, canvas.columns(), canvas.rows(), screen.last_frame());
                input_came = false;
            }
        }
        screen.set_mouse(mouse_mode(program.screen_wishes()));

        const double before_wait = seconds_now();
        double wait = program.seconds_to_change(before_wait);
        if (wait < frame || is_late) wait = std::max(pacing.seconds_to_frame(before_wait), 0.001);
        if (!events.empty()) wait = 0.0;
        std::ranges::copy(screen.wait(std::min(wait, longest_wait)), std::back_inserter(events));
        pacing.answered(screen.frames_answered(), seconds_now());
        // What is done for one may take long, and more may come meanwhile.
        for (; !events.empty() && !program.is_over(); events = look_out.take()) {
            for (const InputEvent& event : events) {
                input_came = true;
                if (event.kind == InputEvent::Kind::resize)
                    program.set_capabilities(screen.capabilities());
                else
                    program.handle(event, seconds_now());
                if (program.is_over()) break;
            }
        }
    }
    program.set_keep_going({});
}

int play_here(const PlayOptions& options) {
    PreferencesText preferences = preferences_of_user();
    ScreenOptions screen_options;
    screen_options.colors =
        colors_of(options.colors ? options.colors : preferences.preferences.colors);
    screen_options.light_background = preferences.preferences.light_background;
    PacingOptions pacing;
    if (options.low_bandwidth) pacing = low_bandwidth_pacing;
    if (const auto fps = options.fps ? options.fps : preferences.preferences.fps)
        pacing.frames_per_second = *fps;

    Program program(options, std::move(preferences));
    if (const auto problems = program.start()) {
        std::string text;
        for (const std::string& line : *problems)
            text += line + "\n";
        print_note(text);
        return 2;
    }
    std::optional<Cast> cast;
    if (!options.cast.empty()) {
        const char* const terminal = std::getenv("TERM");
        cast.emplace(options.cast, title_of(options), terminal ? terminal : "");
        if (const auto obstacle = cast->obstacle()) {
            print_error(*obstacle);
            return 2;
        }
    }
    screen_options.mouse = mouse_mode(program.screen_wishes());
    auto opened = Screen::open(screen_options);
    if (const auto* error = std::get_if<ScreenError>(&opened)) {
        print_error(error->message);
        return 2;
    }
    {
        Screen screen = std::move(std::get<Screen>(opened));
        run(program, screen, pacing, cast ? &*cast : nullptr);
    }
    const auto lost_cast = cast ? cast->finish(seconds_now()) : std::nullopt;
    for (const auto& lost : {program.lost_recording(), lost_cast})
        if (lost) print_error(*lost);
    return program.lost_recording() || lost_cast ? 2 : 0;
}

}  // namespace

int play(const PlayOptions& options) {
    return run_guarded([&] { return play_here(options); },
                       "the game was kept: carom play --resume takes it up where it stood");
}

}  // namespace carom
