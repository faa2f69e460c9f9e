#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "level/ir/numbers.h"
#include "level/statements/builders.h"
#include "level/statements/rules.h"
#include "level/text/spelling.h"
#include "level/text/utf8.h"

namespace carom {
namespace {

// A name that is free for a kind or a material.
bool is_free(const Word& name, Context& context) {
    Reporter& reporter = context.reporter;
    if (!is_identifier(name.text)) {
        reporter.error(name.span(), fmt::format("'{}' is not a name", name.text),
                       "a name has letters, digits and '_', and begins with a letter");
        return false;
    }
    if (context.ir.kinds.size() + context.ir.materials.size() >= max_classes) {
        reporter.error(name.span(),
                       fmt::format("the level has more than {} kinds and materials", max_classes),
                       "use fewer");
        return false;
    }
    const auto taken = [&](const Word& by) {
        if (by.text != name.text) return false;
        reporter.error(name.span(),
                       fmt::format("the name '{}' is taken, in line {}", name.text, by.line),
                       "give each kind and each material a name of its own");
        return true;
    };
    for (const KindIr& kind : context.ir.kinds) {
        if (taken(kind.name)) return false;
    }
    for (const MaterialIr& material : context.ir.materials) {
        if (taken(material.name)) return false;
    }
    return true;
}

void declare_kind(const Arguments& a, Context& context) {
    if (a.plain.empty() || !is_free(a.plain.front(), context)) return;
    KindIr kind;
    kind.name = a.plain.front();
    kind.radius = a.number("r");
    kind.mass = a.number("m");
    kind.density = a.number("density");
    kind.restitution = a.number("e");
    kind.friction = a.number_or("mu", 0.0);
    kind.is_valid = a.is_valid;
    context.ir.kinds.push_back(std::move(kind));
}

void declare_material(const Arguments& a, Context& context) {
    if (a.plain.empty() || !is_free(a.plain.front(), context)) return;
    context.ir.materials.push_back(
        {a.plain.front(),
         {a.number_or("e", 1.0), a.number_or("soften", 0.0), a.number_or("mu", 0.0)},
         static_cast<std::uint8_t>(a.number_or("layer", 0.0))});
}

// The one number of "use drag 0.1" and its like; 0 is the same as no such line.
void set_positive(const Arguments& a, Measure measure, Bound bound, const Scope& scope,
                  std::optional<double>& setting, Context& context) {
    const auto number = read_number(a.plain.front(), {}, measure, bound, scope, context);
    if (number) setting = *number > 0.0 ? number : std::nullopt;
}

void declare_use(const Arguments& a, const Scope& scope, Context& context) {
    LevelSettings& s = context.ir.settings;
    const std::string_view term = a.statement->name.substr(4);
    if (term == "gravity") {
        s.gravity = a.points[0] == Vec2{} ? std::nullopt : std::optional(a.points[0]);
    } else if (term == "drag") {
        set_positive(a, Measure::rate, Bound::not_negative, scope, s.drag, context);
    } else if (term == "stop") {
        set_positive(a, Measure::speed, Bound::not_negative, scope, s.stop_speed, context);
    } else if (term == "limit") {
        set_positive(a, Measure::speed, Bound::positive, scope, s.speed_limit, context);
    } else if (term == "scatter") {
        const Word& word = a.plain.front();
        const auto degrees =
            read_number(word, {}, Measure::angle, Bound::not_negative, scope, context);
        if (degrees && *degrees > 90.0) {
            context.reporter.error(word.span(),
                                   fmt::format("scatter must be 90 degrees at most, "
                                               "but is {:.6g}",
                                               *degrees),
                                   "write an angle such as 20deg");
        } else if (degrees) {
            s.scatter = *degrees > 0.0 ? std::optional(*degrees * pi / 180.0) : std::nullopt;
        }
    } else if (term == "cloth") {
        declare_cloth(a, context);
    } else if (term == "wrap") {
        s.wrap = a.node->keyword().span();
    } else if (term == "overlap") {
        s.may_overlap = true;
    }
}

bool has_setting(SolverKind solver, std::string_view key) {
    if (key == "updates" || key == "steps") return solver == SolverKind::substep;
    return key != "substeps" || solver == SolverKind::swept || solver == SolverKind::contact;
}

void declare_solver(const Arguments& a, Context& context) {
    const Word& word = a.plain.front();
    const std::optional<SolverKind> kind = solver_named(word.text);
    std::vector<std::string_view> known;
    for (const SolverKind available : solvers_available())
        known.push_back(name(available));
    const std::string offer = fmt::format("there are: {}", fmt::join(known, " "));
    if (!kind) {
        context.reporter.error(word.span(), fmt::format("there is no solver '{}'", word.text),
                               did_you_mean(word.text, known, offer));
        return;
    }
    for (const auto& [key, argument] : a.values) {
        if (has_setting(*kind, key)) continue;
        context.reporter.error(argument.value.span(), fmt::format("{} has no {}", word.text, key),
                               fmt::format("leave {}= out", key));
    }
    SolverSettings settings;
    settings.kind = *kind;
    settings.updates = static_cast<int>(a.number_or("updates", settings.updates));
    settings.steps = static_cast<int>(a.number_or("steps", settings.steps));
    set_substeps(settings, static_cast<int>(a.number_or("substeps", substeps_of(settings))));
    context.ir.settings.solver = settings;
}

void declare_rate(const Arguments& a, const Scope& scope, Context& context) {
    constexpr double fastest = 1e9;
    const Word& word = a.plain.front();
    const auto rate =
        read_number(word, {"rate", " "}, Measure::frequency, Bound::positive, scope, context);
    if (!rate) return;
    if (*rate > fastest || *rate < 1e-3) {
        context.reporter.error(word.span(), fmt::format("rate is out of range: {:.6g}", *rate),
                               "write ticks a second, from 0.001 to 1e9");
        return;
    }
    context.ir.settings.rate = rate;
}

void declare_seed(const Arguments& a, const Scope& scope, Context& context) {
    const Word& word = a.plain.front();
    std::uint64_t seed = 0;
    const char* end = word.text.data() + word.text.size();
    const auto [stop, fault] = std::from_chars(word.text.data(), end, seed);
    if (fault == std::errc{} && stop == end) {
        context.ir.settings.seed = seed;
        return;
    }
    const auto number =
        read_number(word, {"seed", " "}, Measure::whole, Bound::not_negative, scope, context);
    if (number) context.ir.settings.seed = static_cast<std::uint64_t>(*number);
}

void declare_game(const Arguments& a, Context& context) {
    const Word& word = a.plain.front();
    context.ir.settings.game_at = word.span();
    const bool is_pinball = word.text == "pinball";
    const bool is_pool = word.text == "eightball" || word.text == "nineball";
    if (!is_pinball && !is_pool && !a.values.empty()) {
        context.reporter.error(word.span(), fmt::format("game {} has no keys", word.text),
                               "balls=, save=, tilt= and the like belong to game pinball, race= "
                               "and clock= to games of pool");
        return;
    }
    for (const auto& [key, value] : a.values) {
        const bool is_of_pool = key == "race" || key == "clock";
        if (is_of_pool == is_pool) continue;
        context.reporter.error(a.span_of(key), fmt::format("game {} has no {}=", word.text, key),
                               is_pool ? "a game of pool has race= and clock="
                                       : "race= and clock= belong to games of pool");
        return;
    }
    if (is_pinball || is_pool || word.text == "sandbox" || word.text == "galton") {
        context.ir.settings.game = std::string(word.text);
        if (is_pinball) declare_pinball(a, context);
        if (a.has("race")) context.ir.settings.race = a.count("race");
        context.ir.settings.clock = a.number_or("clock", 0.0);
        return;
    }
    context.reporter.error(
        word.span(), fmt::format("there is no game '{}'", word.text),
        did_you_mean(word.text, {"sandbox", "galton", "eightball", "nineball", "pinball"},
                     "there are: sandbox galton eightball nineball pinball"));
}

void declare_legend(const Arguments& a, Legends& legends, Context& context) {
    const Word& letter = a.plain.front();
    if (characters(letter.text) != 1) {
        context.reporter.error(letter.span(), "a legend explains one letter",
                               "write it as in: legend ball x kind=red");
        return;
    }
    Legend legend;
    const std::string_view what = a.statement->name.substr(7);
    legend.what = what == "ball"  ? Legend::What::ball
                  : what == "peg" ? Legend::What::peg
                                  : Legend::What::solid;
    legend.kind = a.word("kind");
    legend.material = a.word("material");
    legend.radius = a.number("r");
    legend.velocity = a.pair_or("v", {});
    legends[std::string(letter.text)] = legend;
}

void declare_show(const Arguments& a, Context& context) {
    ShowIr show;
    show.what = a.statement->name == "show energy" ? Show::What::energy : Show::What::histogram;
    show.of = a.word("of");
    show.against = a.word("against");
    show.span = a.node->keyword().span();
    context.ir.shows.push_back(std::move(show));
}

void declare_expect(const Arguments& a, const Scope& scope, Context& context) {
    if (a.plain[2].text != "within") {
        context.reporter.error(a.plain[2].span(),
                               fmt::format("'{}' stands where 'within' is wanted", a.plain[2].text),
                               "write it as: expect QUANTITY VALUE within TOLERANCE");
        return;
    }
    const auto value = read_number(a.plain[1], {}, Measure::result, Bound::any, scope, context);
    const auto tolerance = read_number(a.plain[3], {"the tolerance", ""}, Measure::result,
                                       Bound::not_negative, scope, context);
    if (!value || !tolerance) return;
    context.ir.expects.push_back({a.plain[0], *value, *tolerance, a.number("at")});
}

}  // namespace

bool declare(const Arguments& a, const Scope& scope, Legends& legends, Context& context) {
    const std::string_view name = a.statement->name;
    // A kind, a material or spin with a mistake exists all the same: only the mistake is told.
    if (name == "kind") return declare_kind(a, context), true;
    if (name == "material") return declare_material(a, context), true;
    if (name == "use spin") {
        context.ir.settings.spin = a.number_or("inertia", 0.5);
        context.ir.settings.inertia = a.number("inertia");
    }
    const bool is_use = name.substr(0, 4) == "use ";
    const bool is_legend = name.substr(0, 7) == "legend ";
    const bool is_show = name.substr(0, 5) == "show ";
    const bool is_known = is_use || is_legend || is_show || name == "collide" || name == "solver" ||
                          name == "rate" || name == "seed" || name == "game" || name == "expect" ||
                          name == "cue" || name == "on";
    if (!is_known || !a.is_valid) return is_known;
    if (is_use) declare_use(a, scope, context);
    if (is_legend) declare_legend(a, legends, context);
    if (is_show) declare_show(a, context);
    if (name == "collide") context.ir.collides.push_back({a.plain[0], a.plain[1]});
    if (name == "solver") declare_solver(a, context);
    if (name == "rate") declare_rate(a, scope, context);
    if (name == "seed") declare_seed(a, scope, context);
    if (name == "game") declare_game(a, context);
    if (name == "cue") declare_cue(a, context);
    if (name == "on") declare_rule(a, scope, context);
    if (name == "expect") declare_expect(a, scope, context);
    return true;
}

}  // namespace carom
