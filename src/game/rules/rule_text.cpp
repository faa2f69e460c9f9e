#include <fmt/format.h>

#include "game/rules/rules.h"

namespace carom {

std::string grouped(std::int64_t number) {
    std::string digits = fmt::format("{}", number);
    const int first = number < 0 ? 1 : 0;
    for (auto at = static_cast<int>(digits.size()) - 3; at > first; at -= 3)
        digits.insert(static_cast<std::size_t>(at), ",");
    return digits;
}

std::string text_of(const RuleBook& book, const RuleState& state, const RuleHost& host,
                    const RuleText& text) {
    std::string written;
    for (const auto& piece : text.pieces) {
        if (const auto* words = std::get_if<std::string>(&piece)) {
            written += *words;
        } else if (const auto* value = std::get_if<RuleValue>(&piece)) {
            written += grouped(value_of(book, state, host, *value));
        } else if (const auto* counted = std::get_if<RuleText::Counted>(&piece)) {
            const std::int64_t count = value_of(book, state, host, counted->value);
            written +=
                fmt::format("{} {}", grouped(count), count == 1 ? counted->one : counted->other);
        } else {
            const std::int64_t left =
                seconds_left(state, host, std::get<RuleText::Clock>(piece).timer);
            written += fmt::format("{}:{:02}", left / 60, left % 60);
        }
    }
    return written;
}

const RuleTask* task_of(const RuleBook& book, const RuleState& state, const RuleHost& host) {
    for (const RuleTask& task : book.tasks)
        if (hold(book, state, host, task.needs)) return &task;
    return nullptr;
}

std::string task_text(const RuleBook& book, const RuleState& state, const RuleHost& host) {
    const RuleTask* const task = task_of(book, state, host);
    return task ? text_of(book, state, host, task->text) : std::string();
}

}  // namespace carom
