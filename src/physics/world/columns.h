#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// What can be done to all columns of a table at once.
///
/// A table, such as Balls or Capsules, has one vector for each quantity. Each is as long as the
/// table, or empty where the scene does not use that quantity. The table lists its columns once, in
/// `Table::for_each_column(visit)`, which calls `visit(column)` with `column.values` a pointer to
/// the vector. The functions below go through that list, so a new column needs no change here.
namespace carom {

/// Removes the row at `index`. Pre: there is one.
template <typename Table>
void erase_row(Table& table, std::size_t index) {
    Table::for_each_column([&](const auto& column) {
        auto& values = table.*column.values;
        if (!values.empty()) values.erase(values.begin() + static_cast<std::ptrdiff_t>(index));
    });
}

/// Removes the rows whose entry in `is_gone` is not 0. Pre: one entry for each row.
template <typename Table>
void erase_rows(Table& table, std::span<const std::uint8_t> is_gone) {
    Table::for_each_column([&](const auto& column) {
        auto& values = table.*column.values;
        if (values.empty()) return;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!is_gone[i]) values[kept++] = values[i];
        values.resize(kept);
    });
}

/// Makes `part` the rows `rows` of `whole`, in that order.
template <typename Table>
void copy_rows(const Table& whole, std::span<const std::uint32_t> rows, Table& part) {
    Table::for_each_column([&](const auto& column) {
        const auto& from = whole.*column.values;
        auto& to = part.*column.values;
        to.clear();
        if (from.empty()) return;
        to.reserve(rows.size());
        for (const std::uint32_t row : rows)
            to.push_back(from[row]);
    });
}

/// Overwrites the rows `rows` of `whole` with those of `part`. Pre: both tables have the same
/// columns in use, and `part` has a row for each entry of `rows`.
template <typename Table>
void write_rows(const Table& part, std::span<const std::uint32_t> rows, Table& whole) {
    Table::for_each_column([&](const auto& column) {
        const auto& from = part.*column.values;
        auto& to = whole.*column.values;
        if (to.empty()) return;
        for (std::size_t i = 0; i < rows.size(); ++i)
            to[rows[i]] = from[i];
    });
}

/// Bytes of memory that the columns hold.
template <typename Table>
std::size_t bytes_in_columns(const Table& table) {
    std::size_t bytes = 0;
    Table::for_each_column([&](const auto& column) {
        const auto& values = table.*column.values;
        bytes += values.capacity() * sizeof(values[0]);
    });
    return bytes;
}

}  // namespace carom
