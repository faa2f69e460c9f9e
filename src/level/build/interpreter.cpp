#include "level/build/interpreter.h"

#include <fmt/format.h>

#include "level/build/all_statements.h"
#include "level/statements/header.h"
#include "level/text/joined.h"
#include "level/text/spelling.h"

namespace carom {

Interpreter::Interpreter(const LoadOptions& options, SourceStore& store, Context& context)
    : includes_(options.resolve_include, store, context.reporter),
      overrides_(options.overrides, store, context.reporter),
      context_(context),
      parts_(context) {}

void Interpreter::run_level(const std::vector<Node>& nodes) {
    Frame frame;
    frame.interpreter = this;
    frame.scope = &globals_;
    run_all(nodes, frame);
    for (const Node* node : overrides_.unused())
        run_unused_override(*node, frame);
    parts_.warn_unplaced();
}

void Interpreter::run_all(const std::vector<Node>& nodes, const Frame& frame) {
    for (const Node& node : nodes)
        if (node.statement) run(node, frame);
}

void Interpreter::run(const Node& node, const Frame& frame) {
    const Statement& statement = *node.statement;
    count_step(node);
    if (statement.place == Place::top && !frame.is_top) {
        context_.reporter.error("statement-in-block", node.keyword().span(),
                                fmt::format("{} does not belong in a block", statement.name),
                                "move it out of mirror, repeat and part");
        return;
    }
    const Node* replacement = overrides_.replacement(node);
    run_statement(replacement ? *replacement : node, frame, node.keyword().span());
}

void Interpreter::count_step(const Node& node) {
    // In operations of a LoadBudget; the evaluation of numbers costs more.
    constexpr std::uint64_t cost_of_a_statement = 10;
    constexpr std::uint64_t cost_of_a_word = 10;
    constexpr std::uint64_t characters_for_one = 2;
    std::uint64_t characters = 0;
    for (const Word& word : node.words)
        characters += word.text.size();
    context_.work.begin(node.keyword().span());
    context_.work.spend(cost_of_a_statement + cost_of_a_word * node.words.size() +
                        characters / characters_for_one);
    if (++steps_ <= max_items) return;
    context_.reporter.stop("too-many-statements", node.keyword().span(),
                           fmt::format("the level unrolls to more than {} statements", max_items),
                           "repeat less");
}

// `stands_at` is the position in the file, even if `node` is an override that replaces the
// statement.
void Interpreter::run_statement(const Node& node, const Frame& frame, const Span& stands_at) {
    const Statement& statement = *node.statement;
    if (!is_first_of_its_kind(statement, stands_at)) return;
    const Arguments arguments = read_arguments(node, *frame.scope, context_);
    if (!arguments.is_valid && statement.binds_names) {
        for (const Word& word : arguments.plain)
            context_.ir.error_names.emplace_back(word.text);
    }
    if (!statement.action) return;
    if (arguments.is_valid || statement.runs_with_errors)
        statement.action(arguments, frame, context_);
}

bool Interpreter::is_first_of_its_kind(const Statement& statement, const Span& at) {
    if (!statement.is_unique) return true;
    const auto [first, is_new] = unique_.emplace(statement.name, at);
    if (is_new) return true;
    context_.reporter.error("statement-twice", at,
                            fmt::format("{} stands here again: the first is in line {}",
                                        statement.name, first->second.line),
                            "keep one of them");
    return false;
}

void Interpreter::run_body(const Node& node, const Frame& frame, const Transform& transform,
                           int image, Names names) {
    if (frame.depth >= max_block_depth) {
        context_.reporter.stop(
            "block-too-deep", node.keyword().span(),
            fmt::format("blocks and parts are nested deeper than {}", max_block_depth),
            "nest them less; and no part can place itself");
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
    run_all(node.body, inner);
}

// A statement of --set that replaced none in the file: a setting missing from the file is run; a
// let missing from the file is an error.
void Interpreter::run_unused_override(const Node& node, const Frame& frame) {
    if (node.statement->name != "let") {
        run_statement(node, frame, node.keyword().span());
        return;
    }
    std::vector<std::string_view> known;
    for (const auto& [name, line] : context_.top_level_lets)
        known.push_back(name);
    for (const Word& word : node.rest()) {
        const Word name = word.part(0, word.text.find('='));
        if (globals_.names.contains(name.text)) continue;
        context_.reporter.error(
            "override-of-unknown-let", name.span(),
            fmt::format("the level has no let '{}'", name.text),
            did_you_mean(
                name.text, known,
                known.empty() ? "it has none" : fmt::format("it has: {}", joined(known, " "))));
    }
}

void interpret(const SourceText& main, const LoadOptions& options, SourceStore& store, Scene& scene,
               Context& context) {
    const std::vector<Node>& nodes =
        store.trees.emplace_back(read_blocks(main, all_statements(), context.reporter));
    read_header(nodes, main, scene, context);
    Interpreter(options, store, context).run_level(nodes);
}

}  // namespace carom
