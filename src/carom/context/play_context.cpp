#include "carom/context/play_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace carom {
namespace {

/// How close to the pointer an object must be to be picked, in columns: a fingertip's breadth, a
/// row and a half.
constexpr double reach = 3.0;

}  // namespace

Camera Controller::fit(const PlayContext& play, const CellArea& area, double aspect) {
    return play.view.fitted(area, aspect);
}

void Controller::annotate(const PlayContext& play, Annotations& annotations) const {
    play.pointer.tool.annotate(play.session.world(), play.session.solver(),
                               speed_unit(play.session.scene()), annotations);
}

PlayContext::PlayContext(Session game, const ViewOptions& options, KeyMap key_map, bool is_picked)
    : session(std::move(game)),
      words(words_of(session.scene().comment)),
      keys(std::move(key_map)),
      view{.options = options, .defaults = options, .shown = session.scene().view},
      pointer{.at = center(session.scene().view)},
      panels(session.scene()),
      solver_is_picked(is_picked) {
    reference.set(session.world());
    observation = std::make_shared<PlayObserver>(session);
    session.set_after_tick(
        [observer = observation](const Session& now) { observer->note_tick(now); });
}

PlayContext::PlayContext(PlayContext&& other) noexcept = default;
PlayContext& PlayContext::operator=(PlayContext&& other) noexcept = default;
PlayContext::~PlayContext() = default;

void say(PlayContext& play, std::string message, std::optional<Vec2> place) {
    play.messages.say(std::move(message), place);
    play.needs_draw = true;
}

void complain(PlayContext& play, std::string message, std::optional<Vec2> place) {
    play.messages.complain(std::move(message), place);
    play.needs_draw = true;
}

void complain(PlayContext& play, const Complaint& complaint) {
    complain(play, complaint.text, complaint.place);
}

void obey(PlayContext& play, const Command& command, std::string done) {
    const auto place = obstacle_to(play.session.world(), command);
    if (const auto why_not = play.session.apply(command)) return complain(play, *why_not, place);
    set_reference(play);
    say(play, std::move(done));
}

void set_reference(PlayContext& play) {
    play.reference.set(play.session.world());
}

bool is_watching(const PlayContext& play) {
    return play.session.is_following();
}

bool is_idle(const PlayContext& play) {
    return play.clock.is_paused() && !play.clock.is_seeking();
}

bool keep_up(PlayContext& play, const MayGoOn& may_go_on) {
    const bool was_behind = play.companion.is_behind(play.session);
    const bool is_there = play.companion.follow(play.session, may_go_on, play.keep_going);
    play.needs_draw = play.needs_draw || (was_behind && is_there);
    return is_there;
}

double slack(const PlayContext& play) {
    return reach / play.view.camera.columns_per_length;
}

std::optional<BallId> ball_at_pointer(const PlayContext& play) {
    return ball_at(play.session.world(), play.pointer.at, slack(play));
}

void move_pointer(PlayContext& play, Vec2 to) {
    Pointer& pointer = play.pointer;
    if (to == pointer.at) return;
    pointer.at = to;
    play.controller->point(play);
    if (pointer.tool.is_empty()) return;
    play.needs_draw = true;
    if (const auto complaint = pointer.tool.move(play.session, to, is_idle(play)))
        complain(play, *complaint);
    else
        play.messages.end_obstacle();
}

void move_cursor(PlayContext& play, double columns, double rows) {
    Pointer& pointer = play.pointer;
    const Camera& camera = play.view.camera;
    if (!pointer.shows_cursor && pointer.tool.is_empty() &&
        !contains(visible_box(camera), pointer.at))
        pointer.at = camera.center;
    pointer.shows_cursor = true;
    CellPoint place = to_cells(camera, pointer.at);
    place.column += columns;
    place.row += rows;
    const CellArea& area = camera.area;
    place.column = std::clamp(place.column, area.column + 0.5, area.column + area.columns - 0.5);
    place.row = std::clamp(place.row, area.row + 0.5, area.row + area.rows - 0.5);
    move_pointer(play, to_world(camera, place));
}

std::string name_of(const PlayContext& play, BallId ball) {
    const std::vector<std::string>& names = play.session.scene().ball_names;
    const std::uint32_t id = number(ball);
    return id < names.size() && !names[id].empty() ? names[id] : fmt::format("ball {}", id);
}

std::string_view speed_unit(const Scene& scene) {
    return scene.unit == LengthUnit::natural ? "" : " m/s";
}

}  // namespace carom
