#include "level/build/all_statements.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace carom;

TEST_CASE("every statement has a unique name, and its usage begins with it") {
    std::set<std::string_view> names;
    for (const Statement& statement : all_statements().rows()) {
        CAPTURE(statement.name);
        CHECK(names.insert(statement.name).second);
        CHECK(statement.usage.starts_with(statement.name));
        CHECK(all_statements().find(statement.name) == &statement);
    }
}

TEST_CASE("every statement has an action, except the header and the end of blocks") {
    const std::set<std::string_view> without{"carom", "physics", "units", "end"};
    for (const Statement& statement : all_statements().rows()) {
        CAPTURE(statement.name);
        CHECK((statement.action != nullptr) == !without.contains(statement.name));
    }
}

TEST_CASE("the usage of a statement names each of its keys and flags") {
    for (const Statement& statement : all_statements().rows()) {
        CAPTURE(statement.name);
        std::set<std::string_view> keys;
        for (const KeyRule& key : statement.keys) {
            CAPTURE(key.name);
            CHECK(keys.insert(key.name).second);
            const std::string written = std::string(key.name) + "=";
            CHECK(statement.usage.find(written) != std::string_view::npos);
            const bool is_optional = statement.usage.find("[" + written) != std::string_view::npos;
            CHECK(is_optional == !key.is_required);
        }
        for (const std::string_view flag : statement.flags)
            CHECK(statement.usage.find(flag) != std::string_view::npos);
        CHECK(statement.plain_least <= statement.plain_most);
        CHECK(statement.points_least <= statement.points_most);
    }
}

TEST_CASE("statements are found by their first and second words") {
    const auto keywords = all_statements().keywords();
    CHECK(std::ranges::count(keywords, "use") == 1);
    CHECK(std::ranges::count(keywords, "ball") == 1);
    CHECK(all_statements().second_words("rack") ==
          std::vector<std::string_view>{"eight", "nine", "ten", "triangle"});
    CHECK(all_statements().second_words("ball").empty());
    CHECK(all_statements().find("use") == nullptr);
}
