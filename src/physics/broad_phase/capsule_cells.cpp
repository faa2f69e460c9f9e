#include "physics/broad_phase/capsule_cells.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

namespace carom {
namespace {

// Where more than one capsule in so many has changed, all are put in anew.
constexpr std::size_t most_mended = 4;

struct Span {
    double low = 0.0;
    double high = 0.0;
};

// The x range of the part of segment a..b whose y lies in low..high. Pre: some part does.
Span part_between(Vec2 a, Vec2 b, double low, double high) {
    if (a.y > b.y) std::swap(a, b);
    const auto x_at = [&](double y) {
        if (y <= a.y) return a.x;
        if (y >= b.y) return b.x;
        return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    };
    const double x0 = x_at(low);
    const double x1 = x_at(high);
    return {std::min(x0, x1), std::max(x0, x1)};
}

}  // namespace

// Row by row, the cells under the part of the capsule in that row. Rows and columns at the border
// reach outwards without end, on a torus too.
template <typename Visit>
void CapsuleCells::for_each_cell(const Capsule& shape, Visit&& visit) const {
    CellFrame frame = frame_;
    frame.wraps = false;
    const double reach = shape.radius + margin_;
    const Box box = grow(join({shape.start, shape.start}, {shape.end, shape.end}), reach);
    const int low = frame.row(box.low.y);
    const int high = frame.row(box.high.y);
    for (int row = low; row <= high; ++row) {
        const double bottom = frame.origin.y + row * frame.cell.y;
        const double from = row == 0 ? box.low.y : bottom;
        const double to = row == frame.rows - 1 ? box.high.y : bottom + frame.cell.y;
        // A hair wider than the row, so that rounding loses nothing.
        const double slack = reach + 1e-9 * frame.cell.y;
        const Span part = part_between(shape.start, shape.end, from - slack, to + slack);
        const double hair = 1e-9 * frame.cell.x;
        const int last = frame.column(part.high + reach + hair);
        for (int column = frame.column(part.low - reach - hair); column <= last; ++column)
            visit(frame.index(column, row));
    }
}

// Calls visit(cell, entry) for every cell of a capsule. On a torus every image that reaches it
// counts.
template <typename Visit>
void CapsuleCells::for_each_place(const World& world, std::uint32_t capsule, Visit&& visit) const {
    const Capsule& shape = world.capsules().shape[capsule];
    if (!frame_.wraps) {
        for_each_cell(shape, [&](std::uint32_t cell) { visit(cell, CapsuleEntry{capsule, 0, 0}); });
        return;
    }
    const Box whole = *world.model().wrap;
    const Vec2 torus = size(whole);
    for (int along = -1; along <= 1; ++along) {
        for (int across = -1; across <= 1; ++across) {
            const Vec2 shift{across * torus.x, along * torus.y};
            const Capsule image{shape.start + shift, shape.end + shift, shape.radius};
            if (!overlaps(grow(bounds(image), margin_), whole)) continue;
            for_each_cell(image, [&](std::uint32_t cell) {
                visit(cell, CapsuleEntry{capsule, static_cast<std::int8_t>(across),
                                         static_cast<std::int8_t>(along)});
            });
        }
    }
}

void CapsuleCells::note_held(const World& world) {
    held_.clear();
    for (const HeldCapsule& held : world.held_capsules()) {
        const auto index = index_of(world, held.id);
        if (index && (held_.empty() || held_.back() != *index))
            held_.push_back(static_cast<std::uint32_t>(*index));
    }
}

void CapsuleCells::update(const World& world, const CellFrame& frame, double margin) {
    if (frame == frame_ && margin == margin_ && mend(world)) return;
    frame_ = frame;
    margin_ = margin;
    build(world);
}

void CapsuleCells::build(const World& world) {
    note_held(world);
    shapes_ = world.capsules().shape;
    start_.assign(1, 0);
    entries_.clear();
    occupied_.clear();
    changed_.resize(shapes_.size());
    std::iota(changed_.begin(), changed_.end(), 0u);
    put_in_again(world);
}

bool CapsuleCells::mend(const World& world) {
    if (shapes_.size() != world.capsules().size() || start_.empty()) return false;
    note_held(world);
    note_changes(world);
    if (changed_.empty()) return true;
    if (most_mended * changed_.size() > shapes_.size()) return false;
    put_in_again(world);
    return true;
}

// Notes the capsules that are held now and were not, or the reverse, and those that are not held
// but have changed their shape.
void CapsuleCells::note_changes(const World& world) {
    changed_.clear();
    if (out_ != held_)
        std::ranges::set_symmetric_difference(out_, held_, std::back_inserter(changed_));
    const std::size_t let_go = changed_.size();
    const std::vector<Capsule>& now = world.capsules().shape;
    const auto look = [&](std::size_t from, std::size_t to) {
        // Nearly always all are the same, bit by bit.
        if (std::memcmp(now.data() + from, shapes_.data() + from, (to - from) * sizeof(Capsule)) ==
            0)
            return;
        for (std::size_t i = from; i < to; ++i)
            if (!(now[i] == shapes_[i])) changed_.push_back(static_cast<std::uint32_t>(i));
    };
    std::size_t from = 0;
    for (const std::uint32_t held : held_) {
        if (held > from) look(from, held);
        from = held + 1;
    }
    if (from < now.size()) look(from, now.size());
    if (let_go == 0 || let_go == changed_.size()) return;
    std::ranges::sort(changed_);
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
}

// Inserts the changed capsules in order; the entries of all others keep their order.
void CapsuleCells::put_in_again(const World& world) {
    newcomers_.clear();
    for (const std::uint32_t i : changed_) {
        shapes_[i] = world.capsules().shape[i];
        if (std::ranges::binary_search(held_, i)) continue;
        for_each_place(world, i, [&](std::uint32_t cell, CapsuleEntry entry) {
            newcomers_.push_back({cell, entry});
        });
    }
    std::swap(out_, held_);
    sort_newcomers();
    new_start_.assign(1, 0);
    new_entries_.clear();
    new_occupied_.clear();
    auto next = newcomers_.begin();
    for (std::size_t at = 0; at < occupied_.size() || next != newcomers_.end();) {
        constexpr std::uint32_t none = 0xffffffffu;
        const std::uint32_t cell = std::min(at < occupied_.size() ? occupied_[at] : none,
                                            next != newcomers_.end() ? next->cell : none);
        const auto put_in_before = [&](std::uint32_t index) {
            for (; next != newcomers_.end() && next->cell == cell && next->entry.index < index;
                 ++next)
                new_entries_.push_back(next->entry);
        };
        if (at < occupied_.size() && occupied_[at] == cell) {
            for (std::uint32_t i = start_[at]; i < start_[at + 1]; ++i) {
                const CapsuleEntry& stays = entries_[i];
                if (std::ranges::binary_search(changed_, stays.index)) continue;
                put_in_before(stays.index);
                new_entries_.push_back(stays);
            }
            ++at;
        }
        put_in_before(none);
        if (new_entries_.size() == new_start_.back()) continue;
        new_occupied_.push_back(cell);
        new_start_.push_back(static_cast<std::uint32_t>(new_entries_.size()));
    }
    start_ = new_start_;
    entries_ = new_entries_;
    occupied_ = new_occupied_;
    mark_occupied();
}

// By cell, those of a cell by capsule and image, which is how they came: where they are many digit
// by digit, the lowest first.
void CapsuleCells::sort_newcomers() {
    constexpr int bits = 11;
    constexpr std::uint32_t digits = 1u << bits;
    if (newcomers_.size() < digits / 4) {
        std::ranges::sort(newcomers_, {}, [](const Newcomer& n) {
            return std::tuple(n.cell, n.entry.index, n.entry.along, n.entry.across);
        });
        return;
    }
    for (int shift = 0; shift < 32 && frame_.count() >> shift != 0; shift += bits) {
        const auto digit_of = [shift](const Newcomer& n) { return n.cell >> shift & (digits - 1); };
        std::array<std::uint32_t, digits + 1> next{};
        for (const Newcomer& newcomer : newcomers_)
            ++next[digit_of(newcomer) + 1];
        for (std::uint32_t i = 1; i < digits; ++i)
            next[i] += next[i - 1];
        sorted_.resize(newcomers_.size());
        for (const Newcomer& newcomer : newcomers_)
            sorted_[next[digit_of(newcomer)]++] = newcomer;
        std::swap(newcomers_, sorted_);
    }
}

void CapsuleCells::mark_occupied() {
    words_.assign(frame_.count() / 64 + 1, {});
    before_.assign(frame_.count(), 0);
    std::uint32_t before = 0;
    auto next = occupied_.begin();
    for (std::uint32_t i = 0; i < words_.size(); ++i) {
        Word& word = words_[i];
        word.before = before;
        for (; next != occupied_.end() && *next / 64 == i; ++next) {
            before_[*next] = static_cast<std::uint8_t>(before++ - word.before);
            word.is_occupied |= std::uint64_t{1} << (*next % 64);
        }
    }
}

}  // namespace carom
