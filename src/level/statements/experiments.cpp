#include <fmt/format.h>

#include "level/ir/arguments.h"
#include "level/ir/numbers.h"
#include "level/statements/families.h"
#include "level/text/joined.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

void add_show(Show::What what, const Arguments& arguments, Context& context) {
    ShowIr show;
    show.what = what;
    show.of = arguments.word("of");
    show.against = arguments.word("against");
    show.span = arguments.node->keyword().span();
    context.ir.shows.push_back(std::move(show));
}

void show_histogram(const Arguments& arguments, const Frame&, Context& context) {
    add_show(Show::What::histogram, arguments, context);
}

void show_energy(const Arguments& arguments, const Frame&, Context& context) {
    add_show(Show::What::energy, arguments, context);
}

template <Observable what>
void show_observable(const Arguments& arguments, const Frame&, Context& context) {
    add_show(Show::What::observable, arguments, context);
    context.ir.shows.back().observable = what;
}

// A statement that shows an observable: "show msd".
template <Observable what>
Statement show_row(std::string_view name) {
    return {.name = name, .usage = name, .action = show_observable<what>, .place = Place::top};
}

// "observe pressure msd from=2s"
void set_observation(const Arguments& arguments, const Frame&, Context& context) {
    Observation& observation = context.ir.observation;
    observation = {};
    observation.from = arguments.number_or("from", 0.0);
    std::vector<std::string_view> known;
    for (const ObservableRow& row : observables())
        known.push_back(row.name);
    for (const Word& word : arguments.plain) {
        if (const ObservableRow* row = observable_named(word.text)) {
            observation.what.add(row->what);
            continue;
        }
        if (word.text == "from") {
            context.reporter.error("unknown-observable", word.span(), "'from' is not expected here",
                                   "write from=2s without spaces");
            return;
        }
        context.reporter.error(
            "unknown-observable", word.span(), fmt::format("'{}' cannot be observed", word.text),
            did_you_mean(word.text, known, fmt::format("there are: {}", joined(known, " "))));
    }
}

std::optional<Expect::Relation> relation_of(std::string_view word) {
    using enum Expect::Relation;
    for (const Expect::Relation relation : {within, less, at_most, more, at_least})
        if (sign(relation) == word) return relation;
    return std::nullopt;
}

constexpr std::string_view expect_remedy =
    "write it as: expect QUANTITY VALUE within TOLERANCE, or: expect QUANTITY < VALUE";

// The tick or ticks at which it must hold.
bool read_when(const Arguments& arguments, Expect& expect, Context& context) {
    const bool has_by = arguments.has("by");
    const bool is_always = arguments.flag("always");
    const bool is_never = arguments.flag("never");
    if ((is_always && is_never) || (arguments.has("at") && (has_by || is_always || is_never))) {
        context.reporter.error(
            "expect-at-several-times",
            arguments.has("at") ? arguments.span_of("at") : arguments.node->keyword().span(),
            "an expect has one of at=, by=, always and never",
            "at=: at that time; by=: at some time up to it; always, never: at every time, at none");
        return false;
    }
    expect.at = arguments.number(has_by ? "by" : "at");
    if (has_by) expect.when = Expect::When::by;
    if (is_always) expect.when = Expect::When::always;
    if (is_never) expect.when = Expect::When::never;
    return true;
}

void add_expect(const Arguments& arguments, const Frame& frame, Context& context) {
    const std::vector<Word>& words = arguments.plain;
    ExpectIr spec{words[0], {}};
    Expect& expect = spec.expect;
    const std::optional<Expect::Relation> relation = relation_of(words[1].text);
    const bool is_comparison = relation && relation != Expect::Relation::within;
    if (!is_comparison && (words.size() < 4 || words[2].text != "within")) {
        const Word& at = words.size() < 4 ? words[1] : words[2];
        context.reporter.error("within-missing", at.span(),
                               words.size() < 4
                                   ? "a tolerance is missing"
                                   : fmt::format("'{}' stands where 'within' is wanted", at.text),
                               std::string(expect_remedy));
        return;
    }
    if (is_comparison && words.size() > 3) {
        context.reporter.error("unexpected-word", words[3].span(),
                               fmt::format("'{}' is not expected here", words[3].text),
                               std::string(expect_remedy));
        return;
    }
    if (!read_when(arguments, expect, context)) return;
    expect.relation = relation.value_or(Expect::Relation::within);
    const QuantityKind kind = quantity_in(words[0].text);
    if (!kind) {  // reported when it is looked up
        context.ir.expects.push_back(std::move(spec));
        return;
    }
    const auto read = [&](const Word& word, Bare bare, Bound bound) {
        return read_quantity(word, kind->dimension, bare, bound, *frame.scope, context);
    };
    // The older form reads bare numbers in SI units, whatever the unit of the level.
    const auto value = is_comparison ? read(words[2], Bare::like_elsewhere, Bound::any)
                                     : read(words[1], Bare::si, Bound::any);
    const auto tolerance =
        is_comparison ? std::optional(0.0) : read(words[3], Bare::si, Bound::not_negative);
    if (!value || !tolerance) return;
    expect.value = *value;
    expect.tolerance = *tolerance;
    context.ir.expects.push_back(std::move(spec));
}

}  // namespace

std::vector<Statement> experiment_statements() {
    using enum KeyShape;
    using enum Bound;
    return {
        {.name = "show histogram",
         .usage = "show histogram of=NAME [against=binomial(N,P)|uniform]",
         .action = show_histogram,
         .place = Place::top,
         .keys = {{"of", word, Measure::number, any, true}, {"against", call}}},
        {.name = "show energy", .usage = "show energy", .action = show_energy, .place = Place::top},
        show_row<Observable::pressure>("show pressure"),
        show_row<Observable::msd>("show msd"),
        show_row<Observable::vacf>("show vacf"),
        show_row<Observable::speeds>("show speeds"),
        show_row<Observable::pairs>("show pairs"),
        show_row<Observable::lyapunov>("show lyapunov"),
        {.name = "observe",
         .usage = "observe [pressure] [msd] [vacf] [speeds] [pairs] [lyapunov] [from=TIME]",
         .action = set_observation,
         .place = Place::top,
         .plain_most = many,
         .keys = {{"from", scalar, Measure::time, not_negative}},
         .is_unique = true,
         .settable = Settable::whole},
        {.name = "expect",
         .usage = "expect QUANTITY VALUE within TOLERANCE|<|<=|>|>= VALUE [at=TIME] "
                  "[by=TIME] [always|never]",
         .action = add_expect,
         .place = Place::top,
         .plain_least = 3,
         .plain_most = 4,
         .keys = {{"at", scalar, Measure::time, not_negative},
                  {"by", scalar, Measure::time, not_negative}},
         .flags = {"always", "never"}},
    };
}

}  // namespace carom
