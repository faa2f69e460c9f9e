#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "level/scene/rules.h"

/// What conditions of rules say about single numbers: for warnings of those that never hold.
namespace carom {

/// The whole numbers that a value may have, while conditions narrow them.
struct RuleRange {
    std::int64_t least = -most_rule_number;
    std::int64_t most = most_rule_number;
    std::vector<std::int64_t> excluded{};

    void narrow(RuleCondition::Relation relation, std::int64_t to) {
        using enum RuleCondition::Relation;
        if (relation == unequal) excluded.push_back(to);
        if (relation == equal || relation == at_least) least = std::max(least, to);
        if (relation == equal || relation == at_most) most = std::min(most, to);
        if (relation == more) least = std::max(least, to + 1);
        if (relation == less) most = std::min(most, to - 1);
    }

    bool is_empty() const {
        std::int64_t first = least;
        while (std::ranges::count(excluded, first) > 0)
            ++first;
        return first > most;
    }
};

/// A value that is no arithmetic, and the number that it is compared with.
struct RuleTest {
    RuleStep step;
    RuleCondition::Relation relation{};
    std::int64_t number = 0;
};

/// The conditions that all hold where these clauses do, as far as they compare such a value.
std::vector<RuleTest> tests_of(const std::vector<RuleClause>& needs);

}  // namespace carom
