#pragma once

#include <set>

#include "level/build/interpreter.h"

/// Statements of --set: each takes the place of the file's statement of the same kind.
namespace carom {

class Overrides {
  public:
    /// Reports statements that cannot be set.
    Overrides(const std::vector<std::string>& statements, SourceStore& texts, Reporter& reporter);

    /// What is to be carried out in place of `node`, or null.
    const Node* replacement(const Node& node);
    /// The expression for a top-level let of this name.
    std::optional<Word> let_value(std::string_view name) const;
    /// The statements that replaced nothing, and all lets.
    std::vector<const Node*> unused() const;

  private:
    std::map<std::string, const Node*> statements_;
    std::map<std::string, Word, std::less<>> lets_;
    std::vector<const Node*> let_nodes_;
    std::set<std::string> used_;
};

}  // namespace carom
