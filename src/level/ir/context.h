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
#include "level/text/reporter.h"
#include "level/values/expression.h"

/// What the stages of loading share.
namespace carom {

/// A `let`, told by where it stands: unrolled a thousand times it is still one.
struct LetUse {
    Span span;
    std::string name;
    bool is_used = false;
};

/// A statement, and a word of it: the same each time that the statement is unrolled. Only looked
/// up, never walked through, so that no order depends on addresses.
using BindingKey = std::pair<const Node*, const char*>;

struct Context {
    Reporter reporter;
    LevelIr ir;
    LengthUnit unit = LengthUnit::natural;
    /// The `units` line had a mistake: nothing is concluded from units.
    bool is_unit_unknown = false;
    /// Top-level lets and their lines, known before the unrolling.
    std::map<std::string, int, std::less<>> top_level_lets;
    std::map<const char*, LetUse> lets;
    std::map<BindingKey, std::size_t> edge_binding_index;
    std::map<BindingKey, std::size_t> ball_binding_index;
    /// Values of LevelIr::spin_needs: unrolled a thousand times, one is still one. Only looked up.
    std::set<const char*> spin_needs_seen;
    std::uint64_t seed = 0;
    /// How often fills have looked at an obstacle: bounds the work.
    std::uint64_t fill_tests = 0;
    /// Too many balls or edges: no more are unrolled.
    bool is_at_limit = false;

    ExpressionRules rules() const {
        return {is_unit_unknown ? LengthUnit::millimetre : unit, &top_level_lets};
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
