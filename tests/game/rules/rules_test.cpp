#include "game/rules/rules.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace carom;

namespace {

using Step = RuleStep::What;

// A game that knows nothing but the time, and notes which actions reach it.
struct Nothing final : RuleHost {
    std::uint64_t now() const override { return tick; }
    double rate() const override { return 100.0; }
    std::int64_t quantity(RuleQuantity) const override { return 7; }
    std::int64_t count(const RuleBalls&, const RulePlace*) const override { return 3; }
    bool moves(std::uint32_t) const override { return false; }
    std::pair<std::int64_t, std::int64_t> lights(std::uint32_t) const override { return {2, 1}; }
    void act(const RuleAction&, std::int64_t value, int) override { acted.push_back(value); }

    std::uint64_t tick = 1;
    std::vector<std::int64_t> acted;
};

RuleStep number(std::int64_t n) {
    return {Step::number, n};
}

std::int64_t value(const RuleValue& steps) {
    const RuleBook book;
    const RuleState state;
    return value_of(book, state, Nothing{}, steps);
}

Rule scoring(RuleEvent event, std::uint32_t subject, std::int64_t points) {
    Rule rule;
    rule.event = event;
    rule.subject = subject;
    rule.actions.emplace_back();
    rule.actions.back().value = {number(points)};
    return rule;
}

}  // namespace

TEST_CASE("rules: values are whole numbers that saturate") {
    CHECK(value({}) == 0);
    CHECK(value({number(6), number(4), {Step::subtract}}) == 2);
    CHECK(value({number(6), number(-4), {Step::multiply}}) == -24);
    CHECK(value({number(6), number(4), {Step::min}}) == 4);
    CHECK(value({number(6), number(4), {Step::max}}) == 6);
    const RuleStep most = number(most_rule_number);
    CHECK(value({most, most, {Step::add}}) == most_rule_number);
    CHECK(value({most, most, {Step::multiply}}) == most_rule_number);
    CHECK(value({most, number(-3), {Step::multiply}}) == -most_rule_number);
    CHECK(value({number(-5), most, {Step::subtract}, most, {Step::subtract}}) == -most_rule_number);
}

TEST_CASE("rules: a timer ends once, in the tick that is due, and events keep the file's order") {
    RuleBook book;
    book.timers = {{"hurry", 0.5}};
    book.rules = {scoring(RuleEvent::timer_ends, 0, 1), scoring(RuleEvent::launch, no_subject, 9),
                  scoring(RuleEvent::timer_ends, 0, 2)};
    index_rules(book);
    RuleState state = begin_rules(book);
    Nothing host;
    const Rules rules{book, state, host};
    state.timer_ends[0] = 51;
    CHECK(seconds_left(state, host, 0) == 1);
    for (host.tick = 2; host.tick < 200; ++host.tick) {
        end_timers(rules);
        CHECK(host.acted.empty() == (host.tick < 51));
    }
    CHECK(host.acted == std::vector<std::int64_t>{1, 2});
    CHECK(seconds_left(state, host, 0) == 0);
}

TEST_CASE("rules: a player's variable exists for each player") {
    RuleBook book;
    book.players = 2;
    book.variables = {{"a", 4, RuleScope::player}, {"b", 5, RuleScope::turn}};
    RuleState state = begin_rules(book);
    CHECK(state.values == std::vector<std::int64_t>{4, 4, 5});
    state.values = {1, 2, 3};
    state.player = 1;
    CHECK(value_of(book, state, Nothing{}, {{Step::variable, 0}}) == 2);
    CHECK(value_of(book, state, Nothing{}, {{Step::variable, 1}}) == 3);
    begin_scope(book, state, RuleScope::turn);
    CHECK(state.values == std::vector<std::int64_t>{1, 2, 5});
}

TEST_CASE("rules: a number in a text has the word for one, or that for any other") {
    const auto text = [](std::int64_t n) {
        RuleText text;
        text.pieces.emplace_back(RuleText::Counted{{number(n)}, "hit", "hits"});
        text.pieces.emplace_back(std::string(": done"));
        return text_of(RuleBook{}, RuleState{}, Nothing{}, text);
    };
    CHECK(text(1) == "1 hit: done");
    CHECK(text(0) == "0 hits: done");
    CHECK(text(2) == "2 hits: done");
    CHECK(text(-1) == "-1 hits: done");
}
