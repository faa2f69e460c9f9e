#include "level/build/overrides.h"

#include <fmt/format.h>

#include "level/build/all_statements.h"

namespace carom {
namespace {

// The setting that a statement changes: of two statements with the same setting, one replaces the
// other. Empty: --set cannot change it.
std::string setting(const Node& node) {
    const std::string_view name = node.statement->name;
    switch (node.statement->settable) {
        case Settable::no:
            break;
        case Settable::whole:
            return std::string(name);
        case Settable::by_name:
            for (const Word& word : node.rest()) {
                if (is_identifier(word.text)) return fmt::format("{} {}", name, word.text);
            }
            break;
    }
    return "";
}

}  // namespace

Overrides::Overrides(const std::vector<std::string>& statements, SourceStore& store,
                     Reporter& reporter) {
    for (const std::string& text : statements) {
        const SourceText& source = store.add("--set", text);
        if (const auto fault = find_fault(source.text)) {
            reporter.error(fault->code, {&source, fault->line, fault->column, 1}, fault->message,
                           fault->remedy);
            continue;
        }
        const std::size_t errors = reporter.errors();
        const std::vector<Node>& nodes =
            store.trees.emplace_back(read_blocks(source, all_statements(), reporter));
        if (reporter.errors() != errors) continue;
        if (nodes.size() != 1) {
            reporter.error("override-of-several", {&source, 1, 1, 1}, "--set takes one statement",
                           "write it as in: --set 'use gravity 0,-1.6'");
            continue;
        }
        const Node& node = nodes.front();
        if (node.statement->name == "let") {
            add_lets(node, reporter);
            continue;
        }
        const std::string key = setting(node);
        if (key.empty()) {
            reporter.error("override-refused", node.keyword().span(),
                           fmt::format("--set cannot change '{}'", node.statement->name),
                           "it changes: let use world solver rate seed game kind material observe");
            continue;
        }
        statements_[key] = &node;
    }
}

void Overrides::add_lets(const Node& node, Reporter& reporter) {
    if (node.rest().empty())
        reporter.error("let-without-name", node.keyword().span(), "let names nothing",
                       "write it as: let NAME=NUMBER ...");
    for (const Word& word : node.rest()) {
        const std::size_t equals = word.text.find('=');
        if (equals == std::string_view::npos) {
            reporter.error("let-without-value", word.span(),
                           fmt::format("'{}' has no value", word.text),
                           "write let NAME=NUMBER without spaces");
            return;
        }
        lets_[std::string(word.text.substr(0, equals))] = word.part(equals + 1);
    }
    let_nodes_.push_back(&node);
}

const Node* Overrides::replacement(const Node& node) {
    if (statements_.empty()) return nullptr;
    const auto found = statements_.find(setting(node));
    if (found == statements_.end()) return nullptr;
    used_.insert(found->first);
    return found->second;
}

std::optional<Word> Overrides::let_value(std::string_view name) const {
    const auto found = lets_.find(name);
    if (found == lets_.end()) return std::nullopt;
    return found->second;
}

std::vector<const Node*> Overrides::unused() const {
    std::vector<const Node*> result;
    for (const auto& [key, node] : statements_) {
        if (!used_.contains(key)) result.push_back(node);
    }
    result.insert(result.end(), let_nodes_.begin(), let_nodes_.end());
    return result;
}

}  // namespace carom
