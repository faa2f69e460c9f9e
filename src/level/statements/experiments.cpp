#include <fmt/format.h>

#include "level/ir/arguments.h"
#include "level/ir/numbers.h"
#include "level/statements/families.h"

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

void add_expect(const Arguments& arguments, const Frame& frame, Context& context) {
    const std::vector<Word>& words = arguments.plain;
    if (words[2].text != "within") {
        context.reporter.error("within-missing", words[2].span(),
                               fmt::format("'{}' stands where 'within' is wanted", words[2].text),
                               "write it as: expect QUANTITY VALUE within TOLERANCE");
        return;
    }
    const auto value =
        read_number(words[1], {}, Measure::result, Bound::any, *frame.scope, context);
    const auto tolerance = read_number(words[3], {"the tolerance", ""}, Measure::result,
                                       Bound::not_negative, *frame.scope, context);
    if (!value || !tolerance) return;
    context.ir.expects.push_back({words[0], *value, *tolerance, arguments.number("at")});
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
        {.name = "expect",
         .usage = "expect QUANTITY VALUE within TOLERANCE [at=TIME]",
         .action = add_expect,
         .place = Place::top,
         .plain_least = 4,
         .plain_most = 4,
         .keys = {{"at", scalar, Measure::time, not_negative}}},
    };
}

}  // namespace carom
