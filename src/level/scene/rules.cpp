#include "level/scene/rules.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace carom {

namespace {

// Whether an event happens to one subject, of which each has an index of its own. Sets of balls
// overlap, so what happens to balls is looked up by the event alone.
bool has_own_subject(RuleEvent event) {
    using enum RuleEvent;
    return event == hit || event == all || event == enter || event == timer_ends;
}

constexpr RuleQuantityRow quantity_rows[]{
    {"score", "of the player whose turn it is"},
    {"player", "whose turn it is: 1, 2 ..."},
    {"players", "how many play"},
    {"ball", "the number of the ball in play", RuleGames::pinball},
    {"bonus", "the bonus so far", RuleGames::pinball},
    {"multiplier", "of the bonus", RuleGames::pinball},
    {"innings", "the turns that the player has had, with this one", RuleGames::shots},
    {"shots", "those that the player has taken", RuleGames::shots},
    {"fouls", "those that the player has made", RuleGames::shots},
    {"best", "the highest score of all players"},
    {"multiball", "1 while two balls or more are in play, else 0", RuleGames::pinball},
    {"rest", "1 while no ball moves, else 0", RuleGames::shots},
};
static_assert(std::size(quantity_rows) == static_cast<std::size_t>(RuleQuantity::count));

}  // namespace

std::span<const RuleQuantityRow> rule_quantities() {
    return quantity_rows;
}

void index_rules(RuleBook& book) {
    const auto key = [&](std::uint32_t number) {
        const Rule& rule = book.rules[number];
        return std::pair(rule.event, has_own_subject(rule.event) ? rule.subject : no_subject);
    };
    book.order.resize(book.rules.size());
    std::iota(book.order.begin(), book.order.end(), 0u);
    std::ranges::stable_sort(book.order, {}, key);
    book.rows.clear();
    for (std::uint32_t i = 0; i < book.order.size(); ++i) {
        const auto [event, subject] = key(book.order[i]);
        if (book.rows.empty() || book.rows.back().event != event ||
            book.rows.back().subject != subject)
            book.rows.push_back({event, subject, i, i});
        book.rows.back().last = i + 1;
    }
}

const RuleBook::Row* rules_of(const RuleBook& book, RuleEvent event, std::uint32_t subject) {
    const auto key = [](const RuleBook::Row& row) { return std::pair(row.event, row.subject); };
    const auto found = std::ranges::lower_bound(book.rows, std::pair(event, subject), {}, key);
    if (found == book.rows.end() || key(*found) != std::pair(event, subject)) return nullptr;
    return &*found;
}

}  // namespace carom
