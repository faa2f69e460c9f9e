#include <fmt/format.h>

#include <utility>

#include "level/ir/numbers.h"
#include "level/statements/rule_words.h"
#include "level/statements/rules.h"
#include "level/text/spelling.h"

// The goal of a level, with its stars.
namespace carom {
namespace {

// Reads the limits of a goal: `within 1 2 3 shots`, `within 3 4 5 of VALUE`, `with 5 4 3 of VALUE`.
class LimitReader {
  public:
    LimitReader(const Arguments& arguments, const Frame& frame, Context& context, RuleWords& reader)
        : words_(arguments.plain),
          usage_(arguments.statement->usage),
          frame_(frame),
          context_(context),
          reader_(reader) {}

    /// From words[next] on, behind which `next` then stands. A goal without limits has none to
    /// read. False: an error, which is reported.
    bool read(std::size_t& next, LevelGoal& goal) {
        const std::string_view lead = next < words_.size() ? words_[next].text : "";
        if (lead != "within" && lead != "with") return true;
        const bool is_least = lead == "with";
        for (++next; next < words_.size() && !is_unit(words_[next].text, is_least); ++next)
            if (!read_limit(words_[next], is_least, goal.limits)) return false;
        if (next == words_.size() || goal.limits.empty()) return refuse(words_[next - 1]);
        const Word& unit = words_[next++];
        using enum LevelGoal::Counts;
        goal.counts = is_least ? value : unit.text == "of" ? cost : shots;
        if (unit.text == "seconds") goal.counts = seconds;
        if (unit.text != "of") return true;
        if (next == words_.size()) return refuse(unit);
        auto counted = reader_.value(words_[next++], "", Bound::any);
        if (counted) goal.value = std::move(*counted);
        return counted.has_value();
    }

    bool refuse(const Word& at) {
        return refuse(at, fmt::format("'{}' is not expected here", at.text),
                      fmt::format("write it as: {}", usage_));
    }
    bool refuse(const Word& at, std::string message, std::string remedy) {
        context_.reporter.error("goal-malformed", at.span(), std::move(message), std::move(remedy));
        return false;
    }

  private:
    static bool is_unit(std::string_view word, bool is_least) {
        return word == "of" || (!is_least && (word == "shots" || word == "seconds"));
    }

    bool read_limit(const Word& word, bool is_least, std::vector<double>& limits) {
        const auto unit = nearest_word(word.text, {"shots", "seconds"});
        if (unit)
            return refuse(word, fmt::format("'{}' is not expected here", word.text),
                          is_least ? "write of and a value, as in: with 5 4 3 of made"
                                   : fmt::format("did you mean '{}'?", *unit));
        const auto limit =
            read_number(word, {is_least ? "with" : "within", " "}, Measure::whole,
                        is_least ? Bound::any : Bound::positive, *frame_.scope, context_);
        if (!limit) return false;
        if (limits.size() == 3)
            return refuse(word, "there are three stars, so three limits at most",
                          "leave this one out");
        const bool is_in_order =
            limits.empty() || (is_least ? *limit < limits.back() : *limit > limits.back());
        if (!is_in_order)
            return refuse(word,
                          is_least ? "with asks for at least so much, and three stars for most"
                                   : "within allows at most so much, and three stars for least",
                          is_least ? "write the highest first: with 5 4 3 of made"
                                   : "write the lowest first: within 1 2 3 shots");
        limits.push_back(*limit);
        return true;
    }

    const std::vector<Word>& words_;
    std::string_view usage_;
    const Frame& frame_;
    Context& context_;
    RuleWords& reader_;
};

}  // namespace

void add_goal(const Arguments& arguments, const Frame& frame, Context& context) {
    const std::vector<Word>& words = arguments.plain;
    GoalIr goal;
    RuleWords reader(*frame.scope, context, goal.names);
    LimitReader limits(arguments, frame, context, reader);
    goal.text = words[0];
    if (words[0].text.size() < 2 || words[0].text.front() != '"') {
        limits.refuse(words[0], "the text of a goal stands in quotes",
                      "write it as: goal \"Pocket the red.\" if count(red)=0");
        return;
    }
    goal.goal.text = std::string(words[0].text.substr(1, words[0].text.size() - 2));
    std::size_t next = 1;
    if (!limits.read(next, goal.goal)) return;
    auto needs = reader.clauses(words, next);
    if (!needs) return;
    if (next < words.size()) {
        const bool is_limit = words[next].text == "within" || words[next].text == "with";
        if (is_limit)
            limits.refuse(words[next], "the limits stand before the condition",
                          fmt::format("write it as: {}", arguments.statement->usage));
        else
            limits.refuse(words[next]);
        return;
    }
    if (needs->empty()) {
        limits.refuse(words.back(), "the goal does not say when it is reached",
                      "add a condition, as in: if count(red)=0");
        return;
    }
    goal.goal.needs = std::move(*needs);
    context.ir.goals.push_back(std::move(goal));
}

}  // namespace carom
