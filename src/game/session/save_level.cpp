// The file is long since it is one writer: the statements of a level in their order, which share
// the names of kinds and materials. edge_lines.h finds what each line of edges states.

#include "game/session/save_level.h"

#include <fmt/format.h>

#include <algorithm>

#include "game/referees/referee.h"
#include "game/session/edge_lines.h"
#include "game/session/written_numbers.h"
#include "geometry/elementary.h"
#include "level/text/joined.h"
#include "level/values/color_names.h"
#include "physics/tick/totals.h"

namespace carom {
namespace {

/// The number of points after which a line is broken.
constexpr std::size_t points_a_line = 6;

class LevelWriter {
  public:
    /// `world` has the edges of movers and seesaws at home, where the level is to write them.
    LevelWriter(const Scene& scene, const World& world, bool has_overlap)
        : scene_(scene),
          dress_(scene.dress),
          world_(world),
          has_units_(scene.unit != LengthUnit::natural),
          units_(has_units_),
          has_overlap_(has_overlap) {}

    std::string write() {
        name_classes();
        head();
        model();
        classes();
        edges();
        motions();
        seesaws();
        zones();
        balls();
        cue();
        emitters();
        shows();
        dress();
        return std::move(text_);
    }

  private:
    template <typename... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        text_ += fmt::format(format, std::forward<Arguments>(arguments)...);
        text_ += '\n';
    }

    std::string with_unit(const auto& value, std::string_view unit) const {
        return units_.text(value, unit);
    }
    static std::string place(Vec2 value) { return fmt::format("{},{}", value.x, value.y); }

    void head() {
        line("carom 1 \"{}\"", scene_.title);
        for (const std::string& comment : scene_.comment)
            line("#{}{}", comment.empty() ? "" : " ", comment);
        line("");
        if (has_units_) line("units m");
        line("rate {}", world_.rate());
        line("seed {}", world_.seed());
        if (scene_.solver) line("solver {}", settings_text(*scene_.solver, SettingsText::used));
        const Need& need = world_.definition().need;
        if (need.tolerance) line("tolerance {}r within {}s", *need.tolerance, need.within);
        if (need.budget) line("budget {}s", *need.budget);
        // A game of pool needs a rack, but the balls are written one by one here.
        if (scene_.game != "sandbox" && !referee_of(scene_.game)) line("game {}", scene_.game);
        line("world {} {}", place(scene_.view.low), place(scene_.view.high));
    }

    void model() {
        const Model& model = world_.model();
        if (model.gravity) line("use gravity {}", with_unit(*model.gravity, "m/s2"));
        if (model.drag) line("use drag {}", with_unit(*model.drag, "/s"));
        if (model.stop_speed) line("use stop {}", with_unit(*model.stop_speed, "m/s"));
        if (model.speed_limit) line("use limit {}", with_unit(*model.speed_limit, "m/s"));
        if (model.scatter) line("use scatter {}", with_unit(degrees_of(*model.scatter), "deg"));
        if (model.spin) line("use spin inertia={}", *model.spin);
        if (model.cloth)
            line("use cloth slide={} roll={} spin={} g={}", model.cloth->slide, model.cloth->roll,
                 with_unit(has_units_ ? spin_of(model.cloth->spin) : model.cloth->spin, "rad/s2"),
                 with_unit(model.cloth->gravity, "m/s2"));
        if (model.modulus) line("use modulus {} poisson=0", with_unit(*model.modulus, "Pa"));
        if (model.wrap) line("use wrap");
        if (has_overlap_) line("use overlap");
    }

    // "ball" and "edge" may name the kind and the material of unnamed bodies. They read back
    // unchanged, except in `collide`, where these words mean all balls and all edges.
    void name_classes() {
        kinds_ = scene_.kind_names;
        materials_ = scene_.material_names;
        if (!world_.model().filtered) return;
        for (std::vector<std::string>* names : {&kinds_, &materials_})
            for (std::string& name_text : *names)
                while (name_text == "ball" || name_text == "edge" ||
                       std::ranges::count(kinds_, name_text) +
                               std::ranges::count(materials_, name_text) >
                           1)
                    name_text += '_';
    }

    void classes() {
        for (std::size_t i = 0; i < world_.kinds().size(); ++i) {
            const Kind& kind = world_.kinds()[i];
            line("kind {} r={} m={} e={}{}{}", kinds_[i], kind.radius, with_unit(kind.mass, "kg"),
                 kind.restitution, friction(kind.friction), color(color_in(dress_.kinds, i)));
        }
        for (std::size_t i = 0; i < world_.materials().size(); ++i) {
            const Material& material = world_.materials()[i];
            line("material {} e={} soften={}{}{}", materials_[i], material.restitution,
                 with_unit(material.soften, "s/m"), friction(material.friction),
                 color(color_in(dress_.materials, i)));
        }
        if (!world_.model().filtered) return;
        std::vector<std::string> names = kinds_;
        names.insert(names.end(), materials_.begin(), materials_.end());
        for (std::size_t a = 0; a < world_.kinds().size(); ++a)
            for (std::size_t b = a; b < names.size(); ++b)
                if (world_.definition().meets[a * names.size() + b])
                    line("collide {} {}", names[a], names[b]);
    }

    static std::string friction(double coefficient) {
        return coefficient > 0.0 ? fmt::format(" mu={}", coefficient) : "";
    }

    static std::string color(const std::optional<Rgb24>& of, std::string_view key = "color") {
        return of ? fmt::format(" {}={}", key, color_text(*of)) : "";
    }

    void edges() {
        for (const EdgeLine& edge_line : edge_lines(scene_, world_))
            edge(edge_line);
    }

    void edge(const EdgeLine& of) {
        const Capsules& capsules = world_.capsules();
        const Capsule& shape = capsules.shape[of.first];
        const std::string_view group = group_of_edge(scene_, capsules.id[of.first]);
        const std::string names = materials_[capsules.material[of.first]] +
                                  (group.empty() ? "" : " ") + std::string(group);
        const std::string painted = color(color_of_edge(scene_, world_, of.first));
        if (shape.start == shape.end)
            return line("peg {} at={} r={}{}", names, place(shape.start), shape.radius, painted);
        // A drop target that is down is written as a standing one.
        constexpr std::string_view sides[] = {"", " side=left", " side=right", ""};
        const auto side = static_cast<std::size_t>(side_of_edge(world_, of.first));
        text_ += fmt::format("edge {} r={}{}{} {}", names, shape.radius, sides[side], painted,
                             place(shape.start));
        for (std::size_t i = of.first; i <= of.last - (of.closes ? 1 : 0); ++i) {
            if ((i - of.first) % points_a_line == points_a_line - 1) text_ += " \\\n   ";
            text_ += " " + place(capsules.shape[i].end);
        }
        if (of.is_smooth) text_ += " smooth";
        text_ += of.closes ? " close\n" : "\n";
    }

    void motions() {
        for (std::size_t i = 0; i < world_.movers().size(); ++i)
            if (!world_.movers()[i].edges.empty()) motion(world_.movers()[i], i);
    }

    // A mover that turns once in a round turns by 2 pi; one that swings, by any angle.
    void motion(const Mover& mover, std::size_t number_of) {
        std::vector<std::string_view> names{scene_.mover_names[number_of]};
        for (const MovedEdge& edge : mover.edges)
            if (!std::ranges::count(names, group_of_edge(scene_, edge.capsule)))
                names.push_back(group_of_edge(scene_, edge.capsule));
        const bool turns = mover.path.empty();
        const bool slides = !mover.is_round && mover.path.size() == 2;
        text_ += fmt::format("motion {} {}",
                             turns && mover.is_round ? "turn"
                             : turns                 ? "swing"
                             : slides                ? "slide"
                                                     : "path",
                             joined(names, " "));
        if (turns) text_ += " about=" + place(mover.pivot);
        if (turns && !mover.is_round) text_ += " by=" + with_unit(degrees_of(mover.angle), "deg");
        if (slides) text_ += " by=" + place(mover.path.back());
        if (!turns && !slides)
            for (std::size_t p = 0; p < mover.path.size() - (mover.is_round ? 1 : 0); ++p)
                text_ += " " + place(mover.path[p]);
        text_ += " every=" + with_unit(mover.period, "s");
        if (turns && mover.is_round && mover.angle < 0.0) text_ += " clockwise";
        if (!turns && !slides && mover.is_round) text_ += " close";
        if (mover.is_steady) text_ += " steady";
        if (mover.stops > 0) text_ += fmt::format(" stops={}", mover.stops);
        if (mover.clock > 0.0) text_ += " time=" + with_unit(mover.clock, "s");
        text_ += mover.runs ? "\n" : " waits\n";
    }

    void seesaws() {
        for (const Seesaw& seesaw : world_.seesaws()) {
            text_ += fmt::format("seesaw {} about={} m={}", group_of_edge(scene_, seesaw.capsule),
                                 place(seesaw.pivot), with_unit(mass_of_seesaw(seesaw), "kg"));
            if (std::isfinite(seesaw.least)) text_ += " from=" + angle(seesaw.least);
            if (std::isfinite(seesaw.most)) text_ += " to=" + angle(seesaw.most);
            line(" e={} tilt={} turning={}", seesaw.stop_restitution, angle(seesaw.angle),
                 units_.spin_text(seesaw.rate));
        }
    }

    std::string angle(double radians) const { return with_unit(degrees_of(radians), "deg"); }

    // In the order of their counters, which the loader keeps.
    void zones() {
        for (std::size_t i = 0; i < world_.zones().size(); ++i) {
            const Zone& zone = world_.zones()[i];
            const std::string& full = scene_.zone_names[i];
            if (std::ranges::count(scene_.pool.pockets, i)) {
                line("pocket {} at={} r={}", full.substr(0, full.rfind('.')),
                     place(zone.shape.start), zone.shape.radius);
                continue;
            }
            line("zone {} {} {} r={}{}{}", full.substr(0, full.rfind('.')), place(zone.shape.start),
                 place(zone.shape.end), zone.shape.radius, color(color_in(dress_.zones, i)),
                 zone.effect == Zone::Effect::sink ? " sink" : "");
        }
    }

    void balls() {
        const Balls& balls = world_.balls();
        for (std::size_t i = 0; i < balls.size(); ++i) {
            const std::uint32_t id = number(balls.id[i]);
            std::string name_text;
            if (id < scene_.ball_names.size()) name_text = scene_.ball_names[id];
            text_ += "ball ";
            // Suffixed names belong to copies; here each ball is a statement of its own.
            std::ranges::replace(name_text, '.', '_');
            if (!name_text.empty()) text_ += name_text + " ";
            const Kind& kind = world_.kinds()[balls.kind[i]];
            text_ += fmt::format("kind={} at={} v={}", kinds_[balls.kind[i]],
                                 place(balls.position[i]), with_unit(balls.velocity[i], "m/s"));
            if (balls.radius[i] != kind.radius) text_ += fmt::format(" r={}", balls.radius[i]);
            if (balls.inverse_mass[i] != 1.0 / kind.mass)
                text_ += " m=" + with_unit(mass_of(balls.inverse_mass[i]), "kg");
            text_ +=
                written_properties(world_, i, units_) + color(color_in(dress_.balls, id)) + '\n';
        }
    }

    void cue() {
        const auto& cue = scene_.pool.cue;
        if (!cue || !index_of(world_, cue->ball)) return;
        std::string name_text = scene_.ball_names[number(cue->ball)];
        std::ranges::replace(name_text, '.', '_');
        line("cue ball={} power={}..{}", name_text, with_unit(cue->least_power, "m/s"),
             with_unit(cue->most_power, "m/s"));
    }

    void emitters() {
        for (const Emitter& emitter : world_.emitters()) {
            if (emitter.emitted >= emitter.count) continue;
            line("spawn {} at={} v={} jitter={} vjitter={} every={} count={}", kinds_[emitter.kind],
                 place(emitter.at), with_unit(emitter.velocity, "m/s"), place(emitter.jitter),
                 with_unit(emitter.velocity_jitter, "m/s"), with_unit(emitter.every, "s"),
                 emitter.count - emitter.emitted);
        }
    }

    void shows() {
        for (const Show& show : scene_.shows) {
            if (show.what == Show::What::energy)
                line("show energy");
            else if (show.what == Show::What::observable)
                line("show {}", row_of(show.observable).name);
            else
                line("show histogram of={}{}{}", show.of,
                     show.against.empty() ? "" : " against=", show.against);
        }
        const Observation& observation = scene_.observation;
        if (observation.what.is_empty() && observation.from == 0.0) return;
        text_ += "observe";
        for (const ObservableRow& row : observables())
            if (observation.what.has(row.what)) text_ += fmt::format(" {}", row.name);
        text_ += observation.from > 0.0 ? fmt::format(" from={}s\n", observation.from) : "\n";
    }

    void dress() {
        const BoardTheme& theme = dress_.theme;
        if (theme.board || theme.rail || theme.edge)
            line("theme{}{}{}", color(theme.board, "board"), color(theme.rail, "rail"),
                 color(theme.edge, "edge"));
        for (const PaintedArea& area : dress_.areas)
            paint(area);
        constexpr std::string_view aligns[] = {"", " align=left", " align=right"};
        for (const BoardLabel& label : dress_.labels)
            line("label \"{}\" at={}{}{}", label.text, place(label.at),
                 aligns[static_cast<std::size_t>(label.align)], color(label.color));
    }

    static std::string layer(int number) {
        return number > 0 ? fmt::format(" layer={}", number) : "";
    }

    void paint(const PaintedArea& area) {
        if (area.corners.empty())
            return line("paint circle at={} r={}{}{}", place(area.disc.center), area.disc.radius,
                        color(area.color), layer(area.layer));
        text_ += "paint polygon" + color(area.color) + layer(area.layer);
        for (std::size_t i = 0; i < area.corners.size(); ++i) {
            if (i % points_a_line == points_a_line - 1) text_ += " \\\n   ";
            text_ += " " + place(area.corners[i]);
        }
        text_ += '\n';
    }

    const Scene& scene_;
    const Dress& dress_;
    const World& world_;
    bool has_units_;
    UnitWriter units_;
    bool has_overlap_;
    std::vector<std::string> kinds_;
    std::vector<std::string> materials_;
    std::string text_;
};

}  // namespace

std::string level_text(const Scene& scene, const World& world) {
    const bool has_overlap = deepest_overlap(world) > 0.0;
    if (world.movers().empty() && world.seesaws().empty())
        return LevelWriter(scene, world, has_overlap).write();
    World at_home = world;
    for (const Seesaw& seesaw : world.seesaws())
        if (const auto index = index_of(world, seesaw.capsule))
            at_home.edit_capsules().shape[*index] = seesaw.home;
    for (const Mover& mover : world.movers())
        for (const MovedEdge& edge : mover.edges)
            if (const auto index = index_of(world, edge.capsule))
                at_home.edit_capsules().shape[*index] = edge.home;
    return LevelWriter(scene, at_home, has_overlap).write();
}

}  // namespace carom
