#include "level/build/parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "level/text/joined.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

constexpr std::uint64_t cost_of_a_key = 20;  // of binding it, in operations

}  // namespace

Variable Parts::evaluated(const Word& key, const Word& expression, const Scope& scope) {
    return {evaluate(expression, scope, context_.rules(), context_.reporter), key.span(), nullptr};
}

void Parts::define(const Arguments& arguments, const Scope& scope) {
    if (arguments.plain.empty()) return;
    const Word& name = arguments.plain.front();
    Part part;
    part.node = arguments.node;
    part.span = name.span();
    for (const auto& [key, expression] : arguments.own_keys) {
        if (key.text == "at" || key.text == "turn" || key.text == "flip") {
            context_.reporter.error("part-key-reserved", key.span(),
                                    fmt::format("'{}' belongs to place", key.text),
                                    "choose another name");
            continue;
        }
        std::optional<Variable> otherwise;
        if (!expression.text.empty()) otherwise = evaluated(key, expression, scope);
        part.keys.emplace_back(key, otherwise);
        part.key_names.insert(key.text);
    }
    const auto [first, is_new] = parts_.emplace(std::string(name.text), std::move(part));
    if (is_new) return;
    context_.reporter.error("part-twice", name.span(),
                            fmt::format("the part '{}' is defined already, in line {}", name.text,
                                        first->second.span.line),
                            "choose another name");
}

Parts::Part* Parts::find(const Word& name) {
    const auto found = parts_.find(name.text);
    if (found != parts_.end()) return &found->second;
    std::vector<std::string_view> known;
    for (const auto& [other, part] : parts_)
        known.push_back(other);
    context_.reporter.error("unknown-part", name.span(),
                            fmt::format("there is no part '{}'", name.text),
                            did_you_mean(name.text, known, "define it above: part NAME ... end"));
    return nullptr;
}

std::optional<Parts::Placed> Parts::bind(const Arguments& arguments, const Scope& scope) {
    Part* part = find(arguments.plain.front());
    if (!part) return std::nullopt;
    part->is_placed = true;
    Placed placed{part->node, {}};
    if (!take_given(arguments, *part, scope, placed.names)) return std::nullopt;
    if (!take_defaults(arguments, *part, placed.names)) return std::nullopt;
    return placed;
}

bool Parts::take_given(const Arguments& arguments, const Part& part, const Scope& scope,
                       Names& names) {
    for (const auto& [key, expression] : arguments.own_keys) {
        context_.work.spend(cost_of_a_key);
        if (!part.key_names.contains(key.text)) {
            std::vector<std::string_view> known{"at", "turn", "flip"};
            for (const auto& [other, otherwise] : part.keys)
                known.push_back(other.text);
            context_.reporter.error(
                "unknown-part-key", key.span(),
                fmt::format("part {} has no key '{}'", arguments.plain[0].text, key.text),
                did_you_mean(key.text, known, fmt::format("its keys are: {}", joined(known, " "))));
            return false;
        }
        names.emplace(std::string(key.text), evaluated(key, expression, scope));
    }
    return true;
}

bool Parts::take_defaults(const Arguments& arguments, const Part& part, Names& names) {
    for (const auto& [key, otherwise] : part.keys) {
        context_.work.spend(cost_of_a_key);
        if (names.contains(key.text)) continue;
        if (!otherwise) {
            context_.reporter.error(
                "part-key-missing", arguments.node->keyword().span(),
                fmt::format("part {} needs {}=", arguments.plain[0].text, key.text),
                fmt::format("write {}=... here, or give it a value in the part's first line",
                            key.text));
            return false;
        }
        names.emplace(std::string(key.text), *otherwise);
    }
    return true;
}

void Parts::warn_unplaced() {
    for (const auto& [name, part] : parts_) {
        if (part.is_placed || !part.span.source->included_from.empty()) continue;
        context_.reporter.warning("part-unused", part.span,
                                  fmt::format("the part '{}' is never placed", name),
                                  "place it, or take it out");
    }
}

}  // namespace carom
