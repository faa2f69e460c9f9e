#include <fmt/format.h>

#include <cstdlib>
#include <utility>

#include "drive.h"
#include "heap.h"
#include "level_scene.h"
#include "physics/solver.h"

// carom itself. It loads the level; from the list it takes only the plan.
namespace {

using namespace carom::bench;

class Carom {
  public:
    Carom(carom::World world, const carom::SolverSettings& settings, std::int64_t measured_from)
        : world_(std::move(world)),
          solver_(settings),
          measured_from_(static_cast<std::uint64_t>(measured_from)) {}

    // Nothing to do: the world already has its balls, or emitters for them.
    void add(const ListedBall&) {}
    void step() {
        if (world_.tick() == measured_from_) collisions_before_ = collisions();
        solver_.tick(world_);
    }

    std::size_t size() const { return world_.balls().size(); }
    BallState state(std::size_t index) const {
        const carom::Vec2 position = world_.balls().position[index];
        const carom::Vec2 velocity = world_.balls().velocity[index];
        return {position.x, position.y, velocity.x, velocity.y};
    }
    /// During the measured ticks.
    std::uint64_t measured_collisions() const { return collisions() - collisions_before_; }

  private:
    std::uint64_t collisions() const {
        return world_.ledger().ball_ball_collisions + world_.ledger().ball_edge_collisions;
    }

    carom::World world_;
    carom::Solver solver_;
    std::uint64_t measured_from_;
    std::uint64_t collisions_before_ = 0;
};

carom::Scene scene_of(const std::string& level, const std::vector<std::string>& overrides) {
    LoadedScene loaded = load_scene(level, overrides);
    if (!loaded.scene) {
        fmt::print(stderr, "{}\n", loaded.error);
        std::exit(2);
    }
    return std::move(*loaded.scene);
}

}  // namespace

// bench_carom LIST FRAMES LEVEL [STATEMENT]...: the statements replace the level's.
int main(int count, char** arguments) {
    if (count < 4) return 2;
    const SceneList list = read_scene_list(arguments[1]);
    const carom::Scene scene = scene_of(arguments[3], {arguments + 4, arguments + count});
    const carom::SolverSettings settings =
        scene.solver.value_or(carom::pick_solver(scene.world).settings);
    const std::size_t before = heap_bytes();
    Carom engine(scene.world, settings, list.plan.measured_from);
    const Driven driven = drive(engine, list, arguments[2]);
    report(fmt::format("carom, {}", name(settings.kind)), driven);
    fmt::print("heap {}\nmeasured_collisions {}\n", heap_bytes() - before,
               engine.measured_collisions());
}
