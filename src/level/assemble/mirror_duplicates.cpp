#include "level/assemble/mirror_duplicates.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace carom {
namespace {

// The position and motion of an item, for exact comparison. The ends of an edge are in a fixed
// order.
using Spot = std::array<double, 6>;

struct Item {
    std::tuple<int, int, int> statement;  // source, line, column
    Spot place{};
    int image = 0;
    std::size_t index = 0;
};

Spot place_of(const Capsule& shape) {
    auto a = std::pair(shape.start.x, shape.start.y);
    auto b = std::pair(shape.end.x, shape.end.y);
    if (b < a) std::swap(a, b);
    return {a.first, a.second, b.first, b.second, shape.radius};
}

// For each item, by index, whether it is a duplicate.
std::vector<bool> find_duplicates(std::vector<Item> items) {
    std::vector<bool> is_duplicate(items.size(), false);
    const auto key = [](const Item& item) { return std::tuple(item.statement, item.place); };
    std::ranges::sort(items, [&](const Item& a, const Item& b) {
        return std::tuple(key(a), a.index) < std::tuple(key(b), b.index);
    });
    for (std::size_t i = 0; i < items.size();) {
        std::size_t end = i + 1;
        while (end < items.size() && key(items[end]) == key(items[i])) {
            is_duplicate[items[end].index] = items[end].image != items[i].image;
            ++end;
        }
        i = end;
    }
    return is_duplicate;
}

void remove_marked(BallList& balls, const std::vector<bool>& is_removed) {
    balls.remove(is_removed);
}

template <typename T>
void remove_marked(std::vector<T>& items, const std::vector<bool>& is_removed) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (is_removed[i]) continue;
        if (kept != i) items[kept] = std::move(items[i]);
        ++kept;
    }
    items.erase(items.begin() + static_cast<std::ptrdiff_t>(kept), items.end());
}

template <typename List>
bool has_copies(const List& items) {
    for (std::size_t i = 0; i < items.size(); ++i)
        if (items[i].origin.image != 0) return true;
    return false;
}

template <typename List, typename PlaceOf>
void remove_duplicates(List& items, PlaceOf place, std::vector<FillIr>* fills = nullptr) {
    if (!has_copies(items)) return;
    std::vector<Item> all;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto& item = items[i];
        const Span span = item.origin.span();
        all.push_back(
            {{span.source->order, span.line, span.column}, place(item), item.origin.image, i});
    }
    const std::vector<bool> is_duplicate = find_duplicates(std::move(all));
    if (fills) {
        std::vector<std::size_t> kept_before(items.size() + 1, 0);
        for (std::size_t i = 0; i < items.size(); ++i) {
            kept_before[i + 1] = kept_before[i] + (is_duplicate[i] ? 0 : 1);
        }
        for (FillIr& fill : *fills)
            fill.balls_before = kept_before[fill.balls_before];
    }
    remove_marked(items, is_duplicate);
}

}  // namespace

void remove_mirror_duplicates(LevelIr& ir) {
    remove_duplicates(ir.capsules, [](const CapsuleIr& c) { return place_of(c.shape); });
    remove_duplicates(ir.zones, [](const ZoneIr& z) { return place_of(z.zone.shape); });
    remove_duplicates(
        ir.balls,
        [](const BallIr& b) {
            return Spot{b.position.x, b.position.y,           b.velocity.x,
                        b.velocity.y, b.radius.value_or(0.0), b.spin};
        },
        &ir.fills);
    remove_duplicates(ir.emitters, [](const EmitterIr& e) {
        return Spot{e.emitter.at.x, e.emitter.at.y, e.emitter.velocity.x, e.emitter.velocity.y,
                    0.0};
    });
}

}  // namespace carom
