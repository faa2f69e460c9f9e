#include "carom/play/play.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "carom/files/guest.h"
#include "carom/files/level_files.h"
#include "carom/files/output_clash.h"
#include "carom/files/print.h"
#include "carom/play/asciinema.h"
#include "carom/play/play_loop.h"
#include "carom/play/program.h"
#include "terminal/process/supervisor.h"
#include "terminal/screen/pacing.h"
#include "terminal/screen/screen.h"

namespace carom {
namespace {

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
        case ColorChoice::direct:
            return direct_colors;
        default:
            return std::nullopt;
    }
}

/// The title of an asciinema recording: what is played, without folders.
std::string title_of(const PlayOptions& options) {
    const auto name = [](const std::string& path) {
        return std::filesystem::path(path).filename().string();
    };
    if (!options.replay.empty()) return "carom replay " + name(options.replay);
    return options.level.empty() ? "carom" : "carom play " + name(options.level);
}

std::optional<std::string> clash_in(const PlayOptions& options) {
    const std::array<std::string, 2> outputs{options.record, options.cast};
    const std::array<std::string, 2> inputs{find_level(options.level).path.value_or(""),
                                            options.replay};
    return clash_of_outputs(outputs, inputs);
}

int play_here(const PlayOptions& options) {
    if (const auto why = clash_in(options)) {
        print_error(*why);
        return 2;
    }
    PreferencesText preferences = load_preferences();
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
        print_problems(*problems);
        return 2;
    }
    std::optional<AsciinemaRecording> asciinema;
    if (!options.cast.empty()) {
        const char* const terminal = std::getenv("TERM");
        asciinema.emplace(options.cast, title_of(options), terminal ? terminal : "");
        if (const auto obstacle = asciinema->obstacle()) {
            print_error(*obstacle);
            return 2;
        }
    }
    screen_options.mouse = mouse_mode(program.screen_requests());
    auto opened = Screen::open(screen_options);
    if (const auto* error = std::get_if<ScreenError>(&opened)) {
        print_error(error->message);
        return 2;
    }
    bool was_idle = false;
    {
        Screen screen = std::move(std::get<Screen>(opened));
        PlayLoop loop(program, screen, pacing, asciinema ? &*asciinema : nullptr);
        if (options.guest) loop.end_when_idle(options.guest->idle);
        loop.run();
        was_idle = loop.was_idle();
    }
    if (was_idle)
        print_note(
            fmt::format("carom: ended after {:g} s without a key; an unfinished game is kept\n",
                        options.guest->idle));
    const auto lost_asciinema = asciinema ? asciinema->finish(seconds_now()) : std::nullopt;
    if (program.is_kept() && !options.guest)
        print_note("The game was kept. Resume it: carom play --resume\n");
    for (const auto& lost : {program.lost_recording(), lost_asciinema})
        if (lost) print_error(*lost);
    return program.lost_recording() || lost_asciinema ? 2 : 0;
}

int play_as_guest(const PlayOptions& options) {
    const auto session = become_guest(*options.guest);
    if (std::holds_alternative<FileLock>(session)) return play_here(options);
    print_error(std::get<std::string>(session));
    return 2;
}

}  // namespace

int play(const PlayOptions& options) {
    if (options.guest)
        return run_supervised([&] { return play_as_guest(options); },
                              "the game was kept: the menu lists it");
    return run_supervised([&] { return play_here(options); },
                          "the game was kept: carom play --resume resumes it");
}

}  // namespace carom
