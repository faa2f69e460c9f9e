#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "level/ir/arguments.h"

/// The parts that a level defines with `part` and uses with `place`.
namespace carom {

using Names = std::map<std::string, Variable, std::less<>>;

class Parts {
  public:
    explicit Parts(Context& context) : context_(context) {}

    /// Defines a part. Its defaults are evaluated now, in `scope`.
    void define(const Arguments& arguments, const Scope& scope);

    /// A use of a part: its body, and the values of its keys.
    struct Placed {
        const Node* node = nullptr;
        Names names;
    };
    /// Binds the keys of a part to the values that `place` gives, or to their defaults. None:
    /// reported.
    std::optional<Placed> bind(const Arguments& arguments, const Scope& scope);

    /// Warns of parts that are never placed, except those of included files.
    void warn_unplaced();

  private:
    struct Part {
        const Node* node = nullptr;
        Span span;
        std::vector<std::pair<Word, std::optional<Variable>>>
            keys;  ///< with their defaults; none: `place` must give it
        std::set<std::string_view> key_names;
        bool is_placed = false;
    };
    Part* find(const Word& name);
    Variable evaluated(const Word& key, const Word& expression, const Scope& scope);
    bool take_given(const Arguments& arguments, const Part& part, const Scope& scope, Names& names);
    bool take_defaults(const Arguments& arguments, const Part& part, Names& names);

    Context& context_;
    std::map<std::string, Part, std::less<>> parts_;
};

}  // namespace carom
