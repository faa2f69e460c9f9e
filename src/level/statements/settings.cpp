#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "level/ir/arguments.h"
#include "level/ir/numbers.h"
#include "level/statements/families.h"
#include "level/text/joined.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

void set_world(const Arguments& arguments, const Frame&, Context& context) {
    const Vec2 a = arguments.points[0];
    const Vec2 b = arguments.points[1];
    if (a.x < b.x && a.y < b.y) {
        context.ir.settings.world = Box{a, b};
        return;
    }
    context.reporter.error("world-empty", arguments.point_words[1].span(), "the world is empty",
                           "write its lower left corner, then its upper right one");
}

void set_gravity(const Arguments& arguments, const Frame&, Context& context) {
    const Vec2 gravity = arguments.points[0];
    context.ir.settings.gravity = gravity == Vec2{} ? std::nullopt : std::optional(gravity);
}

// Sets the one number of "use drag 0.1" and the like; 0 turns the term off.
void set_term(const Arguments& arguments, Measure measure, Bound bound, const Frame& frame,
              std::optional<double>& setting, Context& context) {
    const auto number =
        read_number(arguments.plain.front(), {}, measure, bound, *frame.scope, context);
    if (number) setting = *number > 0.0 ? number : std::nullopt;
}

void set_drag(const Arguments& arguments, const Frame& frame, Context& context) {
    set_term(arguments, Measure::rate, Bound::not_negative, frame, context.ir.settings.drag,
             context);
}

void set_stop_speed(const Arguments& arguments, const Frame& frame, Context& context) {
    set_term(arguments, Measure::speed, Bound::not_negative, frame, context.ir.settings.stop_speed,
             context);
}

void set_speed_limit(const Arguments& arguments, const Frame& frame, Context& context) {
    set_term(arguments, Measure::speed, Bound::positive, frame, context.ir.settings.speed_limit,
             context);
}

void set_scatter(const Arguments& arguments, const Frame& frame, Context& context) {
    const Word& word = arguments.plain.front();
    const auto degrees =
        read_number(word, {}, Measure::angle, Bound::not_negative, *frame.scope, context);
    if (!degrees) return;
    if (*degrees > 90.0) {
        context.reporter.error(
            "scatter-too-wide", word.span(),
            fmt::format("scatter must be 90 degrees at most, but is {:.6g}", *degrees),
            "write an angle such as 20deg");
        return;
    }
    context.ir.settings.scatter =
        *degrees > 0.0 ? std::optional(*degrees * pi / 180.0) : std::nullopt;
}

void set_wrap(const Arguments& arguments, const Frame&, Context& context) {
    context.ir.settings.wrap = arguments.node->keyword().span();
}

void allow_overlap(const Arguments&, const Frame&, Context& context) {
    context.ir.settings.may_overlap = true;
}

void set_spin(const Arguments& arguments, const Frame&, Context& context) {
    context.ir.settings.spin = arguments.number_or("inertia", 0.5);
    context.ir.settings.inertia = arguments.number("inertia");
}

void set_cloth(const Arguments& arguments, const Frame&, Context& context) {
    Cloth cloth;
    cloth.slide = arguments.number_or("slide", cloth.slide);
    cloth.roll = arguments.number_or("roll", cloth.roll);
    cloth.spin = arguments.number_or("spin", cloth.spin);
    if (!arguments.has("g") && context.unit == LengthUnit::natural) {
        context.reporter.error("cloth-without-gravity", arguments.node->keyword().span(),
                               "use cloth needs g= where the level has no units",
                               "write how hard the table is pressed on, such as g=10");
    }
    cloth.gravity = arguments.number_or("g", cloth.gravity);
    context.ir.settings.cloth = cloth;
    context.ir.settings.cloth_at = arguments.node->keyword().span();
}

void set_modulus(const Arguments& arguments, const Frame& frame, Context& context) {
    const auto young = read_number(arguments.plain.front(), {}, Measure::modulus, Bound::positive,
                                   *frame.scope, context);
    if (!young) return;
    const double poisson = arguments.number_or("poisson", 0.3);
    if (poisson > 0.5) {
        context.reporter.error("poisson-too-large", arguments.span_of("poisson"),
                               fmt::format("poisson must be 0.5 at most, but is {:.6g}", poisson),
                               "write such as poisson=0.3; 0.5 is rubber");
        return;
    }
    context.ir.settings.modulus = *young / (1.0 - poisson * poisson);
    context.ir.settings.modulus_at = arguments.node->keyword().span();
}

void add_collide(const Arguments& arguments, const Frame&, Context& context) {
    context.ir.collides.push_back({arguments.plain[0], arguments.plain[1]});
}

void set_solver(const Arguments& arguments, const Frame&, Context& context) {
    const Word& word = arguments.plain.front();
    const std::optional<SolverKind> kind = solver_named(word.text);
    std::vector<std::string_view> known;
    for (const SolverKind available : solvers_available())
        known.push_back(name(available));
    const std::string offer = fmt::format("there are: {}", joined(known, " "));
    if (!kind) {
        context.reporter.error("unknown-solver", word.span(),
                               fmt::format("there is no solver '{}'", word.text),
                               did_you_mean(word.text, known, offer));
        return;
    }
    const std::vector<SolverCount> counts = counts_of(*kind);
    for (const auto& [key, argument] : arguments.values) {
        if (std::ranges::count(counts, key, &SolverCount::name) > 0) continue;
        context.reporter.error("solver-key-of-other-solver", argument.value.span(),
                               fmt::format("{} has no {}", word.text, key),
                               fmt::format("leave {}= out", key));
    }
    SolverSettings settings{.kind = *kind};
    for (const SolverCount& count : counts)
        settings.*count.value =
            static_cast<int>(arguments.number_or(count.name, settings.*count.value));
    context.ir.settings.solver = settings;
}

// "tolerance 0.01r within 10s"
void set_tolerance(const Arguments& arguments, const Frame& frame, Context& context) {
    const Word& word = arguments.plain[0];
    const bool is_complete = arguments.plain.size() == 1 ||
                             (arguments.plain.size() == 3 && arguments.plain[1].text == "within");
    if (!is_complete || !word.text.ends_with('r')) {
        context.reporter.error("tolerance-incomplete", word.span(),
                               "a tolerance is in ball radii, with the time that it is for",
                               "write such as: tolerance 0.01r within 10s");
        return;
    }
    const auto radii = read_number(word.part(0, word.text.size() - 1), {"tolerance", " "},
                                   Measure::number, Bound::positive, *frame.scope, context);
    if (!radii) return;
    context.ir.settings.need.tolerance = radii;
    if (arguments.plain.size() == 1) return;
    const auto time = read_number(arguments.plain[2], {"within", " "}, Measure::time,
                                  Bound::positive, *frame.scope, context);
    if (time) context.ir.settings.need.within = *time;
}

void set_budget(const Arguments& arguments, const Frame& frame, Context& context) {
    context.ir.settings.need.budget = read_number(
        arguments.plain[0], {"budget", " "}, Measure::time, Bound::positive, *frame.scope, context);
}

void set_rate(const Arguments& arguments, const Frame& frame, Context& context) {
    constexpr double fastest = 1e9;
    const Word& word = arguments.plain.front();
    const auto rate = read_number(word, {"rate", " "}, Measure::frequency, Bound::positive,
                                  *frame.scope, context);
    if (!rate) return;
    if (*rate > fastest || *rate < 1e-3) {
        context.reporter.error("rate-out-of-range", word.span(),
                               fmt::format("rate is out of range: {:.6g}", *rate),
                               "write ticks a second, from 0.001 to 1e9");
        return;
    }
    context.ir.settings.rate = rate;
}

// A seed of plain digits keeps all 64 bits; an expression has the 53 of a double.
void set_seed(const Arguments& arguments, const Frame& frame, Context& context) {
    const Word& word = arguments.plain.front();
    std::uint64_t seed = 0;
    const char* end = word.text.data() + word.text.size();
    const auto [stop, fault] = std::from_chars(word.text.data(), end, seed);
    if (fault == std::errc{} && stop == end) {
        context.ir.settings.seed = seed;
        return;
    }
    const auto number = read_number(word, {"seed", " "}, Measure::whole, Bound::not_negative,
                                    *frame.scope, context);
    if (number) context.ir.settings.seed = static_cast<std::uint64_t>(*number);
}

// A setting is a unique statement of the top level, which --set replaces whole.
Statement setting(Statement row) {
    row.place = Place::top;
    row.is_unique = true;
    row.settable = Settable::whole;
    return row;
}

Statement one_word_setting(std::string_view name, std::string_view usage, StatementAction action) {
    return setting(
        {.name = name, .usage = usage, .action = action, .plain_least = 1, .plain_most = 1});
}

}  // namespace

std::vector<Statement> setting_statements() {
    using enum KeyShape;
    using enum Bound;
    return {
        setting({.name = "world",
                 .usage = "world X0,Y0 X1,Y1",
                 .action = set_world,
                 .points_least = 2,
                 .points_most = 2}),
        setting({.name = "use gravity",
                 .usage = "use gravity X,Y",
                 .action = set_gravity,
                 .points_least = 1,
                 .points_most = 1,
                 .point_measure = Measure::acceleration}),
        one_word_setting("use drag", "use drag RATE", set_drag),
        one_word_setting("use stop", "use stop SPEED", set_stop_speed),
        one_word_setting("use limit", "use limit SPEED", set_speed_limit),
        one_word_setting("use scatter", "use scatter ANGLE", set_scatter),
        setting({.name = "use wrap", .usage = "use wrap", .action = set_wrap}),
        setting({.name = "use overlap", .usage = "use overlap", .action = allow_overlap}),
        setting({.name = "use spin",
                 .usage = "use spin [inertia=]",
                 .action = set_spin,
                 .keys = {{"inertia", scalar, Measure::number, positive_unit_interval}},
                 .runs_with_errors = true}),
        setting({.name = "use cloth",
                 .usage = "use cloth slide= roll= spin= [g=]",
                 .action = set_cloth,
                 .keys = {{"slide", scalar, Measure::number, positive, true},
                          {"roll", scalar, Measure::number, not_negative, true},
                          {"spin", scalar, Measure::angular_acceleration, not_negative, true},
                          {"g", scalar, Measure::acceleration, positive}}}),
        setting({.name = "use modulus",
                 .usage = "use modulus MODULUS [poisson=]",
                 .action = set_modulus,
                 .plain_least = 1,
                 .plain_most = 1,
                 .keys = {{"poisson", scalar, Measure::number, not_negative}}}),
        {.name = "collide",
         .usage = "collide A B     (kinds, materials, ball, edge)",
         .action = add_collide,
         .place = Place::top,
         .plain_least = 2,
         .plain_most = 2},
        setting(
            {.name = "solver",
             .usage = "solver discrete|substep|swept|contact|event [updates=] [steps=] [substeps=]",
             .action = set_solver,
             .plain_least = 1,
             .plain_most = 1,
             .keys = {{"updates", scalar, Measure::whole, up_to_thousand},
                      {"steps", scalar, Measure::whole, up_to_thousand},
                      {"substeps", scalar, Measure::whole, up_to_thousand}}}),
        setting({.name = "tolerance",
                 .usage = "tolerance RADIIr [within TIME]",
                 .action = set_tolerance,
                 .plain_least = 1,
                 .plain_most = 3}),
        one_word_setting("budget", "budget TIME", set_budget),
        one_word_setting("rate", "rate HZ", set_rate),
        one_word_setting("seed", "seed N", set_seed),
    };
}

}  // namespace carom
