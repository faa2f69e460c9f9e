#pragma once

#include <map>
#include <string_view>

#include "level/build/includes.h"
#include "level/build/overrides.h"
#include "level/build/parts.h"
#include "level/build/source_store.h"
#include "level/ir/arguments.h"

/// Runs the statements of a level and expands its blocks and includes. The result is the
/// intermediate representation (Context::ir).
namespace carom {

/// Runs trees of statements. It knows how statements are run, not what they do: their effect is the
/// action in their row of the table (language/statement.h).
///
/// A level is untrusted data, so the work is bounded: 1,000,000 statements, 32 nested blocks, and
/// the operations of a LoadBudget. At a limit the interpreter reports an error and throws
/// LoadStopped.
class Interpreter {
  public:
    Interpreter(const LoadOptions& options, SourceStore& store, Context& context);

    /// Runs a whole level, and then the overrides that replaced no statement of it.
    void run_level(const std::vector<Node>& nodes);

    /// Runs the statements in a frame, up to a limit.
    void run_all(const std::vector<Node>& nodes, const Frame& frame);
    /// Runs the body of a block in a frame inside `frame`: with `names` in scope, and `transform`
    /// applied before the frame's own. `image` tells copies made by mirror (Origin::image).
    void run_body(const Node& node, const Frame& frame, const Transform& transform, int image,
                  Names names);
    /// Counts a statement against the limits.
    void count_step(const Node& node);
    /// A number for a mirror image; each call returns a new one.
    int new_image() { return ++images_; }

    Scope& globals() { return globals_; }
    Parts& parts() { return parts_; }
    Includes& includes() { return includes_; }
    const Overrides& overrides() const { return overrides_; }

  private:
    void run(const Node& node, const Frame& frame);
    void run_statement(const Node& node, const Frame& frame, const Span& stands_at);
    bool is_first_of_its_kind(const Statement& statement, const Span& at);
    void run_unused_override(const Node& node, const Frame& frame);

    Includes includes_;
    Overrides overrides_;
    Context& context_;
    Scope globals_;
    Parts parts_;
    std::map<std::string_view, Span>
        unique_;  ///< the places of statements with Statement::is_unique
    int images_ = 0;
    std::uint64_t steps_ = 0;
};

/// Reads the header of `main` and interprets the level. Pre: `main` is in `store` and has no fault
/// (text/text.h). Fills Context::ir and the scene's title, comment and unit; reports errors.
void interpret(const SourceText& main, const LoadOptions& options, SourceStore& store, Scene& scene,
               Context& context);

}  // namespace carom
