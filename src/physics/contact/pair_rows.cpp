#include "physics/contact/pair_rows.h"

#include <algorithm>
#include <tuple>

namespace carom {
namespace {

std::uint32_t row_of(const NearPair& pair) {
    return std::min(pair.a, pair.b);
}

// The order within a row.
auto place_in_row(const NearPair& pair) {
    return std::tuple(std::max(pair.a, pair.b), pair.edge, pair.across, pair.along);
}

bool is_before(const NearPair& first, const NearPair& second) {
    return place_in_row(first) < place_in_row(second);
}

// Rows are short, and mostly in order.
void sort_row(std::span<NearPair> row) {
    for (std::size_t k = 1; k < row.size(); ++k)
        for (std::size_t at = k; at > 0 && is_before(row[at], row[at - 1]); --at)
            std::swap(row[at], row[at - 1]);
}

}  // namespace

// A counting sort. While they fill, rows begin where their next free place is.
void PairRows::sort(std::span<const NearPair> found, std::span<const std::uint32_t> body_of,
                    Rows& rows) {
    const auto bodies = static_cast<std::uint32_t>(body_of.size());
    rows.begin.assign(bodies + 1, 0);
    rows.pairs.resize(found.size());
    for (const NearPair& pair : found)
        ++rows.begin[row_of(of_bodies(pair, body_of)) + 1];
    for (std::uint32_t body = 1; body <= bodies; ++body)
        rows.begin[body] += rows.begin[body - 1];
    for (const NearPair& each : found) {
        const NearPair pair = of_bodies(each, body_of);
        rows.pairs[rows.begin[row_of(pair)]++] = pair;
    }
    std::copy_backward(rows.begin.begin(), rows.begin.end() - 1, rows.begin.end());
    rows.begin[0] = 0;
    for (std::uint32_t body = 0; body < bodies; ++body)
        sort_row(std::span(rows.pairs)
                     .subspan(rows.begin[body], rows.begin[body + 1] - rows.begin[body]));
}

void PairRows::assign(std::span<const NearPair> found, std::span<const std::uint32_t> body_of) {
    std::swap(now_, before_);
    sort(found, body_of, now_);
}

void PairRows::replace(std::span<const NearPair> found, std::span<const std::uint32_t> body_of,
                       std::span<const std::uint8_t> has_moved) {
    sort(found, body_of, found_);
    std::swap(now_, before_);
    const auto bodies = static_cast<std::uint32_t>(body_of.size());
    now_.pairs.clear();
    now_.begin.resize(bodies + 1);
    for (std::uint32_t body = 0; body < bodies; ++body) {
        const auto begin = static_cast<std::uint32_t>(now_.pairs.size());
        now_.begin[body] = begin;
        for (std::uint32_t p = before_.begin[body]; p < before_.begin[body + 1]; ++p) {
            const NearPair& pair = before_.pairs[p];
            const bool is_gone =
                has_moved[pair.a] != 0 || (pair.b < bodies && has_moved[pair.b] != 0);
            if (!is_gone) now_.pairs.push_back(pair);
        }
        if (found_.begin[body] == found_.begin[body + 1]) continue;
        now_.pairs.insert(now_.pairs.end(), found_.pairs.begin() + found_.begin[body],
                          found_.pairs.begin() + found_.begin[body + 1]);
        sort_row(std::span(now_.pairs).subspan(begin));
    }
    now_.begin[bodies] = static_cast<std::uint32_t>(now_.pairs.size());
}

void PairRows::find_sources(std::vector<std::uint32_t>& source) const {
    source.resize(now_.pairs.size());
    for (std::size_t body = 0; body + 1 < now_.begin.size(); ++body) {
        std::uint32_t old = before_.begin[body];
        for (std::uint32_t p = now_.begin[body]; p < now_.begin[body + 1]; ++p) {
            while (old < before_.begin[body + 1] && is_before(before_.pairs[old], now_.pairs[p]))
                ++old;
            const bool is_same = old < before_.begin[body + 1] &&
                                 place_in_row(before_.pairs[old]) == place_in_row(now_.pairs[p]);
            source[p] = is_same ? old++ : none;
        }
    }
}

}  // namespace carom
