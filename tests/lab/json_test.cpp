#include "lab/json.h"

#include <doctest/doctest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

using namespace carom;

namespace {

double read_back(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    REQUIRE(error == std::errc{});
    REQUIRE(end == text.data() + text.size());
    return value;
}

}  // namespace

TEST_CASE("numbers read back to the same double") {
    for (const double value : {0.0, -0.0, 1.0, -3.0, 0.1, 1.0 / 3.0, 1e22, 1e300, 5e-324,
                               std::numeric_limits<double>::max(), 9007199254740993.0}) {
        const std::string text = json_number(value);
        CAPTURE(text);
        CHECK(read_back(text) == value);
        CHECK(std::signbit(read_back(text)) == std::signbit(value));
        CHECK(text.find_first_of(".e") != std::string::npos);
    }
}

TEST_CASE("values that JSON cannot express are null") {
    CHECK(json_number(std::numeric_limits<double>::infinity()) == "null");
    CHECK(json_number(-std::numeric_limits<double>::infinity()) == "null");
    CHECK(json_number(std::nan("")) == "null");
}

TEST_CASE("strings are escaped, and always UTF-8") {
    struct Row {
        std::string text;
        std::string json;
    };
    const Row rows[] = {
        {"plain", R"("plain")"},
        {"", R"("")"},
        {"a \"quoted\" \\ word", R"("a \"quoted\" \\ word")"},
        {"line\nand\ttab\r", R"("line\nand\ttab\r")"},
        {std::string("\0\x1b\x7f", 3), R"("\u0000\u001b\u007f")"},
        {"caf\xc3\xa9 \xf0\x9f\x8e\xb1", "\"caf\xc3\xa9 \xf0\x9f\x8e\xb1\""},
        {"\xff", "\"\xef\xbf\xbd\""},
        {"\xc0\xaf", "\"\xef\xbf\xbd\xef\xbf\xbd\""},                  // overlong
        {"\xed\xa0\x80", "\"\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\""},  // surrogate
        {"cut \xe2\x82", "\"cut \xef\xbf\xbd\xef\xbf\xbd\""},
        {"\xf4\x90\x80\x80", "\"\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\""},
    };
    for (const Row& row : rows)
        CHECK(json_string(row.text) == row.json);
}

TEST_CASE("the writer adds commas and line breaks") {
    JsonWriter json;
    using Layout = JsonWriter::Layout;
    json.begin_object(Layout::lines);
    json.field("a", 1.5);
    json.key("list");
    json.begin_list(Layout::one_line);
    json.value(std::uint64_t{1});
    json.null();
    json.begin_list(Layout::lines);
    json.end_list();
    json.end_list();
    json.key("deep");
    json.begin_list(Layout::lines);
    json.begin_object(Layout::one_line);
    json.field("x", true);
    json.field("y", "z");
    json.end_object();
    json.value(2.0);
    json.end_list();
    json.end_object();
    CHECK(std::move(json).text() ==
          "{\n"
          "  \"a\": 1.5,\n"
          "  \"list\": [1, null, []],\n"
          "  \"deep\": [\n"
          "    {\"x\": true, \"y\": \"z\"},\n"
          "    2.0\n"
          "  ]\n"
          "}\n");
}
