#include "term_scenes.h"

namespace carom::bench {
namespace {

class Scenes {
  public:
    explicit Scenes(std::string gas) : gas_(std::move(gas)) {}

    CountedScene bare() const { return {.name = "gas", .text = gas_, .overrides = {"let n=500"}}; }
    CountedScene with(const std::string& statements) const {
        CountedScene scene = bare();
        scene.text += statements + "\n";
        return scene;
    }
    CountedScene with_override(const std::string& statement) const {
        CountedScene scene = bare();
        scene.overrides.push_back(statement);
        return scene;
    }

  private:
    std::string gas_;
};

// Every edge lets balls through from behind, where there is none.
void make_one_way(World& world) {
    const Vec2 inside = world.balls().position.front();
    world.edit_definition().model.one_way = true;
    world.edit_capsules().side.clear();
    for (const Capsule& shape : world.capsules().shape) {
        const bool is_left = cross(shape.end - shape.start, inside - shape.start) > 0.0;
        world.edit_capsules().side.push_back(is_left ? Side::left : Side::right);
    }
}

// A dragged wall that hardly moves.
void hold_wall(World& world) {
    const Capsule& wall = world.capsules().shape.front();
    const Vec2 step{1e-12, 0.0};
    world.edit_held_capsules() = {{.id = world.capsules().id.front(),
                                   .start_target = wall.start + step,
                                   .end_target = wall.end + step}};
}

// An emitter that is not due for a thousand seconds.
void add_emitter(World& world) {
    world.edit_emitters().push_back({.every = 1000.0, .count = 2, .emitted = 1});
}

void add_spent_emitter(World& world) {
    world.edit_emitters().push_back({.every = 1.0, .count = 1, .emitted = 1});
}

}  // namespace

CountedScene bare_scene(const std::string& gas) {
    return Scenes(gas).bare();
}

std::vector<TermScene> term_scenes(const std::string& gas) {
    const Scenes scenes(gas);
    CountedScene rubbing = scenes.with("use spin");
    rubbing.overrides.emplace_back("kind atom r=1 m=1 mu=1e-9");
    CountedScene one_way = scenes.bare();
    one_way.prepare = make_one_way;
    CountedScene held = scenes.bare();
    held.before_tick = hold_wall;
    CountedScene let_go = scenes.bare();
    let_go.prepare = hold_wall;
    let_go.before_tick = [](World& world) {
        if (world.tick() > 0) world.edit_held_capsules().clear();
    };
    CountedScene emitter = scenes.bare();
    emitter.prepare = add_emitter;
    CountedScene spent_emitter = scenes.bare();
    spent_emitter.prepare = add_spent_emitter;
    const std::string nobody = "kind nobody r=1\ncollide atom atom\ncollide atom edge\n";
    return {
        {"gravity", scenes.with("use gravity 0,-1e-9"), scenes.with("use gravity 0,0")},
        {"drag", scenes.with("use drag 1e-9"), scenes.with("use drag 0")},
        {"restitution", scenes.with_override("kind atom r=1 m=1 e=0.999999999"),
         scenes.with_override("kind atom r=1 m=1 e=1")},
        {"stop", scenes.with("use stop 1e-9"), scenes.with("use stop 0")},
        {"speed limit", scenes.with("use limit 1e9"), std::nullopt},
        {"spin and friction", rubbing, scenes.with_override("kind atom r=1 m=1 mu=0")},
        {"cloth", scenes.with("use cloth slide=1e-9 roll=1e-9 spin=0 g=1"), std::nullopt},
        {"torus", scenes.with("world -2,-2 side+2,side+2\nuse wrap"),
         scenes.with("world -2,-2 side+2,side+2")},
        {"scatter", scenes.with("use scatter 1e-9"), scenes.with("use scatter 0")},
        {"one-way edges", one_way, std::nullopt},
        {"filter", scenes.with(nobody + "ball kind=nobody at=-1,-1"),
         scenes.with("collide atom atom\ncollide atom edge\n")},
        {"dragged edge", held, let_go},
        {"sink", scenes.with("zone -1,-1 -1,-1 r=0.1 sink"), std::nullopt},
        {"emitter", emitter, spent_emitter},
    };
}

}  // namespace carom::bench
