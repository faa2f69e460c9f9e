#include "game/session/amend_level.h"

#include <fmt/format.h>

#include <algorithm>

#include "game/referees/referee.h"
#include "game/session/written_numbers.h"

namespace carom {
namespace {

// With the values that the ball has where its spec may leave them out.
BallSpec complete_spec(const World& world, std::size_t ball) {
    BallSpec spec = spec_of(world, ball);
    if (!spec.restitution) spec.restitution = world.kinds()[spec.kind].restitution;
    if (!spec.roll) spec.roll = spec.velocity;
    return spec;
}

double spin_at(const World& world, std::size_t ball) {
    return world.balls().spin.empty() ? 0.0 : world.balls().spin[ball];
}

Vec2 roll_at(const World& world, std::size_t ball) {
    const Balls& balls = world.balls();
    return balls.roll.empty() ? balls.velocity[ball] : balls.roll[ball];
}

Side side_at(const World& world, std::size_t edge) {
    return world.capsules().side.empty() ? Side::both : world.capsules().side[edge];
}

/// The reason why no appended statement says what has changed; empty: none is known.
std::string obstacle_of(const Scene& scene, const World& world) {
    if (scene.texts.empty() || scene.texts.front().empty()) return "its text is not known";
    if (scene.overridden) return "options have changed it";
    if (!scene.table.is_empty()) return "it is a pinball table";
    if (referee_of(scene.game)) return "its game begins anew";
    const World& start = scene.world;
    for (std::size_t i = 0; i < world.emitters().size(); ++i)
        if (world.emitters()[i].emitted != start.emitters()[i].emitted)
            return "it has spawned balls";
    if (start.model().gravity && !(world.model().gravity == start.model().gravity))
        return "its gravity has changed";
    return {};
}

class AmendmentWriter {
  public:
    AmendmentWriter(const Scene& scene, const World& world)
        : scene_(scene), world_(world), units_(scene.unit != LengthUnit::natural) {}

    std::string write() {
        if (!(world_.model().gravity == scene_.world.model().gravity))
            text_ += "use gravity " + with_unit(*world_.model().gravity, "m/s2") + "\n";
        changed_balls();
        changed_edges();
        changed_motions();
        changed_seesaws();
        added_edges();
        added_balls();
        return std::move(text_);
    }

  private:
    std::string with_unit(const auto& value, std::string_view unit) const {
        return units_.text(value, unit);
    }
    std::string place(Vec2 value) const { return with_unit(value, "m"); }

    std::string ball_name(BallId id) const {
        const std::uint32_t i = number(id);
        const bool has_name = i < scene_.ball_names.size() && !scene_.ball_names[i].empty();
        return has_name ? scene_.ball_names[i] : fmt::format("ball={}", i);
    }

    std::string edge_name(CapsuleId id) const {
        const std::uint32_t i = number(id);
        if (i < scene_.edge_names.size() && !scene_.edge_names[i].empty())
            return scene_.edge_names[i];
        return fmt::format("edge={}", scene_.edge_numbers.empty() ? i : scene_.edge_numbers[i]);
    }

    void changed_balls() {
        const World& start = scene_.world;
        for (std::size_t i = 0; i < start.balls().size(); ++i) {
            const BallId id = start.balls().id[i];
            const auto now = index_of(world_, id);
            if (!now)
                text_ += fmt::format("remove {}\n", ball_name(id));
            else
                changed_ball(i, *now);
        }
    }

    void changed_ball(std::size_t before, std::size_t now) {
        const World& start = scene_.world;
        const Balls& balls = world_.balls();
        std::string changes;
        if (!(balls.position[now] == start.balls().position[before]))
            changes += " at=" + place(balls.position[now]);
        if (!(balls.velocity[now] == start.balls().velocity[before]))
            changes += " v=" + with_unit(balls.velocity[now], "m/s");
        if (spin_at(world_, now) != spin_at(start, before))
            changes += " w=" + units_.spin_text(spin_at(world_, now));
        // Without roll= a ball rolls as it moves, also after a new velocity.
        if (!balls.roll.empty() && (!(roll_at(world_, now) == roll_at(start, before)) ||
                                    !(roll_at(world_, now) == balls.velocity[now])))
            changes += " roll=" + with_unit(roll_at(world_, now), "m/s");
        if (!changes.empty())
            text_ += fmt::format("move {}{}\n", ball_name(balls.id[now]), changes);
    }

    void changed_edges() {
        const Capsules& before = scene_.world.capsules();
        for (std::size_t i = 0; i < before.size(); ++i) {
            const auto now = index_of(world_, before.id[i]);
            if (!now) {
                text_ += fmt::format("remove {}\n", edge_name(before.id[i]));
                continue;
            }
            if (moves_by_itself(world_, before.id[i])) continue;
            const Capsule& shape = world_.capsules().shape[*now];
            if (!(shape.start == before.shape[i].start) || !(shape.end == before.shape[i].end))
                text_ += fmt::format("move {} {} {}\n", edge_name(before.id[i]), place(shape.start),
                                     place(shape.end));
        }
    }

    void changed_motions() {
        for (std::size_t i = 0; i < world_.movers().size(); ++i) {
            const Mover& before = scene_.world.movers()[i];
            const Mover& now = world_.movers()[i];
            if (now.clock == before.clock && now.runs == before.runs) continue;
            text_ += fmt::format("move {} time={}{}\n", scene_.mover_names[i],
                                 with_unit(now.clock, "s"), now.runs ? " runs" : " waits");
        }
    }

    void changed_seesaws() {
        for (const Seesaw& now : world_.seesaws()) {
            const auto index = seesaw_of(scene_.world, now.capsule);
            if (!index) continue;
            const Seesaw& before = scene_.world.seesaws()[*index];
            if (now.angle == before.angle && now.rate == before.rate) continue;
            text_ +=
                fmt::format("move {} tilt={} turning={}\n", edge_name(now.capsule),
                            with_unit(degrees_of(now.angle), "deg"), units_.spin_text(now.rate));
        }
    }

    void added_edges() {
        const Capsules& capsules = world_.capsules();
        for (std::size_t i = 0; i < capsules.size(); ++i) {
            if (index_of(scene_.world, capsules.id[i])) continue;
            const Capsule& shape = capsules.shape[i];
            const std::string& material = scene_.material_names[capsules.material[i]];
            text_ +=
                fmt::format("edge {}r={} {} {}\n", material == "edge" ? "" : material + " ",
                            with_unit(shape.radius, "m"), place(shape.start), place(shape.end));
        }
    }

    void added_balls() {
        const Balls& balls = world_.balls();
        for (std::size_t i = 0; i < balls.size(); ++i) {
            if (index_of(scene_.world, balls.id[i])) continue;
            const std::string& kind = scene_.kind_names[balls.kind[i]];
            text_ += fmt::format(
                "ball {}at={} v={} r={} m={}", kind == "ball" ? "" : "kind=" + kind + " ",
                place(balls.position[i]), with_unit(balls.velocity[i], "m/s"),
                with_unit(balls.radius[i], "m"), with_unit(mass_of(balls.inverse_mass[i]), "kg"));
            text_ += written_properties(world_, i, units_) + '\n';
        }
    }

    const Scene& scene_;
    const World& world_;
    UnitWriter units_;
    std::string text_;
};

}  // namespace

AmendedLevel amended_level(const Scene& scene, const World& world) {
    if (std::string why = obstacle_of(scene, world); !why.empty())
        return {std::nullopt, std::move(why)};
    std::string text = scene.texts.front();
    const std::string changes = AmendmentWriter(scene, world).write();
    if (changes.empty()) return {std::move(text), {}};
    if (text.back() != '\n') text += '\n';
    text += fmt::format("\n# Changed in play, at {:.3f} s.\n{}", world.time(), changes);
    return {std::move(text), {}};
}

World edited_start(const Scene& scene, const World& world, std::span<const TimedCommand> commands) {
    World start = scene.world;
    const std::vector<CapsuleId> edges = start.capsules().id;
    for (const CapsuleId id : edges) {
        const auto now = index_of(world, id);
        if (!now)
            remove_capsule(start, id);
        else if (!moves_by_itself(world, id))
            start.edit_capsules().shape[*index_of(start, id)] = world.capsules().shape[*now];
    }
    const Capsules& now = world.capsules();
    for (std::size_t i = 0; i < now.size(); ++i)
        if (!index_of(scene.world, now.id[i]))
            add_capsule(start, now.shape[i], now.material[i], side_at(world, i));
    for (const TimedCommand& timed : commands) {
        const bool is_of_balls = std::holds_alternative<command::AddBall>(timed.command) ||
                                 std::holds_alternative<command::PlaceBall>(timed.command) ||
                                 std::holds_alternative<command::RemoveBall>(timed.command);
        if (is_of_balls && !refusal(start, timed.command)) execute(start, timed.command);
    }
    start.edit_definition().model.gravity = world.model().gravity;
    return start;
}

bool has_same_bodies(const World& a, const World& b) {
    const Balls& balls = a.balls();
    const Capsules& edges = a.capsules();
    if (balls.size() != b.balls().size() || edges.size() != b.capsules().size()) return false;
    if (!(a.model().gravity == b.model().gravity)) return false;
    const auto is_alike = [](const Mover& one, const Mover& other) {
        return one.clock == other.clock && one.runs == other.runs;
    };
    if (!std::ranges::equal(a.movers(), b.movers(), is_alike)) return false;
    const auto turns_alike = [](const Seesaw& one, const Seesaw& other) {
        return one.angle == other.angle && one.rate == other.rate && one.inertia == other.inertia;
    };
    if (!std::ranges::equal(a.seesaws(), b.seesaws(), turns_alike)) return false;
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (!(complete_spec(a, i) == complete_spec(b, i))) return false;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!(edges.shape[i].start == b.capsules().shape[i].start) ||
            !(edges.shape[i].end == b.capsules().shape[i].end) ||
            edges.shape[i].radius != b.capsules().shape[i].radius ||
            edges.material[i] != b.capsules().material[i] || side_at(a, i) != side_at(b, i))
            return false;
    return true;
}

}  // namespace carom
