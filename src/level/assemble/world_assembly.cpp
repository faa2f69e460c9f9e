#include "level/assemble/world_assembly.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "level/assemble/curves.h"

namespace carom {
namespace {

// Flippers need short ticks, so a game of pinball has a higher default rate.
double own_rate(const LevelIr& ir) {
    constexpr double pinball_rate = 1000.0;
    return ir.settings.rate.value_or(ir.settings.table.is_game ? pinball_rate : World{}.rate());
}

}  // namespace

double level_rate(const LoadOptions& options, const LevelIr& ir) {
    return options.rate.value_or(own_rate(ir));
}

void WorldAssembly::fill_in(Scene& scene) const {
    World& world = scene.world;
    const LevelSettings& s = ir_.settings;
    world.edit_definition().seed = context_.seed;
    world.edit_definition().rate = level_rate(options_, ir_);
    world.edit_definition().kinds = names_.kinds;
    world.edit_definition().materials = names_.materials;
    make_model(world.edit_definition().model);
    world.edit_definition().need = s.need;
    if (world.model().filtered) world.edit_definition().meets = names_.collision_matrix;
    for (const StartingBall& ball : balls_) {
        BallSpec spec;
        if (ball.spec >= 0) spec = ir_.balls[static_cast<std::size_t>(ball.spec)];
        spec.kind = ball.kind;
        spec.position = ball.position;
        spec.velocity = ball.velocity;
        spec.radius = ball.radius;
        spec.mass = ball.mass;
        spec.restitution = ball.restitution;
        const std::size_t i = world.balls().size();
        if (!amended_.spin.empty() && amended_.spin[i]) spec.spin = *amended_.spin[i];
        if (!amended_.roll.empty() && amended_.roll[i]) spec.roll = *amended_.roll[i];
        add_ball(world, spec);
    }
    for (const CapsuleIr& edge : ir_.capsules) {
        add_capsule(world, edge.shape, material_of(edge), edge.side);
    }
    join_curves(ir_, world);
    for (std::size_t i = 0; i < ir_.emitters.size(); ++i) {
        Emitter emitter = ir_.emitters[i].emitter;
        emitter.kind = names_.emitters[i].kind;
        world.edit_emitters().push_back(emitter);
    }
    scene.kind_names = names_.kind_names;
    scene.material_names = names_.material_names;
    scene.solver = options_.solver ? options_.solver : s.solver;
    scene.game = s.game.value_or("sandbox");
    scene.overridden = !options_.overrides.empty() ||
                       (options_.solver && options_.solver != s.solver) ||
                       (options_.rate && options_.rate != own_rate(ir_)) ||
                       (options_.seed && *options_.seed != s.seed.value_or(0));
    make_outlines(scene);
    scene.view = view(world);
}

ClassIndex WorldAssembly::material_of(const CapsuleIr& edge) const {
    return names_.edges[static_cast<std::size_t>(edge.binding)].material;
}

void WorldAssembly::make_model(Model& model) const {
    const LevelSettings& s = ir_.settings;
    model.gravity = s.gravity;
    model.drag = s.drag;
    model.stop_speed = s.stop_speed;
    model.speed_limit = s.speed_limit;
    model.scatter = s.scatter;
    model.spin = s.spin;
    model.cloth = s.cloth;
    model.modulus = s.modulus;
    constexpr double solid_ball = 0.4;
    if (s.cloth) model.spin = s.inertia.value_or(solid_ball);
    if (s.wrap) model.wrap = s.world;
    model.inelastic = is_inelastic();
    model.one_way = std::ranges::any_of(ir_.devices, [](const DeviceIr& d) {
        return d.device.kind == DeviceKind::droptarget || d.device.kind == DeviceKind::post;
    });
    model.filtered = !names_.all_collide();
    model.ball_ball = names_.some_balls_collide();
    model.ball_edge = names_.some_edges_collide();
}

bool WorldAssembly::is_inelastic() const {
    const auto loses = [](double restitution) { return restitution < 1.0; };
    if (std::ranges::any_of(balls_, loses, &StartingBall::restitution)) return true;
    for (const ResolvedBalls& of : names_.emitters) {
        if (loses(names_.kinds[of.kind].restitution)) return true;
    }
    for (const CapsuleIr& edge : ir_.capsules) {
        const Material& material = names_.materials[material_of(edge)];
        if (loses(material.restitution) || material.soften > 0.0) return true;
    }
    return false;
}

void WorldAssembly::make_outlines(Scene& scene) const {
    std::map<int, std::vector<CapsuleId>> outlines;
    for (std::size_t i = 0; i < ir_.capsules.size(); ++i) {
        const int chain = ir_.capsules[i].chain;
        if (!ir_.chains[static_cast<std::size_t>(chain)].is_closed) continue;
        outlines[chain].push_back(scene.world.capsules().id[i]);
    }
    for (auto& [chain, capsules] : outlines)
        scene.outlines.push_back(std::move(capsules));
}

// The box that the level declares as its world, else the bounds of everything; never empty.
Box WorldAssembly::view(const World& world) const {
    if (ir_.settings.world) return *ir_.settings.world;
    std::optional<Box> all;
    const auto add = [&](const Box& box) { all = all ? join(*all, box) : box; };
    for (const CapsuleIr& edge : ir_.capsules)
        add(bounds(edge.shape));
    for (const StartingBall& ball : balls_)
        add(bounds(Disc{ball.position, ball.radius}));
    for (const Emitter& emitter : world.emitters()) {
        add(bounds(Disc{emitter.at, names_.kinds[emitter.kind].radius}));
    }
    if (!all) return {{-10.0, -10.0}, {10.0, 10.0}};
    const Vec2 extent = size(*all);
    const double most = std::max(extent.x, extent.y);
    const double margin = most > 0.0 ? 0.0 : 10.0;
    Box box = grow(*all, margin);
    if (extent.x < 1e-3 * most) box = join(box, grow({center(box), center(box)}, 0.5 * most));
    if (extent.y < 1e-3 * most) box = join(box, grow({center(box), center(box)}, 0.5 * most));
    return box;
}

}  // namespace carom
