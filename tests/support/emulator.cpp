#include "support/emulator.h"

#include <cstdint>
#include <utility>

namespace carom::test {
namespace {

void append_utf8(std::string& text, std::uint32_t code) {
    const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) return add(code);
    if (code < 0x800) {
        add(0xc0 | code >> 6);
    } else {
        if (code < 0x10000) {
            add(0xe0 | code >> 12);
        } else {
            add(0xf0 | code >> 18);
            add(0x80 | (code >> 12 & 0x3f));
        }
        add(0x80 | (code >> 6 & 0x3f));
    }
    add(0x80 | (code & 0x3f));
}

std::optional<int> index_of(const VTermColor& color) {
    if ((color.type & VTERM_COLOR_DEFAULT_MASK) != 0) return std::nullopt;
    if (VTERM_COLOR_IS_INDEXED(&color)) return color.indexed.idx;
    return 1 << 24 | color.rgb.red << 16 | color.rgb.green << 8 | color.rgb.blue;
}

}  // namespace

std::string described(const CellLook& look) {
    const bool is_marked = look.is_underlined || look.is_reversed;
    const auto halves = [](int upper, int lower) {
        return "halves " + std::to_string(upper) + ' ' + std::to_string(lower);
    };
    if (!is_marked) {
        if (look.glyph == U' ') return halves(look.background, look.background);
        if (look.glyph == 0x2588) return halves(look.foreground, look.foreground);
        if (look.glyph == 0x2580) return halves(look.foreground, look.background);
        if (look.glyph == 0x2584) return halves(look.background, look.foreground);
    }
    std::string text = "glyph " + std::to_string(static_cast<unsigned>(look.glyph)) + ' ' +
                       std::to_string(look.foreground) + ' ' + std::to_string(look.background);
    if (look.is_bold) text += " bold";
    if (look.is_underlined) text += " underlined";
    if (look.is_reversed) text += " reversed";
    return text;
}

Emulator::Emulator(int columns, int rows, const EmulatorOptions& options,
                   std::function<void(std::string_view)> reply)
    : terminal_(vterm_new(rows, columns)), options_(options), reply_(std::move(reply)) {
    vterm_set_utf8(terminal_.get(), 1);
    screen_ = vterm_obtain_screen(terminal_.get());
    vterm_screen_enable_altscreen(screen_, 1);
    callbacks_.bell = [](void* self) {
        ++static_cast<Emulator*>(self)->bells_;
        return 1;
    };
    vterm_screen_set_callbacks(screen_, &callbacks_, this);
    vterm_output_set_callback(
        terminal_.get(),
        [](const char* bytes, std::size_t length, void* self) {
            static_cast<Emulator*>(self)->send({bytes, length});
        },
        this);
    vterm_screen_reset(screen_, 1);
}

void Emulator::send(std::string_view bytes) {
    if (!options_.answers) return;
    const bool is_offered = (bytes == "\033[?2026;0$y" && options_.has_synchronized_output) ||
                            (bytes == "\033[?1016;0$y" && options_.has_pixel_mouse);
    if (!is_offered) return reply_(bytes);
    std::string changed(bytes);
    changed[changed.size() - 3] = '2';
    reply_(changed);
}

void Emulator::write(std::string_view bytes) {
    // Answers must be in the order of the queries, whether libvterm or this class gives them.
    for (const char byte : bytes) {
        follow({&byte, 1});
        vterm_input_write(terminal_.get(), &byte, 1);
    }
}

// Tracks the state that libvterm does not report.
void Emulator::follow(std::string_view bytes) {
    for (const char byte : bytes) {
        if (byte == '\033') {
            const bool is_command = begun_.starts_with("\033]");
            if (is_command) follow_sequence(begun_);
            begun_ = byte;
        } else if (!begun_.empty()) {
            begun_ += byte;
            const bool is_csi = begun_.starts_with("\033[");
            const bool is_command = begun_.starts_with("\033]");
            const bool is_whole =
                is_csi ? begun_.size() > 2 && byte >= 0x40 && byte <= 0x7e : !is_command;
            if (is_whole) {
                follow_sequence(begun_);
                begun_.clear();
            }
        }
    }
}

void Emulator::follow_sequence(std::string_view sequence) {
    const auto answer = [&](const std::string& bytes) {
        if (options_.answers) reply_(bytes);
    };
    if (sequence == "\033]11;?" && !options_.background.empty()) {
        return answer("\033]11;" + options_.background + "\033\\");
    }
    if (sequence == "\033[16t" && options_.cell_wide > 0) {
        return answer("\033[6;" + std::to_string(options_.cell_high) + ';' +
                      std::to_string(options_.cell_wide) + 't');
    }
    if (options_.has_key_protocol) {
        if (sequence == "\033[?u") return answer("\033[?0u");
        if (sequence.starts_with("\033[>") && sequence.back() == 'u') ++key_stack_;
        if (sequence.starts_with("\033[<") && sequence.back() == 'u' && key_stack_ > 0) {
            --key_stack_;
        }
    }
    const bool is_mode =
        sequence.starts_with("\033[?") && (sequence.back() == 'h' || sequence.back() == 'l');
    if (!is_mode) return;
    int number = 0;
    for (const char byte : sequence.substr(3)) {
        if (byte >= '0' && byte <= '9') {
            number = 10 * number + (byte - '0');
        } else {
            modes_[number] = sequence.back() == 'h';
            number = 0;
        }
    }
}

void Emulator::resize(int columns, int rows) {
    vterm_set_size(terminal_.get(), rows, columns);
}

int Emulator::columns() const {
    int rows = 0;
    int columns = 0;
    vterm_get_size(terminal_.get(), &rows, &columns);
    return columns;
}

int Emulator::rows() const {
    int rows = 0;
    int columns = 0;
    vterm_get_size(terminal_.get(), &rows, &columns);
    return rows;
}

VTermScreenCell Emulator::cell(int column, int row) const {
    VTermScreenCell cell{};
    vterm_screen_get_cell(screen_, {.row = row, .col = column}, &cell);
    return cell;
}

CellLook Emulator::look(int column, int row) const {
    const VTermScreenCell cell = this->cell(column, row);
    return {.glyph = cell.chars[0] == 0 ? U' ' : static_cast<char32_t>(cell.chars[0]),
            .foreground = foreground(column, row).value_or(-1),
            .background = background(column, row).value_or(-1),
            .is_bold = cell.attrs.bold != 0,
            .is_underlined = cell.attrs.underline != 0,
            .is_reversed = cell.attrs.reverse != 0};
}

std::string Emulator::row(int row) const {
    std::string text;
    for (int column = 0; column < columns(); ++column) {
        const std::uint32_t code = cell(column, row).chars[0];
        append_utf8(text, code == 0 ? ' ' : code);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

std::string Emulator::text() const {
    std::string text;
    for (int i = 0; i < rows(); ++i) {
        text += row(i) + '\n';
    }
    return text;
}

std::optional<int> Emulator::foreground(int column, int row) const {
    return index_of(cell(column, row).fg);
}

std::optional<int> Emulator::background(int column, int row) const {
    return index_of(cell(column, row).bg);
}

bool Emulator::mode(int number) const {
    const auto found = modes_.find(number);
    return found != modes_.end() && found->second;
}

}  // namespace carom::test
