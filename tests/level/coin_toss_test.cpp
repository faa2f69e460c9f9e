#include <cmath>
#include <filesystem>
#include <numeric>

#include <doctest/doctest.h>

#include "level/load.h"
#include "level/support/files.h"
#include "physics/solver.h"

using namespace carom;

TEST_SUITE("long") {
    TEST_CASE("event: the coin-toss board is fair over several seeds") {
        const std::string text =
            test::read_file(std::filesystem::path(CAROM_SOURCE_DIR) / "levels/coin-toss.level");
        for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
            CAPTURE(seed);
            const LoadResult loaded = load_level(text, "coin-toss.level", {.seed = seed});
            REQUIRE(loaded.scene.has_value());
            World world = loaded.scene->world;
            Solver solver({.kind = SolverKind::event});
            while (world.time() < 123.0)
                solver.tick(world);
            const auto& bins = world.ledger().counters;
            REQUIRE(bins.size() == 13);
            const double count =
                static_cast<double>(std::accumulate(bins.begin(), bins.end(), std::uint64_t{0}));
            CHECK(count == 4000.0);
            double mean = 0.0;
            double squares = 0.0;
            double chi_square = 0.0;
            double share = 1.0 / 4096.0;  // of 12 equal tosses
            for (std::size_t i = 0; i < bins.size(); ++i) {
                const double place = static_cast<double>(i);
                const double found = static_cast<double>(bins[i]);
                mean += found * place / count;
                squares += found * place * place / count;
                chi_square += (found - count * share) * (found - count * share) / (count * share);
                share *= (12.0 - place) / (place + 1.0);
            }
            const double variance = (squares - mean * mean) / 3.0;
            MESSAGE("seed ", seed, ": variance ", variance, " of the binomial's, chi-square ",
                    chi_square);
            CHECK(std::fabs(variance - 1.0) < 0.05);
            CHECK(chi_square < 26.2);  // the 1 % level, 12 degrees of freedom
        }
    }
}
