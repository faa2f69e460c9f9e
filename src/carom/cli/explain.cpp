#include "carom/cli/explain.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "carom/files/print.h"
#include "carom/text/suggest.h"
#include "level/build/all_statements.h"
#include "level/values/dimension.h"

namespace carom {
namespace {

std::string_view shape_text(KeyShape shape) {
    switch (shape) {
        case KeyShape::pair:
            return "X,Y: each ";
        case KeyShape::box:
            return "X0,Y0,X1,Y1: each ";
        case KeyShape::range:
        case KeyShape::deferred:
            return "one value, or a range A..B: ";
        case KeyShape::word:
            return "a word";
        case KeyShape::color:
            return "a colour: its name, or #rrggbb";
        case KeyShape::call:
            return "a name, or NAME(VALUES)";
        case KeyShape::scalar:
            break;
    }
    return "";
}

std::string_view bound_text(Bound bound) {
    switch (bound) {
        case Bound::not_negative:
            return ", 0 or more";
        case Bound::positive:
            return ", more than 0";
        case Bound::unit_interval:
            return ", 0 to 1";
        case Bound::positive_unit_interval:
            return ", more than 0, 1 at most";
        case Bound::up_to_thousand:
            return ", 1 to 1000";
        case Bound::layer:
            return ", 0 to 3";
        case Bound::any:
            break;
    }
    return "";
}

std::string key_text(const KeyRule& key) {
    const bool has_measure =
        key.shape != KeyShape::word && key.shape != KeyShape::color && key.shape != KeyShape::call;
    return fmt::format("    {:<10} {}{}{}{}{}{}\n", fmt::format("{}=", key.name),
                       shape_text(key.shape), has_measure ? described(key.measure) : "",
                       has_measure ? bound_text(key.bound) : "",
                       key.is_required ? "; required" : "", key.repeats ? "; may be repeated" : "",
                       key.needs_spin ? "; needs `use spin`" : "");
}

std::string statement_text(const Statement& statement) {
    std::string text = fmt::format("{}\n", statement.usage);
    for (const KeyRule& key : statement.keys)
        text += key_text(key);
    if (statement.opens_block) text += "    a block: it ends with `end`\n";
    if (statement.place == Place::top) text += "    outside of blocks only\n";
    if (statement.is_unique) text += "    once in a level\n";
    if (statement.settable != Settable::no) text += "    --set takes it\n";
    return text;
}

bool is_meant(std::string_view name, std::string_view wanted) {
    return name == wanted || (name.starts_with(wanted) && name[wanted.size()] == ' ');
}

}  // namespace

int explain(const ExplainOptions& options) {
    if (options.words.empty()) return print_out(all_statements().grammar()) ? 0 : 2;
    const std::string wanted = fmt::format("{}", fmt::join(options.words, " "));
    std::string text;
    std::vector<std::string_view> names;
    for (const Statement& statement : all_statements().rows()) {
        names.push_back(statement.name);
        if (!is_meant(statement.name, wanted)) continue;
        text += (text.empty() ? "" : "\n") + statement_text(statement);
    }
    if (text.empty()) {
        print_error(fmt::format("there is no statement '{}'{}", wanted, suggestion(wanted, names)));
        return 2;
    }
    return print_out(text) ? 0 : 2;
}

}  // namespace carom
