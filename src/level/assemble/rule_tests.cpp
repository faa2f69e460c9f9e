#include "level/assemble/rule_tests.h"

#include <optional>

namespace carom {
namespace {

using Relation = RuleCondition::Relation;

Relation opposite(Relation relation) {
    using enum RuleCondition::Relation;
    switch (relation) {
        case equal:
            return unequal;
        case unequal:
            return equal;
        case less:
            return at_least;
        case at_most:
            return more;
        case more:
            return at_most;
        case at_least:
            break;
    }
    return less;
}

// `3<made` is `made>3`.
Relation swapped(Relation relation) {
    using enum RuleCondition::Relation;
    switch (relation) {
        case less:
            return more;
        case at_most:
            return at_least;
        case more:
            return less;
        case at_least:
            return at_most;
        default:
            return relation;
    }
}

bool is_number(const RuleValue& value) {
    return value.size() == 1 && value.front().what == RuleStep::What::number;
}

std::optional<RuleTest> test_of(const RuleCondition& condition) {
    if (condition.what != RuleCondition::What::compare) return std::nullopt;
    const bool is_swapped = is_number(condition.left);
    const RuleValue& value = is_swapped ? condition.right : condition.left;
    const RuleValue& number = is_swapped ? condition.left : condition.right;
    if (value.size() != 1 || !is_number(number)) return std::nullopt;
    return RuleTest{value.front(), is_swapped ? swapped(condition.relation) : condition.relation,
                    number.front().number};
}

}  // namespace

std::vector<RuleTest> tests_of(const std::vector<RuleClause>& needs) {
    std::vector<RuleTest> tests;
    for (const RuleClause& clause : needs) {
        if (clause.is_not && clause.all.size() > 1) continue;
        for (const RuleCondition& condition : clause.all) {
            auto test = test_of(condition);
            if (!test) continue;
            if (clause.is_not) test->relation = opposite(test->relation);
            tests.push_back(*test);
        }
    }
    return tests;
}

}  // namespace carom
