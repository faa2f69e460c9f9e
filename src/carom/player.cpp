#include "carom/player.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/totals.h"
#include "terminal/pages.h"

namespace carom {
namespace {

/// How long a message stands, s.
constexpr double message_time = 4.0;

SolverSettings after(const SolverSettings& current, const std::optional<SolverSettings>& of_level) {
    const auto all = solvers_available();
    auto place = std::ranges::find(all, current.kind);
    const SolverKind next = place == all.end() || ++place == all.end() ? all.front() : *place;
    if (of_level && of_level->kind == next) return *of_level;
    SolverSettings settings;
    settings.kind = next;
    return settings;
}

/// Gravity for a scene that has none: a fall through the view takes about a second and a half.
Vec2 gentle_gravity(const Scene& scene) {
    if (scene.unit != LengthUnit::natural && size(scene.view).y > 1.0) return {0.0, -9.81};
    return {0.0, -size(scene.view).y};
}

}  // namespace

std::string solver_text(const SolverSettings& settings) {
    const std::string name_text{name(settings.kind)};
    if (settings.kind == SolverKind::substep)
        return fmt::format("{} {}x{}", name_text, settings.updates, settings.steps);
    if (settings.kind == SolverKind::swept && settings.substeps > 1)
        return fmt::format("{} {}", name_text, settings.substeps);
    return name_text;
}

Player::Player(Session session, const ViewOptions& view, KeyMap keys, bool solver_is_picked)
    : session_(std::move(session)),
      keys_(std::move(keys)),
      view_(view),
      solver_is_picked_(solver_is_picked),
      pointer_(center(session_.scene().view)) {
    for (const Show& show : session_.scene().shows) {
        shows_histogram_ = shows_histogram_ || show.what == Show::What::histogram;
        shows_energy_ = shows_energy_ || show.what == Show::What::energy;
    }
    set_reference();
}

Player Player::continued_with(Session session, bool solver_is_picked) const {
    Player next(std::move(session), view_, keys_, solver_is_picked);
    next.clockwork_ = clockwork_;
    next.mouse_is_off_ = mouse_is_off_;
    next.shows_cursor_ = shows_cursor_;
    if (next.session_.scene().view == session_.scene().view) {
        next.camera_ = camera_;
        next.is_fitted_ = is_fitted_;
        next.pointer_ = pointer_;
    }
    return next;
}

void Player::say(std::string message) {
    message_ = std::move(message);
    message_is_error_ = false;
    message_seconds_ = message_time;
    needs_draw_ = true;
}

void Player::complain(std::string message) {
    say(std::move(message));
    message_is_error_ = true;
}

void Player::set_problem(std::optional<std::string> problem) {
    problem_ = std::move(problem);
    needs_draw_ = true;
}

void Player::set_view(const ViewOptions& view) {
    view_ = view;
    needs_draw_ = true;
}

void Player::pause(bool paused) {
    clockwork_.pause(paused);
    needs_draw_ = true;
}

double Player::seconds_to_change() const {
    if (!stands_still() && !is_too_small_ && !shows_help_) return 0.0;
    return message_seconds_ > 0.0 ? message_seconds_ : std::numeric_limits<double>::infinity();
}

void Player::advance(double seconds, const MayGoOn& may_go_on) {
    if (message_seconds_ > 0.0) {
        message_seconds_ -= seconds;
        needs_draw_ = needs_draw_ || message_seconds_ <= 0.0;
    }
    if (is_too_small_ || shows_help_) return;
    if (stands_still()) return;
    const bool was_seeking = clockwork_.is_seeking();
    hand_.prepare(session_);
    if (clockwork_.advance(session_, seconds, may_go_on) > 0) needs_draw_ = true;
    if (was_seeking && !clockwork_.is_seeking()) {
        if (clockwork_.search_failed()) complain("nothing met for ten minutes of the level's time");
        needs_draw_ = true;
    }
}

void Player::set_reference() {
    const World& world = session_.world();
    const Totals sums = totals(world);
    reference_ = {world.tick, sums.kinetic_energy + sums.potential_energy, sums.momentum, 0.0};
    for (std::size_t i = 0; i < world.balls.size(); ++i)
        reference_.momentum_scale += length(world.balls.velocity[i]) / world.balls.inverse_mass[i];
}

Wish Player::perform(Action action) {
    needs_draw_ = true;
    switch (action) {
        case Action::quit:
            return Wish::quit;
        case Action::menu:
            return escape();
        case Action::save:
            return Wish::save;
        case Action::mouse:
            return Wish::toggle_mouse;
        case Action::take_up:
            return Wish::take_up;
        case Action::help:
            shows_help_ = true;
            help_scroll_ = 0;
            return Wish::none;
        default:
            break;
    }
    if (action <= Action::restart)
        perform_in_time(action);
    else if (action <= Action::undo)
        perform_by_hand(action);
    else if (action <= Action::turn_gravity)
        perform_on_world(action);
    else
        perform_on_view(action);
    return Wish::none;
}

/// Lets go of what is in the hand; then of the cursor; then of the game.
Wish Player::escape() {
    if (!hand_.is_empty() || cue_is_armed_) {
        hand_.cancel(session_);
        cue_is_armed_ = false;
        pressed_.reset();
        return Wish::none;
    }
    if (shows_cursor_ || selected_) {
        shows_cursor_ = false;
        selected_.reset();
        follows_ = false;
        return Wish::none;
    }
    return Wish::menu;
}

void Player::perform_in_time(Action action) {
    switch (action) {
        case Action::pause:
            clockwork_.pause(!clockwork_.is_paused() || clockwork_.is_seeking());
            break;
        case Action::step_forward:
            clockwork_.pause(true);
            hand_.prepare(session_);
            session_.step_forward();
            break;
        case Action::step_back:
            clockwork_.pause(true);
            if (session_.world().tick == session_.earliest())
                say(session_.earliest() == 0 ? "this is the start"
                                             : "the memory for the way back ends here");
            else
                go_to(session_.world().tick - 1);
            break;
        case Action::next_collision:
            hand_.prepare(session_);
            clockwork_.seek_collision();
            break;
        case Action::second_forward:
            second(1);
            break;
        case Action::second_back:
            second(-1);
            break;
        case Action::slower:
            clockwork_.slower();
            say(fmt::format("speed x{:g}", clockwork_.speed()));
            break;
        case Action::faster:
            clockwork_.faster();
            say(fmt::format("speed x{:g}", clockwork_.speed()));
            break;
        case Action::normal_speed:
            clockwork_.normal();
            say("normal speed");
            break;
        default:
            hand_.forget();
            session_.restart();
            set_reference();
            energy_.clear();
            say("from the start");
            break;
    }
}

void Player::go_to(std::uint64_t tick) {
    hand_.forget();
    session_.go_to(tick);
    if (session_.world().tick < reference_.tick) set_reference();
}

void Player::second(int direction) {
    const auto rate = static_cast<std::uint64_t>(std::max(1.0, session_.world().rate));
    const std::uint64_t now = session_.world().tick;
    if (direction < 0) {
        go_to(now - session_.earliest() > rate ? now - rate : session_.earliest());
        return;
    }
    hand_.prepare(session_);
    for (std::uint64_t tick = 0; tick < rate; ++tick)
        session_.step_forward();
}

void Player::perform_on_world(Action action) {
    const std::optional<Vec2>& gravity = session_.world().model.gravity;
    if (gravity) last_gravity_ = gravity;
    const Vec2 on = last_gravity_.value_or(
        session_.scene().world.model.gravity.value_or(gentle_gravity(session_.scene())));
    if (action == Action::solver) return next_solver();
    if (action == Action::turn_gravity) return set_gravity(perpendicular(on));
    set_gravity(gravity ? std::nullopt : std::optional<Vec2>(on));
}

void Player::set_gravity(std::optional<Vec2> gravity) {
    // -0 would be shown as such.
    if (gravity) *gravity += Vec2{0.0, 0.0};
    obey(command::SetGravity{gravity},
         gravity ? fmt::format("gravity {:.3g},{:.3g}", gravity->x, gravity->y) : "gravity off");
}

void Player::next_solver() {
    const SolverSettings settings = after(session_.solver(), session_.scene().solver);
    solver_is_picked_ = false;
    obey(command::SetSolver{settings}, "solver " + solver_text(settings));
}

void Player::obey(const Command& command, std::string done) {
    if (const auto why_not = session_.apply(command)) {
        complain(*why_not);
        return;
    }
    set_reference();
    say(std::move(done));
}

void Player::perform_by_hand(Action action) {
    switch (action) {
        case Action::cursor_left:
            return move_cursor(-1.0, 0.0);
        case Action::cursor_right:
            return move_cursor(1.0, 0.0);
        case Action::cursor_up:
            return move_cursor(0.0, -1.0);
        case Action::cursor_down:
            return move_cursor(0.0, 1.0);
        case Action::next_ball:
            return jump_to_ball(false);
        case Action::previous_ball:
            return jump_to_ball(true);
        case Action::grab:
            return grab();
        case Action::cue:
            return use_cue();
        case Action::add_ball:
            return add_ball();
        case Action::remove:
            return remove_at_pointer(false);
        case Action::remove_edge:
            return remove_at_pointer(true);
        case Action::draw_edge:
            return draw_edge();
        default:
            hand_.forget();
            if (!session_.undo()) return say("nothing to undo");
            set_reference();
            return say("undone");
    }
}

void Player::jump_to_ball(bool backwards) {
    if (!hand_.is_empty()) return;
    selected_ = next_ball(session_.world(), selected_, backwards);
    if (!selected_) return say("there are no balls");
    shows_cursor_ = true;
    pointer_ = session_.world().balls.position[*index_of(session_.world(), *selected_)];
}

void Player::grab() {
    if (!hand_.is_empty()) {
        if (const auto complaint = hand_.open(session_)) complain(*complaint);
        set_reference();
        return;
    }
    shows_cursor_ = true;
    if (!hand_.take(session_.world(), pointer_, slack()))
        say("nothing to take here: move the cursor with the arrows, or press tab");
}

void Player::use_cue() {
    if (hand_.has_cue() || cue_is_armed_) {
        hand_.cancel(session_);
        cue_is_armed_ = false;
        return;
    }
    if (!hand_.is_empty()) return;
    if (const auto ball = ball_at_pointer()) {
        selected_ = ball;
        hand_.take_cue(*ball, pointer_);
        say("move away from the ball; enter shoots");
    } else {
        cue_is_armed_ = true;
        say("press the left button on a ball, pull, let go");
    }
}

void Player::add_ball() {
    const World& world = session_.world();
    BallSpec spec;
    spec.position = pointer_;
    if (selected_) {
        if (const auto index = index_of(world, *selected_)) {
            spec.kind = world.balls.kind[*index];
            spec.radius = world.balls.radius[*index];
            spec.mass = 1.0 / world.balls.inverse_mass[*index];
        }
    }
    obey(command::AddBall{spec}, fmt::format("ball {} added", world.next_ball));
}

void Player::remove_at_pointer(bool only_edges) {
    const World& world = session_.world();
    const auto ball = only_edges ? std::nullopt : ball_at_pointer();
    const auto edge = edge_at(world, pointer_, slack());
    if (ball) {
        obey(command::RemoveBall{*ball}, fmt::format("ball {} removed", number(*ball)));
        if (selected_ == ball) selected_.reset();
    } else if (edge) {
        obey(command::RemoveCapsule{*edge}, fmt::format("edge {} removed", number(*edge)));
    } else {
        say(only_edges ? "there is no edge here" : "there is nothing here");
    }
}

void Player::draw_edge() {
    if (hand_.has_new_edge()) return grab();
    if (!hand_.is_empty()) return;
    const Capsules& capsules = session_.world().capsules;
    const double radius =
        capsules.size() > 0 ? capsules.shape.back().radius : size(session_.scene().view).y / 200.0;
    const ClassIndex material = capsules.size() > 0 ? capsules.material.back() : ClassIndex{0};
    hand_.start_edge(pointer_, radius, material);
    say("move to the other end; e or enter makes the edge");
}

void Player::perform_on_view(Action action) {
    const auto toggle = [this](bool& what, std::string_view name_text) {
        what = !what;
        say(fmt::format("{} {}", name_text, what ? "on" : "off"));
    };
    const CellPoint middle{camera_.area.column + camera_.area.columns / 2.0,
                           camera_.area.row + camera_.area.rows / 2.0};
    switch (action) {
        case Action::renderer: {
            constexpr std::string_view names[] = {"automatic", "ascii", "half blocks", "braille"};
            const auto current = renderer_in_force(view_);
            view_.renderer = !view_.look.utf8                   ? Renderer::ascii
                             : current == Renderer::ascii       ? Renderer::half_blocks
                             : current == Renderer::half_blocks ? Renderer::braille
                                                                : Renderer::ascii;
            if (!view_.look.utf8) return say("without UTF-8 there is only ascii");
            return say(std::string(names[static_cast<std::size_t>(view_.renderer)]));
        }
        case Action::colors: {
            constexpr std::string_view names[] = {"kind", "speed", "mass"};
            const auto next = (static_cast<std::size_t>(view_.color_by) + 1) % 3;
            view_.color_by = static_cast<ColorBy>(next);
            return say(fmt::format("colour by {}", names[next]));
        }
        case Action::trails:
            return toggle(view_.trails, "trails");
        case Action::overlay:
            return next_overlay();
        case Action::velocities:
            return toggle(view_.velocities, "velocities");
        case Action::contacts:
            return toggle(view_.contacts, "contacts");
        case Action::broad_phase:
            return toggle(view_.broad_phase, "broad-phase cells");
        case Action::grid:
            return toggle(view_.grid, "coordinates");
        case Action::ids:
            view_.labels = view_.labels == Labels::all ? Labels::automatic : Labels::all;
            return say(view_.labels == Labels::all ? "numbers on" : "numbers off");
        case Action::outlines:
            view_.ball_style =
                view_.ball_style == BallStyle::filled ? BallStyle::outline : BallStyle::filled;
            return;
        case Action::histogram:
            if (!has_histogram()) return say("this level shows no histogram");
            shows_histogram_ = !shows_histogram_;
            return;
        case Action::energy:
            shows_energy_ = !shows_energy_;
            return;
        case Action::zoom_in:
            return zoom(middle, 1.25);
        case Action::zoom_out:
            return zoom(middle, 0.8);
        case Action::pan_left:
            return pan(-4.0, 0.0);
        case Action::pan_right:
            return pan(4.0, 0.0);
        case Action::pan_up:
            return pan(0.0, -2.0);
        case Action::pan_down:
            return pan(0.0, 2.0);
        case Action::fit:
            is_fitted_ = true;
            follows_ = false;
            return;
        default:
            if (!selected_) selected_ = ball_at_pointer();
            follows_ = !follows_ && selected_;
            return say(follows_    ? fmt::format("following ball {}", number(*selected_))
                       : selected_ ? "not following"
                                   : "press tab to choose a ball first");
    }
}

void Player::next_overlay() {
    bool* const overlays[] = {&view_.velocities, &view_.contacts, &view_.broad_phase, &view_.grid};
    constexpr std::string_view names[] = {"velocities", "contacts", "broad-phase cells",
                                          "coordinates"};
    std::size_t next = 0;
    for (std::size_t i = 0; i < std::size(overlays); ++i) {
        if (*overlays[i]) next = i + 1;
        *overlays[i] = false;
    }
    if (next == std::size(overlays)) return say("no overlay");
    *overlays[next] = true;
    say(std::string(names[next]));
}

}  // namespace carom
