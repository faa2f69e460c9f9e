#include "level/build/interpreter.h"

#include <fmt/format.h>

#include <algorithm>

#include "level/build/includes.h"
#include "level/build/overrides.h"
#include "level/ir/numbers.h"
#include "level/statements/header.h"
#include "level/statements/parts.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

class Interpreter {
  public:
    Interpreter(const LoadOptions& options, SourceStore& texts, Context& context)
        : includes_(options.resolve_include, texts, context.reporter),
          overrides_(options.overrides, texts, context.reporter),
          context_(context),
          parts_(context) {}

    void run(const std::vector<Node>& nodes) {
        Frame frame;
        frame.scope = &globals_;
        execute(nodes, frame);
        for (const Node* node : overrides_.unused())
            run_new_override(*node, frame);
        parts_.warn_unplaced();
    }

  private:
    void execute(const std::vector<Node>& nodes, const Frame& frame) {
        for (const Node& node : nodes) {
            if (stopped_) return;
            if (node.statement) execute(node, frame);
        }
    }

    void execute(const Node& node, const Frame& frame) {
        const Statement& statement = *node.statement;
        if (!take_step(node)) return;
        if (statement.place == Place::top && !frame.is_top) {
            context_.reporter.error(node.keyword().span(),
                                    fmt::format("{} does not belong in a block", statement.name),
                                    "move it out of mirror, repeat and part");
            return;
        }
        if (statement.name == "let") return execute_let(node, frame);
        if (const Node* replacement = overrides_.replacement(node)) {
            return execute_sound(*replacement, frame, node.keyword().span());
        }
        execute_sound(node, frame, node.keyword().span());
    }

    // Bounds what a short text can make of itself: statements, and characters that are read. A
    // level with hundreds of mistakes is not unrolled any further.
    bool take_step(const Node& node) {
        constexpr std::size_t most_errors = 200;
        constexpr std::uint64_t most_characters = 100'000'000;
        for (const Word& word : node.words)
            characters_ += word.text.size();
        constexpr std::uint64_t work_of_a_cell = 8;  // against that of a character of a word
        for (const Word& line : node.drawing)
            characters_ += work_of_a_cell * (line.text.size() + 1);
        if (context_.reporter.errors() >= most_errors || context_.is_at_limit) stopped_ = true;
        if (stopped_) return false;
        if (++steps_ <= max_items && characters_ <= most_characters) return true;
        context_.reporter.error(
            node.keyword().span(),
            steps_ > max_items
                ? fmt::format("the level unrolls to more than {} statements", max_items)
                : fmt::format("the level unrolls to more than {} characters", most_characters),
            "repeat less");
        stopped_ = true;
        return false;
    }

    // `said_at`: where the file says it, also when --set replaces it.
    void execute_sound(const Node& node, const Frame& frame, const Span& said_at) {
        if (!is_first_of_its_kind(node, said_at)) return;
        const Arguments arguments = read_arguments(node, *frame.scope, context_);
        if (declare(arguments, *frame.scope, legends_, context_)) return;
        const std::string_view name = node.statement->name;
        if (name == "part") return parts_.define(arguments, *frame.scope);
        if (!arguments.is_valid) {
            for (const Word& word : arguments.plain) {
                context_.ir.error_names.emplace_back(word.text);
            }
            return;
        }
        if (name == "edge") return build_edge(arguments, frame, context_);
        if (name == "arc") return build_arc(arguments, frame, context_);
        if (name == "peg") return build_peg(arguments, frame, context_);
        if (name == "box") return build_box(arguments, frame, context_);
        if (name == "ball") return build_ball(arguments, frame, context_);
        if (name == "spawn") return build_spawn(arguments, frame, context_);
        if (name == "fill") return build_fill(arguments, frame, context_);
        if (name == "cradle") return build_cradle(arguments, frame, context_);
        if (name == "bins") return build_bins(arguments, frame, context_);
        if (name == "zone") return build_zone(arguments, frame, context_);
        if (name == "pocket") return build_pocket(arguments, frame, context_);
        if (name.starts_with("rack ")) return build_rack(arguments, frame, context_);
        if (name == "flipper") return build_flipper(arguments, frame, context_);
        if (name == "bumper") return build_bumper(arguments, frame, context_);
        if (name == "plunger") return build_plunger(arguments, frame, context_);
        if (name == "drain") return build_drain(arguments, frame, context_);
        if (name == "slingshot" || name == "droptarget" || name == "target" || name == "gate") {
            return build_device_edges(arguments, frame, context_);
        }
        if (name == "ramp") return build_ramp(arguments, frame, context_);
        if (name == "rollover" || name == "spinner" || name == "kickback" || name == "hole" ||
            name == "lamp") {
            return build_device_spots(arguments, frame, context_);
        }
        if (name == "pegs triangle" || name == "pegs grid") {
            return build_pegs(arguments, frame, context_);
        }
        if (name == "map") return build_map(arguments, legends_, frame, context_);
        if (name == "mirror") return execute_mirror(arguments, frame);
        if (name == "repeat") return execute_repeat(arguments, frame);
        if (name == "place") return execute_place(arguments, frame);
        if (name == "include") return execute_include(arguments, frame);
        if (name == "world") return set_world(arguments);
    }

    // Statements that can only be made once: a second one is a mistake, not a correction.
    bool is_first_of_its_kind(const Node& node, const Span& span) {
        const std::string_view name = node.statement->name;
        const bool is_single = name.substr(0, 4) == "use " || name == "world" || name == "seed" ||
                               name == "rate" || name == "solver" || name == "game" ||
                               name == "cue";
        if (!is_single) return true;
        const auto [first, is_new] = singles_.emplace(name, span);
        if (is_new) return true;
        context_.reporter.error(
            span,
            fmt::format("{} stands here again: the first is in line {}", name, first->second.line),
            "keep one of them");
        return false;
    }

    void execute_let(const Node& node, const Frame& frame) {
        const Arguments arguments = read_arguments(node, *frame.scope, context_);
        for (const Word& word : arguments.plain) {
            context_.reporter.error(word.span(), fmt::format("'{}' has no value", word.text),
                                    "write let NAME=NUMBER without spaces");
        }
        if (arguments.own_keys.empty() && arguments.is_valid) {
            context_.reporter.error(node.keyword().span(), "let names nothing",
                                    "write it as: let NAME=NUMBER ...");
        }
        for (const auto& [name, expression] : arguments.own_keys) {
            set_variable(name, expression, frame);
        }
    }

    void set_variable(const Word& name, const Word& expression, const Frame& frame) {
        LetUse& use = context_.lets[name.text.data()];
        use.span = name.span();
        use.name = std::string(name.text);
        Variable variable;
        variable.defined_at = name.span();
        variable.used = &use.is_used;
        const std::optional<Word> override_expression =
            frame.is_top ? overrides_.let_value(name.text) : std::nullopt;
        variable.value = evaluate(override_expression.value_or(expression), *frame.scope,
                                  context_.rules(), context_.reporter);
        const auto [first, is_new] = frame.scope->names.emplace(std::string(name.text), variable);
        if (is_new) return;
        context_.reporter.error(name.span(),
                                fmt::format("'{}' has a value already, from line {}", name.text,
                                            first->second.defined_at.line),
                                "choose another name");
    }

    void execute_mirror(const Arguments& arguments, const Frame& frame) {
        if (!arguments.has("x") && !arguments.has("y")) {
            context_.reporter.error(arguments.node->keyword().span(),
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
            execute_inside(*arguments.node, frame, transform, image == 0 ? frame.image : ++images_,
                           {});
        }
    }

    void execute_inside(const Node& node, const Frame& frame, const Transform& transform, int image,
                        std::map<std::string, Variable, std::less<>> names) {
        if (frame.depth >= max_block_depth) {
            context_.reporter.error(
                node.keyword().span(),
                fmt::format("blocks and parts are nested deeper than {}", max_block_depth),
                "nest them less; and no part can place itself");
            stopped_ = true;
            return;
        }
        Scope scope;
        scope.outer = frame.scope;
        scope.names = std::move(names);
        Frame inner = frame;
        inner.scope = &scope;
        inner.transform = after(frame.transform, transform);
        inner.is_top = false;
        inner.image = image;
        inner.depth = frame.depth + 1;
        execute(node.body, inner);
    }

    void execute_repeat(const Arguments& arguments, const Frame& frame) {
        const auto count = read_number(arguments.plain[0], {"the number of copies", ""},
                                       Measure::whole, Bound::not_negative, *frame.scope, context_);
        if (!count) return;
        bool is_used = false;
        for (double i = 0.0; i < *count && !stopped_; i += 1.0) {
            // An empty body costs a step too, so that repeats of repeats come to an end.
            if (!take_step(*arguments.node)) return;
            std::map<std::string, Variable, std::less<>> names;
            if (arguments.plain.size() > 1) {
                names.emplace(std::string(arguments.plain[1].text),
                              Variable{Value{i, {}}, arguments.plain[1].span(), &is_used});
            }
            execute_inside(*arguments.node, frame, shift_by(arguments.pair_or("step", {}) * i),
                           frame.image, std::move(names));
        }
    }

    void execute_place(const Arguments& arguments, const Frame& frame) {
        auto placed = parts_.bind(arguments, *frame.scope);
        if (!placed) return;
        Transform transform = shift_by(arguments.pair_or("at", {}));
        if (arguments.has("turn")) {
            transform = after(transform, turn_by(arguments.number_or("turn", 0.0)));
        }
        if (arguments.flag("flip")) transform = after(transform, mirror_x(0.0));
        // The part sees the level's names and its own, not those of where it is placed.
        Frame around = frame;
        around.scope = &globals_;
        execute_inside(*placed->node, around, transform, frame.image, std::move(placed->names));
    }

    void execute_include(const Arguments& arguments, const Frame& frame) {
        const std::optional<Included> included =
            includes_.open(arguments.plain.front(), arguments.node->keyword());
        if (!included) return;
        if (included->is_new) read_fragment_header(*included->tree, context_);
        execute(*included->tree, frame);
        includes_.close();
    }

    void set_world(const Arguments& arguments) {
        const Vec2 a = arguments.points[0];
        const Vec2 b = arguments.points[1];
        if (a.x < b.x && a.y < b.y) {
            context_.ir.settings.world = Box{a, b};
            return;
        }
        context_.reporter.error(arguments.point_words[1].span(), "the world is empty",
                                "write its lower left corner, then its upper right one");
    }

    // A statement of --set that the file has no place for.
    void run_new_override(const Node& node, const Frame& frame) {
        if (node.statement->name == "let") {
            std::vector<std::string_view> known;
            for (const auto& [name, line] : context_.top_level_lets)
                known.push_back(name);
            for (const Word& word : node.rest()) {
                const Word name = word.part(0, word.text.find('='));
                if (globals_.names.contains(name.text)) continue;
                context_.reporter.error(
                    name.span(), fmt::format("the level has no let '{}'", name.text),
                    did_you_mean(name.text, known,
                                 known.empty() ? "it has none"
                                               : fmt::format("it has: {}", fmt::join(known, " "))));
            }
            return;
        }
        execute_sound(node, frame, node.keyword().span());
    }

    Includes includes_;
    Overrides overrides_;
    Context& context_;
    Scope globals_;
    Legends legends_;
    Parts parts_;
    std::map<std::string_view, Span> singles_;
    int images_ = 0;
    std::uint64_t steps_ = 0;
    std::uint64_t characters_ = 0;
    bool stopped_ = false;
};

}  // namespace

const SourceText& SourceStore::add(std::string name, std::string text,
                                   std::vector<IncludedFrom> from) {
    SourceText& source = sources.emplace_back();
    source.name = std::move(name);
    source.text = std::move(text);
    source.lines = split_lines(source.text);
    source.included_from = std::move(from);
    source.order = static_cast<int>(sources.size()) - 1;
    return source;
}

void unroll(const SourceText& main, const LoadOptions& options, SourceStore& texts, Scene& scene,
            Context& context) {
    const std::vector<Node>& nodes = texts.trees.emplace_back(read_blocks(main, context.reporter));
    read_header(nodes, main, scene, context);
    Interpreter(options, texts, context).run(nodes);
}

}  // namespace carom
