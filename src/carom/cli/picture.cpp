#include "carom/cli/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "carom/files/files.h"
#include "carom/files/high_scores.h"
#include "carom/files/level_source.h"
#include "carom/files/output_clash.h"
#include "carom/files/print.h"
#include "carom/play/player.h"
#include "carom/pool/pool_status.h"
#include "terminal/canvas/own_ground.h"
#include "terminal/screen/picture_text.h"

namespace carom {
namespace {

constexpr double cell_aspect = 2.0;
// Pictures remember what happened in this time before them: trails, flashes, curves, messages.
constexpr double filmed = 3.0;  // s
constexpr double frame = 1.0 / 60.0;

Look look_of(const PictureOptions& options) {
    Look look;
    look.mosaic = Mosaic::octants;
    look.theme = options.theme.name;
    look.light_background = options.theme.is_light.value_or(false);
    switch (options.colors) {
        case ColorChoice::automatic:
        case ColorChoice::direct:
            look.colors = direct_colors;
            break;
        case ColorChoice::c256:
            look.colors = 256;
            break;
        case ColorChoice::c16:
            look.colors = 16;
            break;
        case ColorChoice::c8:
            look.colors = 8;
            break;
        case ColorChoice::mono:
            look.colors = 0;
            break;
    }
    // Text has no colours to tell things apart by.
    if (options.format == PictureFormat::text) look.colors = 0;
    return look;
}

// Lets the game go on to a tick, seen at 60 frames a second.
void film(Player& player, Canvas& canvas, std::uint64_t end) {
    player.draw(canvas, cell_aspect);
    const auto frames = static_cast<int>(4.0 * filmed / frame);
    for (int i = 0; i < frames && player.session().world().tick() < end; ++i) {
        const double left = static_cast<double>(end - player.session().world().tick());
        player.advance(std::min(frame, left / player.session().world().rate()),
                       [] { return true; });
        player.fade_messages(frame);
        player.draw(canvas, cell_aspect);
    }
}

std::string text_of(const Canvas& canvas, const PictureOptions& options, const Look& look) {
    switch (options.format) {
        case PictureFormat::svg: {
            // A picture without colours is black and white.
            Look shown = look;
            if (!shown.has_colors()) shown.colors = 256;
            return svg_of(canvas, shown);
        }
        case PictureFormat::ansi:
            return ansi_of(canvas);
        case PictureFormat::text:
            break;
    }
    return canvas.text();
}

}  // namespace

int picture(const PictureOptions& options) {
    auto opened = open_game({options.level, options.solver, options.rate, options.seed,
                             options.overrides, Session::default_rewind_bytes});
    if (const auto* problems = std::get_if<Problems>(&opened)) {
        print_problems(*problems);
        return 2;
    }
    OpenedGame& game = std::get<OpenedGame>(opened);
    if (const auto why = clash_of_outputs({&options.output, 1}, game.session.scene().files)) {
        print_error(*why);
        return 2;
    }
    for (const std::string& warning : game.warnings)
        print_note(warning + "\n");
    const double rate = game.session.world().rate();
    const auto ticks_in = [&](double seconds) {
        return static_cast<std::uint64_t>(std::llround(seconds * rate));
    };
    // A game by a level's own rules begins in its first tick; a player sees nothing before that.
    const std::uint64_t begin = shots_of(game.session) ? 1 : 0;
    const std::uint64_t end = std::max(begin, ticks_in(options.time));
    if (!options.demo)
        while (game.session.world().tick() + ticks_in(filmed) < end)
            if (!game.session.step_forward()) break;
    ViewOptions view;
    view.renderer = options.renderer;
    view.look = look_of(options);
    if (!view.renderer && options.format == PictureFormat::text) {
        view.renderer = &ascii_renderer();
        view.look.utf8 = false;
    }
    Player player(std::move(game.session), view, KeyMap(), game.solver_is_picked);
    // What a user without scores would see.
    const PinballTable& table = player.session().scene().table;
    if (table.is_game)
        player.set_high_scores(
            with_house_scores({.lines = {}, .most = table.highscores}, table.replay));
    Canvas canvas(options.columns, options.rows);
    if (options.demo) {
        player.demonstrate();
        while (player.session().world().tick() + ticks_in(filmed) < end) {
            const std::uint64_t before = player.session().world().tick();
            player.advance(frame, [] { return true; });
            if (player.session().world().tick() == before && rate * frame >= 1.0) break;
        }
    }
    film(player, canvas, end);
    if (options.theme.is_light) paint_own_ground(canvas, view.look);
    if (const auto error =
            write_file_atomically(options.output, text_of(canvas, options, view.look))) {
        print_error(*error);
        return 2;
    }
    return 0;
}

}  // namespace carom
