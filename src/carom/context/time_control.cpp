#include "carom/context/time_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace carom {
namespace {

void prepare(PlayContext& play) {
    if (!is_watching(play)) play.pointer.tool.prepare(play.session);
}

void go_to(PlayContext& play, std::uint64_t tick) {
    play.pointer.tool.forget();
    play.session.go_to(tick);
    play.observation->begin(play.session);
    play.companion.follow_closely(play.session, play.keep_going);
    if (play.session.world().tick() < play.reference.tick()) set_reference(play);
}

PlayPurpose purpose_of(const Scene& scene) {
    if (scene.table.is_game || scene.pool.cue) return PlayPurpose::game;
    return scene.expects.empty() ? PlayPurpose::free_play : PlayPurpose::experiment;
}

// Play shows every kind of note that a run has and that its purpose has a use for.
void tell_outcome(PlayContext& play) {
    const TickNotes before = std::exchange(
        play.notes, notes_of_tick(play.session.world(), play.session.solver().kind,
                                  play.session.standing(), rule_state(play.session.game())));
    // A note is no error: the solver has kept its promises. One that lasts leaves room for other
    // messages.
    if (const auto note = play_note(before, play.notes, purpose_of(play.session.scene())))
        if (note->has_begun || !play.messages.line()) say(play, note->text);
}

/// Computes one tick; false at the end of a recording.
bool step(PlayContext& play) {
    play.companion.follow_closely(play.session, play.keep_going);
    const bool is_done = play.session.step_forward();
    play.companion.follow_closely(play.session, play.keep_going);
    if (play.session.is_at_end() && !is_done) say(play, "The recording ends here.");
    if (play.session.outcome() == TickOutcome::cancelled)
        complain(play, "The tick took too long and was cancelled.");
    tell_outcome(play);
    return is_done;
}

std::uint64_t ticks_in_a_second(const PlayContext& play) {
    return static_cast<std::uint64_t>(std::max(1.0, play.session.world().rate()));
}

void say_speed(PlayContext& play) {
    say(play, fmt::format("speed x{:g}", play.clock.speed()));
}

// "ball 3 hits edge 5 at 1.234 s", marked where the two touch.
void tell_collision(PlayContext& play, const Contact& contact) {
    const std::string other = contact.kind == ContactKind::ball_ball
                                  ? name_of(play, BallId{contact.b})
                                  : fmt::format("edge {}", contact.b);
    say(play,
        fmt::format("{} hits {} at {:.3f} s", name_of(play, BallId{contact.a}), other,
                    contact.time),
        contact.point);
}

void tell_end_of_search(PlayContext& play) {
    if (play.clock.found())
        tell_collision(play, *play.clock.found());
    else if (play.session.is_at_end())
        say(play, "No more collisions: the recording ends here.");
    else if (play.clock.search_failed())
        complain(play, "No collision within ten simulated minutes.");
    play.needs_draw = true;
}

// Whether a picture of the next tick shows the same: at a table with a cue all balls rest, and
// nothing fades. Clocks show whole seconds.
bool is_still(const PlayContext& play) {
    const PlayKind kind = play.controller->kind();
    if (kind != PlayKind::pool && kind != PlayKind::cue) return false;
    const World& world = play.session.world();
    return is_at_rest(world) && world.movers().empty() && play.view.memory.flashes.empty() &&
           !play.view.options.trails;
}

std::uint64_t second_of(const PlayContext& play) {
    return play.session.world().tick() / ticks_in_a_second(play);
}

}  // namespace

void toggle_pause(PlayContext& play) {
    play.clock.pause(!play.clock.is_paused() || play.clock.is_seeking());
}

void step_forward(PlayContext& play) {
    play.clock.pause(true);
    prepare(play);
    step(play);
}

void step_back(PlayContext& play) {
    play.clock.pause(true);
    const std::uint64_t now = play.session.world().tick();
    if (now > play.session.earliest()) return go_to(play, now - 1);
    say(play, play.session.earliest() == 0 ? "This is the start." : "No memory further back.");
}

void seek_collision(PlayContext& play) {
    prepare(play);
    play.clock.seek_collision();
}

void second_forward(PlayContext& play) {
    prepare(play);
    const std::uint64_t ticks = ticks_in_a_second(play);
    for (std::uint64_t tick = 0; tick < ticks && step(play); ++tick) {
    }
}

void second_back(PlayContext& play) {
    const std::uint64_t now = play.session.world().tick();
    const std::uint64_t earliest = play.session.earliest();
    const std::uint64_t ticks = ticks_in_a_second(play);
    go_to(play, now - earliest > ticks ? now - ticks : earliest);
}

void slower(PlayContext& play) {
    play.clock.slower();
    say_speed(play);
}

void faster(PlayContext& play) {
    play.clock.faster();
    say_speed(play);
}

void normal_speed(PlayContext& play) {
    play.clock.normal();
    say(play, "normal speed");
}

void restart(PlayContext& play) {
    if (is_watching(play)) {
        go_to(play, 0);
    } else {
        play.pointer.tool.forget();
        play.session.restart();
        play.observation->begin(play.session);
    }
    set_reference(play);
    play.panels.clear();
    say(play, "Restarted.");
}

void advance_time(PlayContext& play, double seconds, const MayGoOn& may_go_on) {
    if (!keep_up(play, may_go_on) || is_idle(play)) return;
    const bool was_seeking = play.clock.is_seeking();
    const bool was_at_end = play.session.is_at_end();
    Controller& controller = *play.controller;
    prepare(play);
    keep_up(play, may_go_on);
    controller.before_tick(play);
    const auto both_may_go_on = [&] {
        controller.before_tick(play);
        return keep_up(play, may_go_on) && may_go_on();
    };
    const bool was_still = is_still(play);
    const std::uint64_t second = second_of(play);
    const bool has_advanced = play.clock.advance(play.session, seconds, both_may_go_on) > 0;
    const bool looks_the_same = was_still && is_still(play) && second_of(play) == second;
    if (has_advanced && !looks_the_same) play.needs_draw = true;
    keep_up(play, may_go_on);
    tell_outcome(play);
    controller.after_ticks(play, seconds);
    if (was_seeking && !play.clock.is_seeking()) tell_end_of_search(play);
    if (play.session.is_at_end() && !was_at_end && !was_seeking)
        say(play, "The recording ends here.");
}

}  // namespace carom
