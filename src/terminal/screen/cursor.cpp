#include "terminal/screen/cursor.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>

namespace carom {
namespace {

/// A movement along one axis.
struct Step {
    enum class Kind : std::uint8_t {
        none,
        carriage_return,  ///< then forward
        controls,         ///< backspaces, line feeds
        relative,
        absolute
    };
    Kind kind = Kind::none;
    std::size_t size = 0;  ///< bytes

    void offer(Kind other, std::size_t other_size) {
        if (other_size < size) *this = {other, other_size};
    }
};

std::size_t digits(int number) {
    return number < 10 ? 1 : number < 100 ? 2 : number < 1000 ? 3 : 4;
}

Step sideways(const TerminalDialect& dialect, int columns, int from, int to) {
    using enum Step::Kind;
    if (from == to) return {};
    Step best{carriage_return, 1 + (to > 0 ? sequence_size(to) : 0)};
    if (dialect.has_column) best.offer(absolute, sequence_size(to + 1));
    if (from >= columns) return best;
    best.offer(relative, sequence_size(std::abs(to - from)));
    if (to < from) best.offer(controls, static_cast<std::size_t>(from - to));
    return best;
}

Step up_or_down(const TerminalDialect& dialect, int from, int to) {
    using enum Step::Kind;
    if (from == to) return {};
    Step best{relative, sequence_size(std::abs(to - from))};
    if (dialect.has_row) best.offer(absolute, sequence_size(to + 1));
    if (to > from) best.offer(controls, static_cast<std::size_t>(to - from));
    return best;
}

void append_sideways(std::string& bytes, const Step& step, int from, int to) {
    switch (step.kind) {
        case Step::Kind::none:
            return;
        case Step::Kind::carriage_return:
            bytes += '\r';
            if (to > 0) append_sequence(bytes, to, 'C');
            return;
        case Step::Kind::controls:
            bytes.append(step.size, '\b');
            return;
        case Step::Kind::relative:
            return append_sequence(bytes, std::abs(to - from), to > from ? 'C' : 'D');
        case Step::Kind::absolute:
            return append_sequence(bytes, to + 1, 'G');
    }
}

void append_up_or_down(std::string& bytes, const Step& step, int from, int to) {
    if (step.kind == Step::Kind::controls) bytes.append(step.size, '\n');
    if (step.kind == Step::Kind::relative) {
        append_sequence(bytes, std::abs(to - from), to > from ? 'B' : 'A');
    }
    if (step.kind == Step::Kind::absolute) append_sequence(bytes, to + 1, 'd');
}

}  // namespace

std::size_t sequence_size(int number) {
    return 3 + (number == 1 ? 0 : digits(number));
}

void append_sequence(std::string& bytes, int number, char final) {
    bytes += "\033[";
    if (number != 1) bytes += std::to_string(number);
    bytes += final;
}

std::size_t sideways_size(const TerminalDialect& dialect, int columns, int from, int to) {
    return sideways(dialect, columns, from, to).size;
}

void append_movement(std::string& bytes, const TerminalDialect& dialect, int columns,
                     const std::optional<CursorPlace>& from, const CursorPlace& to) {
    if (dialect.move) {
        bytes += dialect.move(to.row, to.column);
        return;
    }
    const bool is_first_column = to.column == 0;
    const std::size_t absolute = is_first_column ? sequence_size(to.row + 1)
                                                 : 4 + digits(to.row + 1) + digits(to.column + 1);
    if (from) {
        // Columns first: a line feed at the margin may wrap.
        const Step along = sideways(dialect, columns, from->column, to.column);
        const Step across = up_or_down(dialect, from->row, to.row);
        if (along.size + across.size < absolute) {
            append_sideways(bytes, along, from->column, to.column);
            append_up_or_down(bytes, across, from->row, to.row);
            return;
        }
    }
    if (is_first_column) return append_sequence(bytes, to.row + 1, 'H');
    bytes += fmt::format("\033[{};{}H", to.row + 1, to.column + 1);
}

}  // namespace carom
