#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "level/build/source_store.h"

/// Statements of --set. Each replaces the statement of the file for the same setting
/// (Statement::settable).
namespace carom {

class Overrides {
  public:
    /// Reports statements that --set cannot replace.
    Overrides(const std::vector<std::string>& statements, SourceStore& store, Reporter& reporter);

    /// The statement to run in place of `node`; null: none replaces it.
    const Node* replacement(const Node& node);
    /// The expression that replaces that of a top-level let of this name.
    std::optional<Word> let_value(std::string_view name) const;
    /// The statements that replaced none of the file, and all lets.
    std::vector<const Node*> unused() const;

  private:
    void add_lets(const Node& node, Reporter& reporter);

    std::map<std::string, const Node*> statements_;  ///< by setting
    std::map<std::string, Word, std::less<>> lets_;
    std::vector<const Node*> let_nodes_;
    std::set<std::string> used_;
};

}  // namespace carom
