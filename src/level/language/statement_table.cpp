#include "level/language/statement_table.h"

#include <algorithm>

namespace carom {
namespace {

std::string_view first_word(std::string_view name) {
    return name.substr(0, name.find(' '));
}

}  // namespace

const Statement* StatementTable::find(std::string_view name) const {
    const auto found = std::ranges::find(rows_, name, &Statement::name);
    return found == rows_.end() ? nullptr : &*found;
}

std::vector<std::string_view> StatementTable::keywords() const {
    std::vector<std::string_view> result;
    for (const Statement& statement : rows_) {
        const std::string_view word = first_word(statement.name);
        if (std::ranges::find(result, word) == result.end()) result.push_back(word);
    }
    return result;
}

std::vector<std::string_view> StatementTable::second_words(std::string_view keyword) const {
    std::vector<std::string_view> result;
    for (const Statement& statement : rows_) {
        const std::string_view first = first_word(statement.name);
        if (first != keyword || first.size() == statement.name.size()) continue;
        result.push_back(statement.name.substr(first.size() + 1));
    }
    return result;
}

std::string StatementTable::grammar() const {
    std::string result;
    for (const Statement& statement : rows_)
        result.append(statement.usage).append("\n");
    return result;
}

}  // namespace carom
