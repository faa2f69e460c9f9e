#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "level/language/statement.h"

/// Looks up statements by name. The rows come from the families of statements (level/statements);
/// build/all_statements.h combines them.
namespace carom {

/// Invariant: rows never change or move, so pointers to them stay valid as long as the table.
class StatementTable {
  public:
    explicit StatementTable(std::vector<Statement> rows) : rows_(std::move(rows)) {}
    StatementTable(const StatementTable&) = delete;
    StatementTable& operator=(const StatementTable&) = delete;

    std::span<const Statement> rows() const { return rows_; }
    /// By full name: "edge", "use gravity". Null when there is none.
    const Statement* find(std::string_view name) const;
    /// First words: "edge", "use", ... each once.
    std::vector<std::string_view> keywords() const;
    /// Second words of the statements that begin with `keyword`: "gravity", "drag", ...
    std::vector<std::string_view> second_words(std::string_view keyword) const;
    /// All usages, one a line, in the order of the rows.
    std::string grammar() const;

  private:
    std::vector<Statement> rows_;
};

}  // namespace carom
