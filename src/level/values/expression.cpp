#include "level/values/expression.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>

#include "geometry/elementary.h"
#include "level/text/spelling.h"
#include "level/values/literal.h"
#include "level/values/value_math.h"

namespace carom {
namespace {

// A recursive-descent parser of one word, which evaluates as it parses. An empty result means an
// error that has been reported, or the use of an error value; callers pass it on.
class Parser {
  public:
    Parser(const Word& word, const Scope& scope, const ExpressionRules& rules, Reporter& reporter)
        : word_(word), text_(word.text), scope_(scope), rules_(rules), reporter_(reporter) {}

    /// What parsing has cost so far, in operations (LoadBudget).
    std::uint64_t cost() const { return cost_; }

    std::optional<Value> whole() {
        cost_ += text_.size() / 4;
        const std::optional<Value> value = sum();
        if (value && at_ < text_.size()) {
            const std::string_view rest = text_.substr(at_);
            const bool is_bracket = rest[0] == ')';
            return mistake(
                is_bracket ? FaultCode("bracket-not-open") : FaultCode("unexpected-text"), at_,
                is_bracket ? 1 : rest.size(),
                is_bracket ? "this ')' closes nothing"
                           : fmt::format("'{}' is not expected here", rest),
                is_bracket ? "take it out, or add the '('"
                           : "arithmetic has + - * / ^ and brackets, without spaces");
        }
        return value;
    }

  private:
    using Result = std::optional<Value>;

    Result mistake(FaultCode code, std::size_t offset, std::size_t count, std::string message,
                   std::string remedy = {}) {
        if (!failed_) {
            reporter_.error(code, word_.part(offset, count).span(), std::move(message),
                            std::move(remedy));
        }
        failed_ = true;
        return std::nullopt;
    }

    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    std::string_view since(std::size_t start) const { return text_.substr(start, at_ - start); }

    Result finite(std::size_t start, const Value& value) {
        if (!is_sensible(value.dimension)) {
            return mistake("impossible-unit", start, at_ - start,
                           fmt::format("{} is {}", since(start), described(value.dimension)),
                           "no quantity has such a unit");
        }
        if (std::abs(value.number) <= largest_number) return value;
        return mistake("number-not-finite", start, at_ - start,
                       fmt::format("{} is not a finite number", since(start)),
                       "numbers go up to 1e300, and nothing is divided by 0");
    }

    Result sum() {
        const std::size_t start = at_;
        Result left = product();
        while (left && (peek() == '+' || peek() == '-')) {
            const double sign = text_[at_] == '-' ? -1.0 : 1.0;
            ++at_;
            const std::size_t right_start = at_;
            const Result right = product();
            if (!right) return right;
            left = added(start, *left, right_start, *right, sign);
        }
        return left;
    }

    Result added(std::size_t start, Value left, std::size_t right_start, Value right, double sign) {
        if (!match(left, right, rules_.unit)) {
            return mistake(
                "wrong-dimension", start, at_ - start,
                fmt::format("{} is {}, but {} is {}", text_.substr(start, right_start - 1 - start),
                            described(left.dimension), since(right_start),
                            described(right.dimension)),
                "only like can be added to like");
        }
        return finite(start, {left.number + sign * right.number, left.dimension});
    }

    Result product() {
        const std::size_t start = at_;
        Result left = power();
        while (left && (peek() == '*' || peek() == '/')) {
            const bool divides = text_[at_] == '/';
            ++at_;
            const Result right = power();
            if (!right) return right;
            left = divides
                       ? Value{left->number / right->number, left->dimension / right->dimension}
                       : Value{left->number * right->number, left->dimension * right->dimension};
            left = finite(start, *left);
        }
        return left;
    }

    // A sign binds less tightly than ^: -2^2 is -4.
    Result power() {
        if (peek() == '-' || peek() == '+') {
            const bool is_negative = peek() == '-';
            if (++signs_ > max_nesting) return too_deep();
            ++at_;
            Result value = power();
            --signs_;
            if (value && is_negative) value->number = -value->number;
            return value;
        }
        const std::size_t start = at_;
        const Result base = atom();
        if (!base || peek() != '^') return base;
        ++at_;
        const std::size_t exponent_start = at_;
        if (++depth_ > max_nesting) return too_deep();
        const Result exponent = power();
        --depth_;
        if (!exponent) return exponent;
        if (!can_be_exponent(*exponent)) {
            return mistake("bad-exponent", exponent_start, at_ - exponent_start,
                           fmt::format("{} cannot be an exponent", since(exponent_start)),
                           "an exponent is a whole number from -1024 to 1024, or 0.5");
        }
        return settled(start, raised(*base, *exponent));
    }

    // The result of an operation on the text since `start`, or a report of its fault.
    Result settled(std::size_t start, const Outcome& outcome) {
        if (outcome.fault.empty()) return finite(start, outcome.value);
        return mistake(outcome.code, start, at_ - start, outcome.fault, outcome.remedy);
    }

    Result too_deep() {
        return mistake("nested-too-deep", at_, 1, fmt::format("nested deeper than {}", max_nesting),
                       "split it with let");
    }

    Result atom() {
        cost_ += 4;
        const char c = peek();
        if (begins_literal(text_.substr(at_))) return number();
        if (starts_identifier(c)) return name();
        if (c == '(') {
            const std::size_t open = at_++;
            if (++depth_ > max_nesting) return too_deep();
            const Result value = sum();
            --depth_;
            return value && closes(open) ? value : Result{};
        }
        if (at_ >= text_.size()) {
            const std::size_t from = text_.empty() ? 0 : text_.size() - 1;
            return mistake("number-missing", from, 1, "a number is missing here",
                           "arithmetic is written without spaces, points as x,y");
        }
        return mistake("not-a-number", at_, text_.size() - at_,
                       fmt::format("'{}' is not a number", text_.substr(at_)),
                       "write a number, a let name or arithmetic, such as W/2");
    }

    bool closes(std::size_t open) {
        if (peek() == ')') {
            ++at_;
            return true;
        }
        if (at_ < text_.size()) {
            mistake("unexpected-text", at_, 1,
                    fmt::format("'{}' is not expected here", text_.substr(at_, 1)),
                    "arithmetic has + - * / ^ and brackets, without spaces");
        } else {
            mistake("bracket-not-closed", open, 1, "the ')' is missing",
                    "arithmetic is written without spaces: (W-2*R)/2");
        }
        return false;
    }

    Result number() {
        const std::size_t start = at_;
        const auto is_let = [&](std::string_view name) { return scope_.find(name, cost_); };
        const Literal literal = read_literal(text_.substr(start), rules_.unit, is_let);
        if (!literal.fault.empty()) {
            return mistake(literal.code, start + literal.fault_at, literal.fault_length,
                           literal.fault, literal.remedy);
        }
        at_ += literal.length;
        return finite(start, literal.value);
    }

    Result name() {
        const std::size_t start = at_;
        while (at_ < text_.size() && continues_identifier(text_[at_]))
            ++at_;
        const std::string_view name = since(start);
        const FunctionFacts* function = function_named(name);
        if (function && peek() == '(') return call(start, *function);
        if (peek() == '(') {
            return mistake("unknown-function", start, name.size(),
                           fmt::format("'{}' is not a function", name),
                           did_you_mean(name, function_names(),
                                        "there are sqrt sin cos tan abs min max floor ceil round"));
        }
        // A variable hides a constant or a function of its name.
        const Variable* variable = scope_.find(name, cost_);
        if (!variable && name == "pi") return Value{pi, {}};
        if (!variable && function) {
            return mistake(
                "function-without-brackets", start, name.size(),
                fmt::format("{} needs brackets", name),
                fmt::format("write {}({})", name, function->arguments == 2 ? "a,b" : "x"));
        }
        if (!variable) return unknown(start, name);
        if (variable->used) *variable->used = true;
        return variable->value;
    }

    Result unknown(std::size_t start, std::string_view name) {
        if (rules_.defined_later) {
            const auto later = rules_.defined_later->find(name);
            if (later != rules_.defined_later->end()) {
                return mistake(
                    "let-used-too-early", start, name.size(),
                    fmt::format("'{}' has no value yet", name),
                    fmt::format("move its let, line {}, above this line", later->second));
            }
        }
        std::vector<std::string_view> known{"pi"};
        for (const Scope* scope = &scope_; scope; scope = scope->outer) {
            for (const auto& [other, variable] : scope->names) {
                if (known.size() == max_candidates) break;
                known.push_back(other);
            }
        }
        for (const std::string_view function : function_names())
            known.push_back(function);
        return mistake(
            "unknown-name", start, name.size(), fmt::format("'{}' is not known", name),
            did_you_mean(name, known, fmt::format("give it a value above: let {}=...", name)));
    }

    Result call(std::size_t start, const FunctionFacts& f) {
        const std::size_t open = at_++;
        if (++depth_ > max_nesting) return too_deep();
        std::array<Value, 2> arguments;
        for (std::size_t i = 0; i < f.arguments; ++i) {
            if (i > 0) {
                if (peek() != ',') {
                    return mistake("function-arguments", start, at_ - start,
                                   fmt::format("{} wants {} numbers", f.name, f.arguments),
                                   fmt::format("write {}(a,b)", f.name));
                }
                ++at_;
            }
            const Result argument = sum();
            if (!argument) return argument;
            arguments[i] = *argument;
        }
        --depth_;
        if (!closes(open)) return std::nullopt;
        return settled(start, applied(f.function, arguments[0], arguments[1], rules_.unit));
    }

    const Word& word_;
    std::string_view text_;
    const Scope& scope_;
    const ExpressionRules& rules_;
    Reporter& reporter_;
    std::size_t at_ = 0;
    int depth_ = 0;
    int signs_ = 0;
    bool failed_ = false;
    std::uint64_t cost_ = 0;
};

}  // namespace

const Variable* Scope::find(std::string_view name, std::uint64_t& cost) const {
    for (const Scope* scope = this; scope; scope = scope->outer) {
        if (scope->names.empty()) continue;
        cost += 2 + std::bit_width(scope->names.size());
        const auto found = scope->names.find(name);
        if (found != scope->names.end()) return &found->second;
    }
    return nullptr;
}

std::optional<Value> evaluate(const Word& word, const Scope& scope, const ExpressionRules& rules,
                              Reporter& reporter) {
    Parser parser(word, scope, rules, reporter);
    const std::optional<Value> value = parser.whole();
    if (rules.work) rules.work->spend(parser.cost());
    return value;
}

}  // namespace carom
