#include "level/language/statements.h"

#include <algorithm>

#include "level/language/statement_table.h"

namespace carom {
namespace {

const std::vector<Statement>& table() {
    static const std::vector<Statement> statements = make_statements();
    return statements;
}

std::string_view first_word(std::string_view name) {
    return name.substr(0, name.find(' '));
}

}  // namespace

std::span<const Statement> statements() {
    return table();
}

const Statement* statement_named(std::string_view name) {
    const auto found = std::ranges::find(table(), name, &Statement::name);
    return found == table().end() ? nullptr : &*found;
}

std::vector<std::string_view> keywords() {
    std::vector<std::string_view> result;
    for (const Statement& statement : table()) {
        const std::string_view word = first_word(statement.name);
        if (std::ranges::find(result, word) == result.end()) result.push_back(word);
    }
    return result;
}

std::vector<std::string_view> second_words(std::string_view keyword) {
    std::vector<std::string_view> result;
    for (const Statement& statement : table()) {
        const std::string_view first = first_word(statement.name);
        if (first != keyword || first.size() == statement.name.size()) continue;
        result.push_back(statement.name.substr(first.size() + 1));
    }
    return result;
}

std::string grammar() {
    std::string result;
    for (const Statement& statement : table()) {
        result.append(statement.usage).append("\n");
    }
    return result;
}

}  // namespace carom
