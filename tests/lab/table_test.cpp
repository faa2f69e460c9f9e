#include "lab/table.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("a table is as wide as what stands in it") {
    Table table({"<name", "n", "<"});
    table.add({"a", "12345", "x"});
    table.add({"longer", "1", ""});
    CHECK(table.text() ==
          "name        n\n"
          "a       12345  x\n"
          "longer      1\n");
}
