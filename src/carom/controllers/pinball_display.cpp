#include "carom/controllers/pinball_display.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "carom/controllers/pinball_panel.h"
#include "game/pinball/pinball.h"
#include "game/rules/rules.h"

namespace carom {
namespace {

constexpr int least_table_columns = 30;
constexpr double least_seen = 0.6;    // share of the table, where it does not fit
constexpr double ball_rows = 1.0;     // diameter of a ball that the eye can follow
constexpr double lamp_radius = 0.7;   // radius of a lamp, in radii of the ball
constexpr double warning_time = 3.0;  // s of blinking before a light goes out
constexpr double blinks = 8.0;        // changes a second
constexpr double gauge_beside = 2.4;  // place and length of the plunger's gauge, in radii
constexpr double gauge_length = 12.0;
constexpr double shake = 1.2;  // radii that a nudge moves the picture

const PinballState& state_of(const Session& session) {
    return std::get<PinballState>(session.game());
}

double ball_radius(const Session& session) {
    const Balls& balls = session.scene().world.balls();
    return balls.size() > 0 ? balls.radius[0] : 0.0;
}

bool is_bright(const Session& session, std::size_t device) {
    const PinballState& state = state_of(session);
    if (session.world().tick() < state.flash_until[device]) return true;
    if (state.is_lit[device] == 0) return false;
    const std::uint64_t until = state.lit_until[device];
    if (until == 0) return true;
    const double left = (static_cast<double>(until) - static_cast<double>(session.world().tick())) /
                        session.world().rate();
    return left > warning_time || static_cast<std::uint64_t>(left * blinks) % 2 == 0;
}

// By device: whether it flashes, because the task asks for it.
std::vector<bool> flashing_devices(const Session& session) {
    const PinballTable& table = session.scene().table;
    std::vector<bool> flashing(table.devices.size(), false);
    for (const std::uint32_t group :
         shots_to_make(session.scene(), session.world(), state_of(session)))
        for (const std::uint32_t device : table.groups[group].devices)
            flashing[device] = true;
    return flashing;
}

bool is_flash_on(const Session& session) {
    constexpr double flashes = 3.0;  // a second
    const double time = static_cast<double>(session.world().tick()) / session.world().rate();
    return static_cast<std::uint64_t>(2.0 * flashes * time) % 2 == 0;
}

bool has_lamp(DeviceKind kind) {
    return kind == DeviceKind::lamp || kind == DeviceKind::rollover ||
           kind == DeviceKind::kickback || kind == DeviceKind::hole ||
           kind == DeviceKind::spinner || kind == DeviceKind::magnet || kind == DeviceKind::lock;
}

bool lights_itself(DeviceKind kind) {
    return kind == DeviceKind::target || kind == DeviceKind::bumper ||
           kind == DeviceKind::slingshot || kind == DeviceKind::droptarget;
}

void dress_light(TableLight& light, const DeviceDress& dress) {
    light.color = dress.color;
    light.insert = dress.shape;
    light.direction = dress.direction;
    light.text = dress.text;
}

}  // namespace

// The camera follows the ball nearest to the drain, which matters most. Before the launch it shows
// the whole table, with the lane that the plunger is to reach.
void PinballDisplay::follow(const Session& session, double seconds) {
    count_ball(state_of(session));
    camera_.approach(state_of(session).is_launched || !session.scene().table.is_game, seconds);
    const Balls& balls = session.world().balls();
    std::optional<std::size_t> lowest;
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (is_in_play(session.scene(), state_of(session), balls.id[i]) &&
            (!lowest || balls.position[i].y < balls.position[*lowest].y))
            lowest = i;
    if (lowest) camera_.follow(balls.position[*lowest].y, balls.velocity[*lowest].y, seconds);
}

void PinballDisplay::cut_panel(const Session& session, CellArea& area, const Box& table) {
    panel_ = {};
    card_ = {};
    if (area.columns < least_table_columns + score_panel_columns) return;
    // The columns that the table takes in a window of this height: whole, or larger where the ball
    // would be too small.
    constexpr double aspect = 2.0;  // of most terminals
    constexpr int margin = 4;
    const Vec2 extent = size(table);
    const double shape = extent.y > 0.0 ? extent.x / extent.y : 1.0;
    const double ball =
        extent.y > 0.0 ? 2.0 * ball_radius(session) / extent.y * area.rows : ball_rows;
    const double zoom = ball > 0.0 ? std::clamp(ball_rows / ball, 1.0, 1.0 / least_seen) : 1.0;
    const double wanted = std::min(1e4, zoom * shape * aspect * area.rows) + margin;
    const int spare =
        std::max(score_panel_columns,
                 area.columns - std::max(least_table_columns, static_cast<int>(wanted)));
    if (spare >= score_panel_columns + rules_card_columns) {
        const int columns = std::clamp(spare - most_score_panel_columns, rules_card_columns,
                                       most_rules_card_columns);
        card_ = {area.column, area.row, columns, area.rows};
        area.column += columns;
        area.columns -= columns;
    }
    const int columns =
        std::clamp(spare - card_.columns, score_panel_columns, most_score_panel_columns);
    area.columns -= columns;
    panel_ = {area.column + area.columns, area.row, columns, area.rows};
}

// A score that falls is that of another game, or of an earlier time.
void PinballDisplay::count_ball(const PinballState& state) {
    const bool is_over = state.phase == PinballState::Phase::over;
    const std::uint32_t ball = state.ball + (is_over ? 1 : 0);
    const std::int64_t before = std::exchange(score_, state.score);
    if (state.score < before || ball < ball_) {
        std::erase_if(ball_scores_, [&](const BallScore& known) { return known.ball >= ball; });
        began_.reset();
        ball_ = ball;
    }
    if (state.score == 0 && ball == 1) began_ = 0;
    if (ball <= ball_) return;
    if (began_ && ball_ > 0) ball_scores_.push_back({ball_, state.score - *began_});
    if (ball_ > 0) began_ = state.score;
    ball_ = ball;
}

Camera PinballDisplay::look(const Session& session, const Box& table, const CellArea& area,
                            double aspect, bool whole) {
    const PinballState& state = state_of(session);
    Camera camera = whole ? fit_camera(table, area, aspect)
                          : camera_.look(table, ball_radius(session), ball_rows, area, aspect);
    // The table moves under a camera that stays.
    const double push = length(state.nudge);
    if (session.world().tick() <= state.nudge_until && push > 0.0)
        camera.center -= state.nudge * (shake * ball_radius(session) / push);
    return camera;
}

TableAnnotations PinballDisplay::annotations(const Session& session) const {
    TableAnnotations annotations;
    const PinballTable& table = session.scene().table;
    const Dress& dress = session.scene().dress;
    const double radius = lamp_radius * ball_radius(session);
    const std::vector<bool> flashing = flashing_devices(session);
    for (std::size_t i = 0; i < table.devices.size(); ++i) {
        const Device& device = table.devices[i];
        TableLight light{.is_lit = flashing[i] ? is_flash_on(session) : is_bright(session, i),
                         .family = device.group};
        // A target that has dropped is not there.
        if (device.kind == DeviceKind::droptarget)
            light.is_lit = light.is_lit && flashing[i] && state_of(session).is_lit[i] == 0;
        if (i < dress.devices.size()) dress_light(light, dress.devices[i]);
        if (has_lamp(device.kind)) {
            const double own = i < dress.devices.size() ? dress.devices[i].radius : 0.0;
            light.shape = {device.place, device.place, own > 0.0 ? own : radius};
            annotations.lights.push_back(light);
        } else if (lights_itself(device.kind)) {
            light.is_edge = true;
            light.is_bumper = device.kind == DeviceKind::bumper;
            for (const CapsuleId id : device.capsules) {
                const auto index = index_of(session.world(), id);
                if (!index) continue;
                light.shape = session.world().capsules().shape[*index];
                annotations.lights.push_back(light);
            }
        } else if (device.kind == DeviceKind::flipper) {
            for (const CapsuleId id : device.capsules)
                if (const auto index = index_of(session.world(), id))
                    annotations.flippers.push_back(session.world().capsules().shape[*index]);
        } else if (device.kind == DeviceKind::plunger && !device.capsules.empty()) {
            const auto index = index_of(session.world(), device.capsules.front());
            if (!index) continue;
            const Capsule plate = session.world().capsules().shape[*index];
            const double pull = state_of(session).pull;
            const double pulled = pull * 3.0 * ball_radius(session);
            const Vec2 back = device.direction * -(pulled + 0.3 * ball_radius(session));
            annotations.plungers.push_back({plate.start + back, plate.end + back, plate.radius});
            if (pull <= 0.0) continue;
            const Vec2 beside = Vec2{-device.direction.y, device.direction.x} * gauge_beside;
            const Vec2 foot = device.place + beside * ball_radius(session);
            annotations.gauges.push_back(
                {foot, foot + device.direction * (gauge_length * ball_radius(session)), pull});
        }
    }
    return annotations;
}

void PinballDisplay::draw_panel(Canvas& canvas, const Session& session, const PinballScores& scores,
                                bool is_demonstrating, const Look& look) const {
    if (panel_.columns == 0) return;
    if (card_.columns > 0)
        draw_rules_card(canvas, card_, "HOW TO PLAY", session.scene().comment, look);
    ScorePanel panel = score_panel(session, scores, is_demonstrating);
    if (scores_of(state_of(session)).size() == 1)
        for (const BallScore& known : ball_scores_)
            panel.balls.push_back(fmt::format("ball {} {:>16}", known.ball, grouped(known.score)));
    panel.message = messages_.text();
    panel.moment = messages_.moment();
    draw_score_panel(canvas, panel_, panel, look);
}

}  // namespace carom
