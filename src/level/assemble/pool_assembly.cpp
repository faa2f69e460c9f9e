#include "level/assemble/pool_assembly.h"

#include <fmt/format.h>

#include <algorithm>

#include "level/text/spelling.h"

namespace carom {
namespace {

void check_cloth(const LoadOptions& options, Context& context) {
    const LevelSettings& settings = context.ir.settings;
    if (!settings.cloth) return;
    const auto refuse = [&](std::string_view term) {
        context.reporter.error("cloth-with-other-term", *settings.cloth_at,
                               fmt::format("use cloth does not go with 'use {}'", term),
                               "a table is seen from above: nothing pulls or brakes the balls but "
                               "its cloth");
    };
    if (settings.gravity) refuse("gravity");
    if (settings.drag) refuse("drag");
    const auto& solver = options.solver ? options.solver : settings.solver;
    if (solver && !supports(solver->kind, {.cloth = Cloth{}}))
        context.reporter.error("solver-without-cloth", *settings.cloth_at,
                               fmt::format("solver {} does not know cloth", name(solver->kind)),
                               "take another solver, or leave the line solver out");
}

void check_pockets(const std::vector<StartingBall>& balls, Context& context) {
    double largest = 0.0;
    for (const StartingBall& ball : balls)
        largest = std::max(largest, ball.radius);
    for (const ZoneIr& zone : context.ir.zones) {
        if (!zone.is_pocket || zone.origin.image != 0 || zone.zone.shape.radius >= largest)
            continue;
        context.reporter.error(
            "pocket-too-small", zone.origin.span(), "the pocket is smaller than a ball",
            fmt::format("make it {} or larger", written(largest, Measure::length, context.unit)));
    }
}

// Only the rules of a level can give each player a cue ball.
void check_cues(Context& context) {
    const LevelIr& ir = context.ir;
    const auto at = [](const CueIr& cue) { return cue.ball.span(); };
    if (ir.settings.is_shots && ir.cues.empty() && !context.reporter.has_errors())
        context.reporter.error("game-lacks-part", *ir.settings.game_at, "game shots needs a cue",
                               "add a line such as: cue ball=cue power=0..10m/s");
    if (!ir.settings.is_shots && ir.cues.size() > 1)
        context.reporter.error("statement-twice", at(ir.cues[1]), "there is a cue already",
                               "only game shots has a cue for each player");
    for (std::size_t i = ir.settings.players; ir.settings.is_shots && i < ir.cues.size(); ++i)
        context.reporter.error(
            "cue-without-player", at(ir.cues[i]),
            fmt::format("there are {} players, and this is cue {}", ir.settings.players, i + 1),
            "write: game shots players=2, or take out the cue");
}

void check_game(Context& context) {
    const LevelIr& ir = context.ir;
    check_cues(context);
    if (ir.settings.table.is_game && !ir.cues.empty()) {
        context.reporter.error("cue-in-pinball", ir.cues.front().ball.span(),
                               "game pinball has flippers and plungers, and no cue",
                               "take the cue out, or the line game pinball");
        return;
    }
    const GameRow* game = ir.settings.game ? game_named(*ir.settings.game) : nullptr;
    if (!game || !game->rack || context.reporter.has_errors()) return;
    const auto needs = [&](std::string_view what, std::string_view line) {
        context.reporter.error("game-lacks-part", *ir.settings.game_at,
                               fmt::format("game {} needs {}", game->name, what),
                               fmt::format("add a line such as: {}", line));
    };
    if (std::ranges::count(ir.racks, game->rack, &RackIr::layout) != 1)
        needs(fmt::format("one {}", game->rack->statement),
              fmt::format("{} kind=pool at=635,0", game->rack->statement));
    if (ir.cues.size() != 1) needs("one cue", "cue ball=cue power=0..10m/s");
    if (std::ranges::none_of(ir.zones, &ZoneIr::is_pocket))
        needs("pockets", "pocket corner at=1299.5,664.5 r=62");
}

std::optional<BallId> ball_named(const Scene& scene, std::string_view name) {
    const auto named = std::ranges::find(scene.ball_names, name);
    if (named == scene.ball_names.end()) return std::nullopt;
    return scene.world.balls().id[static_cast<std::size_t>(named - scene.ball_names.begin())];
}

// The balls that a cue strikes: in `game shots` all of this name, or of this kind; else one.
std::vector<BallId> balls_of_cue(const Scene& scene, std::string_view name,
                                 const std::vector<StartingBall>& balls, const LevelIr& ir) {
    std::vector<BallId> struck;
    const auto add_if = [&](auto&& is_meant) {
        for (std::size_t i = 0; ir.settings.is_shots && i < balls.size(); ++i)
            if (is_meant(balls[i])) struck.push_back(scene.world.balls().id[i]);
    };
    add_if([&](const StartingBall& ball) {
        if (ball.binding < 0) return false;
        const auto& bound = ir.ball_bindings[static_cast<std::size_t>(ball.binding)].name;
        return bound && bound->text == name;
    });
    if (!struck.empty()) return struck;
    if (const auto ball = ball_named(scene, name)) return {*ball};
    add_if([&](const StartingBall& ball) { return scene.kind_names[ball.kind] == name; });
    return struck;
}

// The balls that the game needs beside its rack.
void find_others(Scene& scene, Context& context) {
    const LevelSettings& settings = context.ir.settings;
    const GameRow* game = settings.game ? game_named(*settings.game) : nullptr;
    if (!game || context.reporter.has_errors()) return;
    for (const std::string_view name : game->others) {
        if (const auto ball = ball_named(scene, name)) {
            scene.pool.others.push_back(*ball);
            continue;
        }
        context.reporter.error("game-lacks-part", *settings.game_at,
                               fmt::format("game {} needs a ball named {}", game->name, name),
                               fmt::format("add a line such as: ball {} at=0,0", name));
    }
    if (scene.pool.others.size() != game->others.size() || game->others.empty()) return;
    const auto place_of = [&](std::string_view name) {
        return scene.world.balls().position[*index_of(scene.world, *ball_named(scene, name))];
    };
    const Vec2 middle = place_of("brown");
    scene.pool.d = BaulkD{middle, length(place_of("yellow") - middle)};
}

}  // namespace

void check_pool(const std::vector<StartingBall>& balls, const LoadOptions& options,
                Context& context) {
    check_cloth(options, context);
    check_pockets(balls, context);
    check_game(context);
}

void fill_in_pool(const std::vector<StartingBall>& balls,
                  const std::vector<std::uint32_t>& world_zones, Scene& scene, Context& context) {
    const LevelIr& ir = context.ir;
    for (const RackIr& from : ir.racks) {
        Rack rack;
        rack.layout = from.layout;
        rack.foot = from.foot;
        rack.toward = from.toward;
        rack.gap = from.gap;
        rack.seed = from.seed;
        for (std::size_t i = 0; i < balls.size(); ++i)
            if (balls[i].binding == from.binding) rack.balls.push_back(scene.world.balls().id[i]);
        scene.pool.racks.push_back(std::move(rack));
    }
    for (std::size_t i = 0; i < ir.zones.size(); ++i)
        if (ir.zones[i].is_pocket) scene.pool.pockets.push_back(world_zones[i]);
    std::ranges::sort(scene.pool.pockets);
    scene.pool.race = ir.settings.race;
    scene.pool.clock = ir.settings.clock;
    scene.pool.rules = ir.settings.rules;
    find_others(scene, context);
    for (const CueIr& cue : ir.cues) {
        const std::vector<BallId> struck = balls_of_cue(scene, cue.ball.text, balls, ir);
        if (!struck.empty()) {
            scene.pool.cues.push_back(
                {struck.front(), struck, cue.least_power, cue.most_power, cue.scatter});
            scene.pool.cue = scene.pool.cues.front();
            continue;
        }
        std::vector<std::string_view> known;
        for (const std::string& other : scene.ball_names)
            if (!other.empty()) known.push_back(other);
        context.reporter.error(
            "unknown-ball", cue.ball.span(), fmt::format("there is no ball '{}'", cue.ball.text),
            did_you_mean(cue.ball.text, known, "give the ball a name: ball NAME at=..."));
    }
}

}  // namespace carom
