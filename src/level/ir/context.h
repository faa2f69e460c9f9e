#pragma once

#include <deque>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "level/ir/level_ir.h"
#include "level/ir/transform.h"
#include "level/scene/load_options.h"
#include "level/scene/scene.h"
#include "level/text/load_budget.h"
#include "level/values/expression.h"

/// State that the stages of loading share.
namespace carom {

/// Whether a `let` is used. One in a block counts once, however often the block runs.
struct LetUse {
    Span span;
    std::string name;
    bool is_used = false;
};

/// A statement and one of its words: the same key each time that the statement runs. Keys are
/// looked up but never iterated over, so no result depends on the order of addresses.
using BindingKey = std::pair<const Node*, const char*>;

struct Context {
    Reporter reporter;
    LoadBudget work{reporter};
    LevelIr ir;
    LengthUnit unit = LengthUnit::natural;
    /// The line `units` had an error, so numbers are not checked for their units.
    bool is_unit_unknown = false;
    /// The lets of the top level and their lines, known before any statement runs.
    std::map<std::string, int, std::less<>> top_level_lets;
    std::map<const char*, LetUse> lets;
    std::map<BindingKey, std::size_t> edge_binding_index;
    std::map<BindingKey, std::size_t> ball_binding_index;
    /// The values in LevelIr::spin_needs, so that a repeated statement adds each of them once.
    std::set<const char*> spin_needs_seen;
    std::uint64_t seed = 0;

    ExpressionRules rules() {
        return {is_unit_unknown ? LengthUnit::millimetre : unit, &top_level_lets, &work};
    }
};

class Interpreter;

/// Where a statement is run: the activation record of a block.
struct Frame {
    Interpreter* interpreter = nullptr;
    Scope* scope = nullptr;
    Transform transform;
    bool is_top = true;
    int image = 0;
    int depth = 0;
};

}  // namespace carom
