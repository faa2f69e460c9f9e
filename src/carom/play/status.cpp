#include "carom/play/status.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "carom/context/solver_choice.h"
#include "carom/pool/pool_status.h"
#include "game/session/conserved.h"
#include "lab/run/judge.h"
#include "lab/run/report.h"
#include "physics/event/motion/event_memory.h"
#include "physics/tick/totals.h"

namespace carom {
namespace {

std::string mode_of(const PlayContext& play) {
    std::string mode;
    const auto add = [&mode](std::string_view text) {
        mode += (mode.empty() ? "" : ", ") + std::string(text);
    };
    if (play.clock.is_seeking()) add("seeking a collision");
    if (play.clock.is_behind() && !play.clock.is_paused()) add("slower than real time");
    if (play.terminal.mouse_is_off) add("mouse off");
    if (play.view.follows && play.view.selected)
        add(fmt::format("following {}", number(*play.view.selected)));
    return mode;
}

/// Collects hints by action name; an action without a key gives none.
struct Hints {
    const KeyMap& keys;
    std::vector<KeyHelp> lines;

    /// A key that has a hint already does something else now.
    void add(std::string_view action_name, std::string_view what, bool stays = false) {
        const std::string key = keys.hint(action_name);
        const bool has_hint = std::ranges::count(lines, key, &KeyHelp::keys) > 0;
        if (!key.empty() && !has_hint) lines.push_back({key, std::string(what), stays});
    }
};

/// The actions for the held object, else those for time.
void add_first_hints(const PlayContext& play, Hints& hints) {
    const PointerTool& tool = play.pointer.tool;
    const bool is_paused = play.clock.is_paused();
    if (tool.has_cue()) {
        if (!hints.lines.empty()) return;  // a pull at a pool table
        hints.add("grab", "shoot");
        hints.add("menu", "cancel");
    } else if (tool.has_new_edge()) {
        hints.add("draw-edge", "make the edge");
        hints.add("faster", "wider");
        hints.add("slower", "thinner");
        hints.add("menu", "cancel");
    } else if (!tool.is_empty()) {
        if (hints.lines.empty()) hints.add("grab", "release");
        hints.add("pause", is_paused ? "resume" : "pause");
    } else if (is_paused) {
        hints.add("pause", "resume");
        if (play.controller->kind() == PlayKind::pinball) return;  // keys of the table
        hints.add("step-forward", "step");
        hints.add("step-back", "step back");
        hints.add("next-collision", "next collision");
    } else {
        hints.add("pause", "pause");
    }
}

// At a table, also in a recording of one.
bool is_game(const PlayContext& play) {
    const PlayKind kind = play.controller->kind();
    const Scene& scene = play.session.scene();
    return kind == PlayKind::pool || kind == PlayKind::cue || kind == PlayKind::pinball ||
           (kind == PlayKind::watching && (scene.pool.cue || scene.table.is_game));
}

std::vector<KeyHelp> hints_of(const PlayContext& play) {
    Hints hints{play.keys, {}};
    const bool has_empty_hand = play.pointer.tool.is_empty();
    const bool watches = is_watching(play);
    play.controller->add_hints(play, hints.lines);
    if (play.controller->has_all_hints()) return std::move(hints.lines);
    add_first_hints(play, hints);
    if (has_empty_hand && (play.pointer.shows_cursor || play.view.selected) && !watches) {
        hints.add("grab", "grab");
        hints.add("cue", "cue");
        hints.add("remove", "remove");
    }
    hints.add("help", "keys", true);
    hints.add("about", "about");
    if (!has_empty_hand) return std::move(hints.lines);
    hints.add("menu", "menu");
    if (play.session.latest() > 0) hints.add("restart", "restart");
    if (!play.terminal.mouse_is_off && !play.pointer.shows_cursor &&
        play.controller->drags_anything()) {
        hints.lines.push_back({"drag", "move"});
        hints.lines.push_back({"right drag", "shoot"});
    }
    hints.add("renderer", "renderer");
    hints.add("quit", "quit");
    if (!watches && !is_game(play)) hints.add("solver", "solver");
    return std::move(hints.lines);
}

/// The level's expectations, in the order of its file, with the values known so far.
std::vector<HudCheck> checks_of(const PlayContext& play) {
    std::vector<HudCheck> checks;
    const Scene& scene = play.session.scene();
    if (scene.overridden) return checks;
    for (const Expect& expect : scene.expects) {
        const bool is_observed = expect.what.kind->observable.has_value();
        if (expect.what.kind->scope == QuantityScope::run && !is_observed) continue;
        // The histogram panel shows these.
        if (is_of_bins(expect.what.kind) && play.panels.is_histogram_drawn()) continue;
        const Observer* observer = play.observation->observer();
        const auto measured = is_observed && observer
                                  ? observer->value(expect.what, play.session.world())
                                  : measure(expect.what, play.session.world(), nullptr);
        if (measured)
            checks.push_back({.quantity = expect.quantity,
                              .relation = expect.relation == Expect::Relation::within
                                              ? "of"
                                              : sign(expect.relation),
                              .measured = *measured,
                              .value = expect.value,
                              .is_exact = expect.tolerance == 0.0,
                              .holds = holds(expect, *measured)});
    }
    return checks;
}

void add_sums(const PlayContext& play, HudInfo& info) {
    const World& world = play.session.world();
    const Totals sums = totals(world);
    info.kinetic_energy = sums.kinetic_energy;
    if (world.model().gravity) info.potential_energy = sums.potential_energy;
    info.momentum = sums.momentum;
    if (conserves_energy(world)) info.energy_drift = play.reference.energy_drift(sums);
    if (conserves_momentum(world)) info.momentum_drift = play.reference.momentum_drift(sums);
}

void add_time(const PlayContext& play, HudInfo& info) {
    const World& world = play.session.world();
    info.time = world.time();
    info.tick = world.tick();
    info.latest_tick = play.session.latest();
    info.ticks_per_second = play.clock.is_paused() ? 0.0 : play.clock.ticks_per_second();
    info.rate = world.rate();
    info.speed = play.clock.speed();
    info.is_paused = is_idle(play);
}

void add_world(const PlayContext& play, HudInfo& info) {
    const World& world = play.session.world();
    info.terms = terms_in_force(world.model());
    info.balls = world.balls().size();
    info.clustered = event_memory(world).clustered.size();
    info.collisions = world.ledger().ball_ball_collisions + world.ledger().ball_edge_collisions;
    info.checks = checks_of(play);
}

}  // namespace

HudInfo status_of(const PlayContext& play) {
    HudInfo info;
    info.title = play.session.scene().title;
    info.goal = task_text(play.session.scene(), play.session.world(), play.session.game());
    // At a table of shots the title says how far the task is (pool/pool_status.h).
    if (info.goal.empty() || shots_of(play.session)) info.goal = play.words.goal;
    info.is_game = is_game(play);
    info.solver = solver_text(play.session.solver());
    info.solver_is_picked = play.solver_is_picked;
    if (play.solver_is_picked) info.reason = pick_solver(play.session.scene().world).reason;
    info.beside = play.companion.text();
    info.mode = mode_of(play);
    add_time(play, info);
    add_world(play, info);
    add_sums(play, info);
    if (const auto line = play.messages.line()) {
        info.message = line->text;
        info.message_is_error = line->is_error;
        info.message_more = play.keys.hint("about") + ": all of it";
    }
    play.controller->add_status(play, info);
    info.hints = hints_of(play);
    return info;
}

}  // namespace carom
