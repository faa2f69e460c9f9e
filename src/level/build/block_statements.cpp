#include "level/build/block_statements.h"

#include <fmt/format.h>

#include "level/build/interpreter.h"
#include "level/ir/numbers.h"
#include "level/statements/header.h"
#include "level/statements/keys.h"

namespace carom {
namespace {

void define_variable(const Word& name, const Word& expression, const Frame& frame,
                     Context& context) {
    constexpr std::uint64_t cost = 50;  // of a variable, in operations
    context.work.spend(cost);
    if (name.text == "pi") {
        context.reporter.warning("let-hides-constant", name.span(),
                                 "this pi hides the constant pi, 3.14159...",
                                 "choose another name");
    }
    LetUse& use = context.lets[name.text.data()];
    use.span = name.span();
    use.name = std::string(name.text);
    Variable variable;
    variable.defined_at = name.span();
    variable.used = &use.is_used;
    const std::optional<Word> override_expression =
        frame.is_top ? frame.interpreter->overrides().let_value(name.text) : std::nullopt;
    variable.value = evaluate(override_expression.value_or(expression), *frame.scope,
                              context.rules(), context.reporter);
    const auto [first, is_new] = frame.scope->names.emplace(std::string(name.text), variable);
    if (is_new) return;
    context.reporter.error("let-twice", name.span(),
                           fmt::format("'{}' has a value already, from line {}", name.text,
                                       first->second.defined_at.line),
                           "choose another name");
}

void run_let(const Arguments& arguments, const Frame& frame, Context& context) {
    for (const Word& word : arguments.plain) {
        context.reporter.error("let-without-value", word.span(),
                               fmt::format("'{}' has no value", word.text),
                               "write let NAME=NUMBER without spaces");
    }
    if (arguments.own_keys.empty() && arguments.is_valid) {
        context.reporter.error("let-without-name", arguments.node->keyword().span(),
                               "let names nothing", "write it as: let NAME=NUMBER ...");
    }
    for (const auto& [name, expression] : arguments.own_keys)
        define_variable(name, expression, frame, context);
}

// Runs the body, then its reflections. Each reflection has an image number of its own.
void run_mirror(const Arguments& arguments, const Frame& frame, Context& context) {
    if (!arguments.has("x") && !arguments.has("y")) {
        context.reporter.error("mirror-without-axis", arguments.node->keyword().span(),
                               "mirror needs x= or y=", "write it as: mirror x=0");
        return;
    }
    for (int image = 0; image < 4; ++image) {
        const bool flips_x = (image & 1) != 0;
        const bool flips_y = (image & 2) != 0;
        if ((flips_x && !arguments.has("x")) || (flips_y && !arguments.has("y"))) continue;
        Transform transform;
        if (flips_x) transform = mirror_x(arguments.number_or("x", 0.0));
        if (flips_y) transform = after(mirror_y(arguments.number_or("y", 0.0)), transform);
        frame.interpreter->run_body(*arguments.node, frame, transform,
                                    image == 0 ? frame.image : frame.interpreter->new_image(), {});
    }
}

void run_repeat(const Arguments& arguments, const Frame& frame, Context& context) {
    Interpreter& interpreter = *frame.interpreter;
    const auto count = read_number(arguments.plain[0], {"the number of copies", ""}, Measure::whole,
                                   Bound::not_negative, *frame.scope, context);
    if (!count) return;
    bool is_used = false;
    for (double i = 0.0; i < *count; i += 1.0) {
        // Count an empty body too, so that nested empty repeats reach the limit.
        interpreter.count_step(*arguments.node);
        Names names;
        if (arguments.plain.size() > 1) {
            names.emplace(std::string(arguments.plain[1].text),
                          Variable{Value{i, {}}, arguments.plain[1].span(), &is_used});
        }
        interpreter.run_body(*arguments.node, frame, shift_by(arguments.pair_or("step", {}) * i),
                             frame.image, std::move(names));
    }
}

void run_part(const Arguments& arguments, const Frame& frame, Context&) {
    frame.interpreter->parts().define(arguments, *frame.scope);
}

// A part sees the names of the top level and its own keys, not the names at the place statement.
void run_place(const Arguments& arguments, const Frame& frame, Context&) {
    Interpreter& interpreter = *frame.interpreter;
    auto placed = interpreter.parts().bind(arguments, *frame.scope);
    if (!placed) return;
    Transform transform = shift_by(arguments.pair_or("at", {}));
    if (arguments.has("turn"))
        transform = after(transform, turn_by(arguments.number_or("turn", 0.0)));
    if (arguments.flag("flip")) transform = after(transform, mirror_x(0.0));
    Frame around = frame;
    around.scope = &interpreter.globals();
    interpreter.run_body(*placed->node, around, transform, frame.image, std::move(placed->names));
}

void run_include(const Arguments& arguments, const Frame& frame, Context& context) {
    Includes& includes = frame.interpreter->includes();
    const std::optional<Included> included =
        includes.open(arguments.plain.front(), arguments.node->keyword());
    if (!included) return;
    if (included->is_new) read_fragment_header(*included->tree, context);
    frame.interpreter->run_all(*included->tree, frame);
    includes.close();
}

}  // namespace

std::vector<Statement> variable_statements() {
    return {{.name = "let",
             .usage = "let NAME=NUMBER ...",
             .action = run_let,
             .takes_any_key = true,
             .runs_with_errors = true}};
}

std::vector<Statement> block_statements() {
    using enum KeyShape;
    constexpr auto length = Measure::length;
    return {
        {.name = "mirror",
         .usage = "mirror [x=X] [y=Y] ... end",
         .action = run_mirror,
         .opens_block = true,
         .keys = {{"x", scalar, length}, {"y", scalar, length}}},
        {.name = "repeat",
         .usage = "repeat N [NAME] [step=DX,DY] ... end",
         .action = run_repeat,
         .opens_block = true,
         .plain_least = 1,
         .plain_most = 2,
         .keys = {{"step", pair, length}}},
        {.name = "part",
         .usage = "part NAME [KEY=[NUMBER] ...] ... end",
         .action = run_part,
         .place = Place::top,
         .opens_block = true,
         .plain_least = 1,
         .plain_most = 1,
         .takes_any_key = true,
         .runs_with_errors = true},
        {.name = "place",
         .usage = "place NAME at=X,Y [turn=ANGLE] [flip] [KEY=NUMBER ...]",
         .action = run_place,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {keys::at, {"turn", scalar, Measure::angle}},
         .flags = {"flip"},
         .takes_any_key = true,
         .binds_names = true},
        {.name = "include",
         .usage = R"(include "FILE")",
         .action = run_include,
         .plain_least = 1,
         .plain_most = 1},
    };
}

}  // namespace carom
