#include "level/text/lookalikes.h"

#include <doctest/doctest.h>

#include "level/text/diagnostic.h"

using namespace carom;

TEST_CASE("lookalikes are replaced one for one, outside of quotes and comments") {
    CHECK(mended("ball at=0,0").mends.empty());
    CHECK(mended("ball \u00e4 at=0,0").mends.empty());  // a letter
    const MendedLine line = mended("ball\u00a0a at=\u22122,0 \"\u2212\" # \u2212");
    CHECK(line.text == "ball a at=-2,0 \"\u2212\" ");
    REQUIRE(line.mends.size() == 2);
    CHECK(line.mends[0].column == 5);
    CHECK(line.mends[0].lookalike->name == "a no-break space");
    CHECK(line.mends[1].column == 11);
    CHECK(mended("carom 1 \u201cA \u2013 B\u201d").text == "carom 1 \"A \u2013 B\"");
}

TEST_CASE("no message shows characters that hide or turn others") {
    CHECK(printable("a\u202eb\u200bc") == "a?b?c");
    CHECK(printable("\u2212\u00a0\u200d") == "\u2212\u00a0\u200d");
}
