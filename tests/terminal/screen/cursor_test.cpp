#include "terminal/screen/cursor.h"

#include <doctest/doctest.h>

#include <string>

using namespace carom;

namespace {

constexpr int columns = 100;

std::string way(const std::optional<CursorPlace>& from, const CursorPlace& to,
                const TerminalDialect& dialect = {}) {
    std::string bytes;
    append_movement(bytes, dialect, columns, from, to);
    return bytes;
}

}  // namespace

TEST_CASE("the shortest movement") {
    CHECK(way(CursorPlace{0, 1}, {1, 0}) == "\r\n");
    CHECK(way(CursorPlace{1, 1}, {2, 1}) == "\n");
    CHECK(way(CursorPlace{2, 2}, {3, 1}) == "\b\n");
    CHECK(way(CursorPlace{3, 2}, {3, 50}) == "\033[51G");
    CHECK(way(CursorPlace{3, 90}, {3, 95}) == "\033[5C");
    CHECK(way(CursorPlace{3, 90}, {3, 81}) == "\033[9D");
    CHECK(way(CursorPlace{3, 50}, {20, 50}) == "\033[17B");
    CHECK(way(CursorPlace{30, 50}, {4, 50}) == "\033[5d");
    CHECK(way(CursorPlace{20, 51}, {39, 9}) == "\033[40;10H");
    CHECK(way(CursorPlace{39, 10}, {0, 0}) == "\033[H");
    CHECK(way(CursorPlace{39, 10}, {7, 0}) == "\033[8H");
    CHECK(way(std::nullopt, {3, 4}) == "\033[4;5H");
}

TEST_CASE("at the margin only movements that do not depend on the column are used") {
    CHECK(way(CursorPlace{1, columns}, {1, 98}) == "\033[99G");
    CHECK(way(CursorPlace{1, columns}, {1, 1}) == "\r\033[C");
    CHECK(way(CursorPlace{1, columns}, {2, 0}) == "\r\n");
}

TEST_CASE("a terminal without CHA and VPA, and one without ECMA-48") {
    TerminalDialect dialect;
    dialect.has_column = dialect.has_row = false;
    CHECK(way(CursorPlace{3, 2}, {3, 50}, dialect) == "\033[48C");
    CHECK(way(CursorPlace{3, 50}, {3, 2}, dialect) == "\r\033[2C");
    CHECK(way(CursorPlace{30, 50}, {4, 50}, dialect) == "\033[26A");
    dialect.move = [](int row, int column) {
        return std::to_string(row) + '|' + std::to_string(column);
    };
    CHECK(way(CursorPlace{3, 2}, {3, 3}, dialect) == "3|3");
}

TEST_CASE("the computed size of a movement along a row is its number of bytes") {
    for (int from : {0, 1, 7, 42, 98, 99, columns}) {
        for (int to = 0; to < columns; ++to) {
            if (from == to) continue;
            const std::size_t size = sideways_size({}, columns, from, to);
            CHECK(way(CursorPlace{5, from}, {5, to}).size() == size);
        }
    }
}
