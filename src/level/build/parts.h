#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "level/ir/arguments.h"

/// What `part` has defined, and what `place` asks of it.
namespace carom {

using Names = std::map<std::string, Variable, std::less<>>;

class Parts {
  public:
    explicit Parts(Context& context) : context_(context) {}

    /// Carries out a `part`: its defaults are evaluated here and now.
    void define(const Arguments& arguments, const Scope& scope);

    /// What a `place` puts down: a body, and the values of the part's keys.
    struct Placed {
        const Node* node = nullptr;
        Names names;
    };
    /// None: reported.
    std::optional<Placed> bind(const Arguments& arguments, const Scope& scope);

    void warn_unplaced();

  private:
    struct Part {
        const Node* node = nullptr;
        Span span;
        std::vector<std::pair<Word, std::optional<Variable>>> keys;  ///< none: must be given
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
