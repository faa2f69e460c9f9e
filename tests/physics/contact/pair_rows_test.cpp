#include "physics/contact/pair_rows.h"

#include <algorithm>
#include <numeric>

#include <doctest/doctest.h>

#include "physics/world/random.h"

using namespace carom;

namespace {

constexpr std::uint32_t balls = 60;

double draw(std::uint64_t who, std::uint64_t index) {
    return random_between(0.0, 1.0, 79, RandomStream::level, who, index);
}

bool are_same(const NearPair& first, const NearPair& second) {
    return first.a == second.a && first.b == second.b && first.edge == second.edge &&
           first.across == second.across && first.along == second.along;
}

// Which of all possible pairs there are; some on two images of an edge.
std::vector<NearPair> drawn_pairs(std::uint64_t round) {
    std::vector<NearPair> pairs;
    std::uint64_t index = 1000 * round;
    for (std::uint32_t a = 0; a < balls; ++a) {
        for (std::uint32_t b = a + 1; b < balls; ++b)
            if (draw(index++, 0) < 0.1) pairs.push_back({.a = a, .b = b});
        for (std::uint32_t edge = 0; edge < 3; ++edge)
            if (draw(index++, 0) < 0.3)
                for (const auto across : {std::int8_t{0}, std::int8_t{1}})
                    pairs.push_back({.a = a, .b = balls, .edge = edge, .across = across});
    }
    return pairs;
}

bool is_of(const NearPair& pair, const std::vector<std::uint8_t>& is_ball) {
    return is_ball[pair.a] != 0 || (pair.b < balls && is_ball[pair.b] != 0);
}

}  // namespace

TEST_CASE("pair rows: pairs that are replaced bit by bit are in the order of all at once") {
    // Bodies are the balls in another order.
    std::vector<std::uint32_t> body_of(balls);
    for (std::uint32_t ball = 0; ball < balls; ++ball)
        body_of[ball] = ball * 7 % balls;
    std::vector<NearPair> pairs = drawn_pairs(0);
    PairRows rows;
    rows.assign(pairs, body_of);
    for (std::uint64_t round = 1; round < 30; ++round) {
        CAPTURE(round);
        std::vector<std::uint8_t> is_moved(balls);
        std::vector<std::uint8_t> has_moved(balls);
        for (std::uint32_t ball = 0; ball < balls; ++ball)
            is_moved[ball] = has_moved[body_of[ball]] = draw(ball, round) < 0.1 ? 1 : 0;
        std::erase_if(pairs, [&](const NearPair& pair) { return is_of(pair, is_moved); });
        std::vector<NearPair> found = drawn_pairs(round);
        std::erase_if(found, [&](const NearPair& pair) { return !is_of(pair, is_moved); });
        pairs.insert(pairs.end(), found.begin(), found.end());
        // Backwards, since the order in which they are found must not show.
        std::ranges::reverse(found);
        const std::vector<NearPair> before(rows.pairs().begin(), rows.pairs().end());
        rows.replace(found, body_of, has_moved);

        PairRows at_once;
        at_once.assign(pairs, body_of);
        REQUIRE(rows.pairs().size() == at_once.pairs().size());
        CHECK(std::ranges::equal(rows.pairs(), at_once.pairs(), are_same));

        std::vector<std::uint32_t> source;
        rows.find_sources(source);
        for (std::size_t p = 0; p < source.size(); ++p) {
            const auto same = std::ranges::find_if(
                before, [&](const NearPair& pair) { return are_same(pair, rows.pairs()[p]); });
            if (same == before.end())
                CHECK(source[p] == PairRows::none);
            else
                CHECK(source[p] == static_cast<std::uint32_t>(same - before.begin()));
        }
    }
}
