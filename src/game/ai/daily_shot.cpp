#include "game/ai/daily_shot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "game/ai/pool_shots.h"
#include "game/session/forecast.h"
#include "physics/world/random.h"

namespace carom {
namespace {

constexpr std::uint64_t most_draws = 400;
constexpr double longest_shot = 40.0;  // s
constexpr double berth = 3.0;          // radii between a ball and the cushions
constexpr double least_apart = 10.0;   // radii between the balls
constexpr double least_run = 0.35;     // length from the impact to the ring
constexpr double ring = 0.15;          // its radius, as in the level
// Neither dead straight nor a thin cut.
constexpr double thinnest = 0.55;
constexpr double fullest = 0.97;
constexpr std::array tips = {-0.4, -0.2, 0.2, 0.4, 0.0};
constexpr double plain_speed = 2.0;  // m/s: a stroke in the middle of the ball, that must not do

double draw(int date, std::uint64_t attempt, std::uint64_t what) {
    return random_unit(static_cast<std::uint64_t>(date), RandomStream::player, attempt, what);
}

double millimetres(double length) {
    return std::round(length * 1000.0) / 1000.0;
}

Vec2 drawn_place(const Box& cloth, double radius, int date, std::uint64_t attempt,
                 std::uint64_t what) {
    const Vec2 room = size(cloth) - Vec2{2.0, 2.0} * (berth * radius);
    return {millimetres(cloth.low.x + berth * radius + room.x * draw(date, attempt, what)),
            millimetres(cloth.low.y + berth * radius + room.y * draw(date, attempt, what + 1))};
}

// Where the cue ball stops if the object ball falls, and the cue ball does not.
std::optional<Vec2> place_after(const Scene& scene, const World& world, Solver& solver,
                                BallId object, const command::Strike& strike) {
    const Forecast ahead = forecast(scene, world, {}, solver, strike, longest_shot, Tracks::none);
    const auto cue = index_of(ahead.world, strike.ball);
    if (!ahead.comes_to_rest || !cue || index_of(ahead.world, object)) return std::nullopt;
    return ahead.world.balls().position[*cue];
}

std::optional<DailyShot> attempted(const Scene& scene, const Box& cloth, BallId object, int date,
                                   std::uint64_t attempt) {
    const BallId cue = scene.pool.cue->ball;
    World world = scene.world;
    const std::size_t of_cue = *index_of(world, cue);
    const std::size_t of_object = *index_of(world, object);
    const double radius = world.balls().radius[of_cue];
    DailyShot shot;
    shot.cue = drawn_place(cloth, radius, date, attempt, 0);
    shot.object = drawn_place(cloth, radius, date, attempt, 2);
    if (length(shot.cue - shot.object) < least_apart * radius) return std::nullopt;
    world.edit_balls().position[of_cue] = shot.cue;
    world.edit_balls().position[of_object] = shot.object;
    const auto lines = pot_lines(scene, world, cloth, cue, shot.cue, std::span(&object, 1));
    if (lines.empty() || lines.front().way != PotLine::Way::direct ||
        lines.front().cut_cosine < thinnest || lines.front().cut_cosine > fullest)
        return std::nullopt;
    const PotLine& line = lines.front();
    const double speed = 1.2 + 2.0 * draw(date, attempt, 4);
    const auto tip = static_cast<std::size_t>(draw(date, attempt, 5) * tips.size());
    shot.example = {cue, line.direction * speed, 0.0, tips[std::min(tip, tips.size() - 1)]};
    Solver solver(pick_solver(world).settings);
    const auto stops = place_after(scene, world, solver, object, shot.example);
    if (!stops || length(*stops - line.ghost) < least_run) return std::nullopt;
    const auto plain =
        place_after(scene, world, solver, object, {cue, line.direction * plain_speed, 0.0, 0.0});
    if (plain && length(*plain - *stops) < 1.2 * ring) return std::nullopt;
    shot.ring = {millimetres(stops->x), millimetres(stops->y)};
    return shot;
}

}  // namespace

std::optional<DailyShot> daily_shot(const Scene& scene, int date) {
    const auto cloth = cloth_box(scene);
    const auto named = std::ranges::find(scene.ball_names, "object");
    if (!cloth || !scene.pool.cue || named == scene.ball_names.end()) return std::nullopt;
    const BallId object =
        scene.world.balls().id[static_cast<std::size_t>(named - scene.ball_names.begin())];
    for (std::uint64_t attempt = 0; attempt < most_draws; ++attempt)
        if (auto shot = attempted(scene, *cloth, object, date, attempt)) return shot;
    return std::nullopt;
}

std::vector<std::string> amendments_of(const DailyShot& shot, int date) {
    std::vector<std::string> lines{fmt::format("let day={}", date)};
    const auto add = [&](std::string_view x, std::string_view y, Vec2 place) {
        lines.push_back(fmt::format("let {}={:.0f}", x, place.x * 1000.0));
        lines.push_back(fmt::format("let {}={:.0f}", y, place.y * 1000.0));
    };
    add("cx", "cy", shot.cue);
    add("ox", "oy", shot.object);
    add("rx", "ry", shot.ring);
    return lines;
}

}  // namespace carom
