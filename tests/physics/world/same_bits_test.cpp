#include "physics/world/same_bits.h"

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "physics/world/random.h"

using namespace carom;

namespace {

SumOfBits sum_of(const std::vector<U64x2>& pairs) {
    SumOfBits sum;
    for (const U64x2& pair : pairs)
        sum.add(pair);
    return sum;
}

U64x2 bits_of(double x, double y) {
    return std::bit_cast<U64x2>(F64x2{x, y});
}

// Round numbers, most of whose bits are 0, and numbers like any other.
std::vector<U64x2> some_pairs(bool are_round) {
    std::vector<U64x2> pairs;
    for (std::uint32_t i = 0; i < 200; ++i) {
        const auto any = [i](std::uint64_t which) {
            return random_unit(1, RandomStream::lab, which, i) - 0.5;
        };
        const double x = are_round ? static_cast<double>(i % 7) : any(0);
        const double y = are_round ? -0.5 * static_cast<double>(i % 5) : any(1);
        pairs.push_back(bits_of(x, y));
    }
    return pairs;
}

constexpr std::uint64_t sign = std::uint64_t{1} << 63;

}  // namespace

TEST_CASE("sum of bits: the same for the same, another when one bit is another") {
    for (const bool are_round : {false, true}) {
        std::vector<U64x2> pairs = some_pairs(are_round);
        const SumOfBits sum = sum_of(pairs);
        CHECK(sum == sum_of(pairs));
        for (U64x2& pair : pairs)
            for (int lane = 0; lane < 2; ++lane)
                for (int bit = 0; bit < 64; ++bit) {
                    pair[lane] ^= std::uint64_t{1} << bit;
                    REQUIRE(!(sum_of(pairs) == sum));
                    pair[lane] ^= std::uint64_t{1} << bit;
                }
        pairs.pop_back();
        CHECK(!(sum_of(pairs) == sum));
    }
}

TEST_CASE("sum of bits: what is done to several at once does not cancel") {
    for (const bool are_round : {false, true}) {
        const std::vector<U64x2> pairs = some_pairs(are_round);
        const SumOfBits sum = sum_of(pairs);
        for (std::size_t i = 0; i < pairs.size(); ++i)
            for (std::size_t j = i + 1; j < pairs.size(); ++j) {
                std::vector<U64x2> changed = pairs;
                if (changed[i][0] != changed[j][0] || changed[i][1] != changed[j][1]) {
                    std::swap(changed[i], changed[j]);
                    REQUIRE(!(sum_of(changed) == sum));
                    changed = pairs;
                }
                for (const std::size_t at : {i, j})
                    changed[at] ^= U64x2{0, sign};
                REQUIRE(!(sum_of(changed) == sum));
            }
        // As much there and back in a row, and all of it reversed.
        for (std::size_t i = 0; i + 2 < pairs.size(); ++i) {
            std::vector<U64x2> changed = pairs;
            const U64x2 step{std::uint64_t{1} << 40, std::uint64_t{1} << 50};
            changed[i] += step;
            changed[i + 1] -= step + step;
            changed[i + 2] += step;
            REQUIRE(!(sum_of(changed) == sum));
        }
        std::vector<U64x2> reversed = pairs;
        for (U64x2& pair : reversed)
            pair ^= U64x2{sign, sign};
        CHECK(!(sum_of(reversed) == sum));
    }
}

TEST_CASE("kept ids: with and without gaps, told from any others") {
    const auto of = [](std::vector<std::uint32_t> numbers) {
        std::vector<BallId> ids;
        for (const std::uint32_t each : numbers)
            ids.push_back(BallId{each});
        return ids;
    };
    const std::vector<std::vector<BallId>> all{of({}),        of({1}),          of({2}),
                                               of({1, 2, 3}), of({2, 3, 4}),    of({1, 2, 4}),
                                               of({1, 3, 4}), of({1, 2, 3, 4}), of({1, 3, 4, 5})};
    for (std::size_t kept = 0; kept < all.size(); ++kept) {
        KeptIds<BallId> ids;
        ids.keep(all[kept]);
        for (std::size_t asked = 0; asked < all.size(); ++asked) {
            CAPTURE(kept);
            CAPTURE(asked);
            CHECK(ids.are(all[asked]) == (asked == kept));
        }
        REQUIRE(ids.size() == all[kept].size());
        for (std::size_t i = 0; i < ids.size(); ++i)
            CHECK(ids[i] == all[kept][i]);
    }
    CHECK(are_consecutive(of({})));
    CHECK(are_consecutive(of({7, 8})));
    CHECK(!are_consecutive(of({7, 9})));
}
