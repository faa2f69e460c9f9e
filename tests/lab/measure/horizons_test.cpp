#include "lab/measure/horizons.h"

#include <doctest/doctest.h>

using namespace carom;

using Points = std::vector<std::uint64_t>;

TEST_CASE("points are spread evenly on a logarithmic scale") {
    CHECK(spread(0).empty());
    CHECK(spread(1) == Points{1});
    CHECK(spread(2) == Points{1, 2});
    CHECK(spread(3) == Points{1, 2, 3});
    CHECK(spread(12) == Points{1, 2, 3, 4, 6, 8, 12});
    CHECK(spread(20) == Points{1, 2, 3, 4, 6, 8, 12, 16, 20});
    CHECK(spread(6, 5) == Points{1, 2, 3, 4, 5, 6});
    CHECK(spread(6, 4) == Points{1, 2, 3, 4, 6});
    CHECK(spread(6, 7) == Points{1, 2, 3, 4, 6});
    CHECK(spread(1000000).size() < 45);
}
