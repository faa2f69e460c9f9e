#include "goals.h"

#include <algorithm>
#include <cmath>

#include "figures.h"
#include "physics/solver.h"

namespace carom::bench {
namespace {

// The accuracy of Box2D 3 in a pile.
struct Box2d3Pile {
    double overlap;
    double residual;
};

// For runs without Box2D 3: version 3.2 (AVX2), measured once elsewhere. See docs/performance.md.
Box2d3Pile box2d3_pile_elsewhere(bool has_friction, bool is_large) {
    if (has_friction) return is_large ? Box2d3Pile{0.132, 4e-5} : Box2d3Pile{0.058, 3e-5};
    return is_large ? Box2d3Pile{0.153, 2e-3} : Box2d3Pile{0.058, 6e-4};
}

// Collisions a second of Smallenburg's EDMD (2022), by number of balls. See docs/performance.md.
double edmd(std::size_t balls) {
    if (balls <= 1'000) return 1.16e6;
    return balls <= 10'000 ? 0.59e6 : 0.35e6;
}

const Result* find(const SceneResults& scene, std::string_view name) {
    const auto found = std::ranges::find(
        scene.results, name, [](const Result& result) { return result.contestant.name; });
    return found == scene.results.end() ? nullptr : &*found;
}

class Lines {
  public:
    void at_least(std::string scene, std::string what, double measured, double required,
                  double target) {
        lines_.push_back({std::move(scene), std::move(what), measured, required, target, true});
    }
    void at_most(std::string scene, std::string what, double measured, double required,
                 double target) {
        lines_.push_back({std::move(scene), std::move(what), measured, required, target, false});
    }
    std::vector<GoalLine> take() { return std::move(lines_); }

  private:
    std::vector<GoalLine> lines_;
};

void gas_lines(Lines& lines, const SceneResults& scene) {
    const Result* chipmunk_result = find(scene, chipmunk);
    if (!chipmunk_result) return;
    const std::string& at = scene.scene.name;
    const auto speed = [chipmunk_result](const Result& result) {
        return chipmunk_result->milliseconds_a_tick() / result.milliseconds_a_tick();
    };
    const double box2d3 = scene.scene.box2d3_by_chipmunk;
    if (const Result* discrete = find(scene, "carom discrete")) {
        lines.at_least(at, "discrete: speed / Box2D 3's", box2d3 * speed(*discrete), 7, 15);
        lines.at_least(at, "discrete: speed / Chipmunk's", speed(*discrete), 3, 6);
        lines.at_most(at, "discrete: drift of the energy",
                      std::abs(discrete->accuracy().energy_drift.value_or(1.0)), 1e-12, 1e-12);
    }
    if (const Result* substep = find(scene, "carom substep")) {
        lines.at_least(at, "substep: speed / Box2D 3's", box2d3 * speed(*substep), 3, 5);
        const Result* peer = find(scene, box2d3_wasm);
        if (peer && peer->accuracy().error && substep->accuracy().error) {
            lines.at_most(at, "substep: error after 0.1 s / Box2D 3's",
                          *substep->accuracy().error / *peer->accuracy().error, 0.25, 0.25);
        }
    }
    if (const Result* event = find(scene, "carom event")) {
        lines.at_least(at, "event: speed / Box2D 3's", box2d3 * speed(*event), 6, 12);
        lines.at_least(at, "event: speed / Chipmunk's", speed(*event), 2.5, 5);
        lines.at_most(at, "event: deepest overlap", event->accuracy().deepest_overlap, 1e-9, 1e-9);
    }
}

void pile_lines(Lines& lines, const SceneResults& scene) {
    const Result* chipmunk_result = find(scene, chipmunk);
    const Result* contact = find(scene, "carom contact");
    if (!chipmunk_result || !contact) return;
    const std::string& at = scene.scene.name;
    const bool has_friction = scene.scene.level == "pile-friction.level";
    const Result* box2d3 = find(scene, box2d3_wasm);
    const Box2d3Pile peer =
        box2d3 ? Box2d3Pile{box2d3->accuracy().deepest_overlap, box2d3->accuracy().residual_speed}
               : box2d3_pile_elsewhere(has_friction, scene.balls > 2'000);
    const double time = contact->milliseconds_a_tick() / chipmunk_result->milliseconds_a_tick() /
                        scene.scene.box2d3_by_chipmunk;
    lines.at_most(at, "contact: time / Box2D 3's", time, has_friction ? 1.0 : 0.7,
                  has_friction ? 0.6 : 0.5);
    const double part = has_friction ? 0.45 : 0.5;
    lines.at_most(at, "contact: overlap / Box2D 3's",
                  contact->accuracy().deepest_overlap / peer.overlap, part, part);
    if (has_friction) {
        lines.at_most(at, "contact: residual speed / Box2D 3's",
                      contact->accuracy().residual_speed / peer.residual, 1.0, 1.0);
    }
}

// Only `contact` counts here: `substep` lets the landed balls overlap deeply.
void galton_lines(Lines& lines, const SceneResults& scene) {
    const Result* chipmunk_result = find(scene, chipmunk);
    const Result* contact = find(scene, "carom contact");
    if (!chipmunk_result || !contact) return;
    lines.at_most(scene.scene.name, "contact: time / Box2D 3's",
                  contact->median_seconds() / chipmunk_result->median_seconds() /
                      scene.scene.box2d3_by_chipmunk,
                  0.7, 0.4);
}

void event_lines(Lines& lines, const OwnFigures& own) {
    for (const OwnEvents& events : own.events) {
        if (events.rate != 1.0) continue;
        const std::string at = "gas " + grouped(static_cast<double>(events.balls));
        const double speed = events.collisions_a_second;
        if (events.balls == 10'000)
            lines.at_least(at, "event: million collisions a second", speed / 1e6, 1.0, 2.0);
        lines.at_least(at, "event: collisions a second / EDMD's", speed / edmd(events.balls), 1.5,
                       events.balls <= 1'000    ? 1.5
                       : events.balls <= 10'000 ? 3.0
                                                : 4.0);
    }
}

void growth_lines(Lines& lines, const OwnFigures& own) {
    for (const SolverKind kind : solvers_available()) {
        double few = 0.0;
        double many = 0.0;
        double bytes = 0.0;
        for (const OwnCost& cost : own.costs) {
            if (cost.solver != name(kind)) continue;
            if (cost.balls == 1'000) few = cost.ns_a_ball_tick;
            if (cost.balls == 100'000) many = cost.ns_a_ball_tick;
            if (cost.balls >= 10'000) bytes = std::max(bytes, cost.bytes_a_ball);
        }
        const std::string solver(name(kind));
        if (few > 0.0 && many > 0.0)
            lines.at_most("gas 1,000 to 100,000", solver + ": growth of the cost a ball",
                          many / few, 1.5, 1.2);
        if (bytes > 0.0) lines.at_most("gas", solver + ": bytes a ball", bytes, 400, 200);
    }
}

}  // namespace

Verdict GoalLine::verdict() const {
    const auto reaches = [this](double goal) {
        return more_is_better ? measured >= goal : measured <= goal;
    };
    if (reaches(target)) return Verdict::target_met;
    return reaches(required) ? Verdict::required_met : Verdict::missed;
}

std::vector<GoalLine> goal_lines(const std::vector<SceneResults>& scenes, const OwnFigures& own) {
    Lines lines;
    for (const SceneResults& scene : scenes) {
        switch (scene.scene.sort) {
            case SceneSort::gas:
                gas_lines(lines, scene);
                break;
            case SceneSort::pile:
                pile_lines(lines, scene);
                break;
            case SceneSort::galton:
                galton_lines(lines, scene);
                break;
        }
    }
    event_lines(lines, own);
    growth_lines(lines, own);
    return lines.take();
}

}  // namespace carom::bench
