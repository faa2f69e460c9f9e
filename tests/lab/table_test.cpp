#include "lab/table.h"

#include <doctest/doctest.h>

using namespace carom;

TEST_CASE("columns are as wide as their widest cell") {
    Table table({"<name", "n", "<"});
    table.add({"a", "12345", "x"});
    table.add({"longer", "1", ""});
    CHECK(table.text() ==
          "name        n\n"
          "a       12345  x\n"
          "longer      1\n");
}
