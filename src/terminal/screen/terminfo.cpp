#include "terminal/screen/terminfo.h"

#define NCURSES_NOMACROS 1
#include <curses.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string_view>

// Included last, since it defines macros with everyday names.
#include <term.h>

namespace carom {
namespace {

struct NamedKey {
    const char* capability;
    char32_t key;
    std::uint8_t modifiers = no_modifier;
};
constexpr std::array named_keys{
    NamedKey{"kcuu1", key::up},
    NamedKey{"kcud1", key::down},
    NamedKey{"kcub1", key::left},
    NamedKey{"kcuf1", key::right},
    NamedKey{"khome", key::home},
    NamedKey{"kend", key::end},
    NamedKey{"kpp", key::page_up},
    NamedKey{"knp", key::page_down},
    NamedKey{"kich1", key::insert},
    NamedKey{"kdch1", key::remove},
    NamedKey{"kbs", key::backspace},
    NamedKey{"kcbt", key::backtab},
    NamedKey{"kent", key::enter},
    NamedKey{"ka1", key::home},
    NamedKey{"ka3", key::page_up},
    NamedKey{"kc1", key::end},
    NamedKey{"kc3", key::page_down},
    NamedKey{"kLFT", key::left, shift},
    NamedKey{"kRIT", key::right, shift},
    NamedKey{"kri", key::up, shift},
    NamedKey{"kind", key::down, shift},
    NamedKey{"kHOM", key::home, shift},
    NamedKey{"kEND", key::end, shift},
    NamedKey{"kPRV", key::page_up, shift},
    NamedKey{"kNXT", key::page_down, shift},
    NamedKey{"kIC", key::insert, shift},
    NamedKey{"kDC", key::remove, shift},
    // Extended names of xterm's: the suffix 5 means Ctrl, 3 means Alt.
    NamedKey{"kUP3", key::up, alt},
    NamedKey{"kDN3", key::down, alt},
    NamedKey{"kLFT3", key::left, alt},
    NamedKey{"kRIT3", key::right, alt},
    NamedKey{"kUP5", key::up, control},
    NamedKey{"kDN5", key::down, control},
    NamedKey{"kLFT5", key::left, control},
    NamedKey{"kRIT5", key::right, control},
};

// A string of the terminal's description; null where it has none.
const char* capability(const char* name) {
    const char* const found = tigetstr(name);
    return found == reinterpret_cast<const char*>(-1) ? nullptr : found;
}

// The string without its padding, which tputs() would turn into delays.
std::string unpadded(const char* text) {
    std::string result;
    for (std::string_view rest = text != nullptr ? text : ""; !rest.empty();) {
        const std::size_t start = rest.find("$<");
        const std::size_t end = rest.find('>', start);
        result += rest.substr(0, start);
        if (start == std::string_view::npos || end == std::string_view::npos) break;
        rest.remove_prefix(end + 1);
    }
    return result;
}

bool is_string(const char* name, std::string_view expected) {
    return unpadded(capability(name)) == expected;
}

// A terminal of 88 colours, or of any other number in between, is used as one of fewer colours.
int colors_in_use(int most, int promised) {
    if (most >= direct_colors) return direct_colors;
    const int known = std::max(described_colors(), promised);
    if (most < 8 || known < 8) return 0;
    if (most >= 256 && known >= 256) return 256;
    return std::min(known, most) >= 16 ? 16 : 8;
}

struct DescribedAttribute {
    Attribute attribute;
    const char* capability;
    int forbidden_in_color;  // the attribute's bit in "ncv"
};
constexpr std::array described_attribute_table{
    DescribedAttribute{bold, "bold", 32}, DescribedAttribute{dim, "dim", 16},
    DescribedAttribute{underline, "smul", 2}, DescribedAttribute{reverse, "rev", 4}};

std::uint8_t described_attributes() {
    std::uint8_t attributes = plain;
    for (const DescribedAttribute& row : described_attribute_table)
        if (has_capability(row.capability)) attributes |= row.attribute;
    return attributes;
}

std::uint8_t attributes_in_color() {
    const int forbidden = std::max(0, tigetnum("ncv"));
    std::uint8_t attributes = plain;
    for (const DescribedAttribute& row : described_attribute_table)
        if ((forbidden & row.forbidden_in_color) == 0) attributes |= row.attribute;
    return attributes;
}

// Whether the terminal moves and colours the way that all terminals since the VT100 do.
bool is_ecma48(int colors, int promised) {
    const auto color = [](int number) {
        const char* const text = capability("setaf");
        return text == nullptr ? std::string() : unpadded(tiparm(text, number));
    };
    const bool has_bright = colors == 16 || colors == 256;
    const bool colors_as_all_do = colors == 0 || colors == direct_colors || promised >= 256 ||
                                  color(1) == "\033[31m" || color(1) == "\033[38;5;1m";
    const bool brightens_as_all_do = !has_bright || described_colors() > 256 || promised >= 256 ||
                                     color(9) == "\033[91m" || color(9) == "\033[38;5;9m";
    const std::string reverses = unpadded(capability("rev"));
    return is_string("cup", "\033[%i%p1%d;%p2%dH") && (reverses.empty() || reverses == "\033[7m") &&
           colors_as_all_do && brightens_as_all_do;
}

std::string described_move(int row, int column) {
    return unpadded(tiparm(capability("cup"), row, column));
}

// "setf" and "setb" use the colour numbers of "setaf" and "setab" with red and blue exchanged.
std::string described_color(const char* ansi, const char* other, int color) {
    if (const char* const text = capability(ansi)) return unpadded(tiparm(text, color));
    constexpr std::array exchanged{0, 4, 2, 6, 1, 5, 3, 7};
    const char* const text = capability(other);
    return text == nullptr ? ""
                           : unpadded(tiparm(text, exchanged[static_cast<std::size_t>(color % 8)]));
}

std::string described_style(const SgrStyle& style) {
    std::string bytes = plain_style_bytes();
    for (const DescribedAttribute& row : described_attribute_table)
        if ((style.attributes & row.attribute) != 0) bytes += unpadded(capability(row.capability));
    if (style.foreground >= 0) bytes += described_color("setaf", "setf", style.foreground);
    if (style.background >= 0) bytes += described_color("setab", "setb", style.background);
    return bytes;
}

}  // namespace

bool is_described(const char* term) {
    int problem = 0;
    if (setupterm(term, STDOUT_FILENO, &problem) == ERR) return false;
    del_curterm(set_curterm(nullptr));
    return true;
}

bool has_capability(const char* name) {
    return capability(name) != nullptr;
}

KeyTable described_keys() {
    KeyTable table;
    for (const NamedKey& named : named_keys) {
        if (const char* const sent = capability(named.capability)) {
            table.add(sent, named.key, named.modifiers);
        }
    }
    constexpr unsigned function_keys = 24;
    for (unsigned number = 1; number <= function_keys; ++number) {
        const std::string name = fmt::format("kf{}", number);
        const char* const sent = capability(name.c_str());
        if (sent == nullptr) continue;
        // The second twelve function keys are the first with Shift.
        const bool is_shifted = number > 12;
        table.add(sent, key::f1 + (is_shifted ? number - 12 : number) - 1,
                  is_shifted ? shift : no_modifier);
    }
    return table;
}

bool is_modern_emulator() {
    return has_capability("smcup") && tigetnum("colors") >= 8;
}

int described_colors() {
    return has_capability("setaf") || has_capability("setf") ? tigetnum("colors") : 0;
}

TerminalDialect described_dialect(int most_colors, bool is_utf8, int promised_colors) {
    TerminalDialect dialect;
    dialect.colors = colors_in_use(most_colors, promised_colors);
    dialect.is_utf8 = is_utf8;
    dialect.attributes = described_attributes();
    dialect.attributes_in_color = attributes_in_color();
    dialect.has_own_colors = unpadded(capability("op")).find("39;49") != std::string::npos;
    dialect.erases_in_color = tigetflag("bce") > 0;
    dialect.has_erase_line = unpadded(capability("el")) == "\033[K";
    dialect.has_erase_cells = is_string("ech", "\033[%p1%dX");
    dialect.has_repeat = is_string("rep", "%p1%c\033[%p2%{1}%-%db");
    dialect.hides_cursor = capability("civis") != nullptr;
    dialect.has_row = is_string("vpa", "\033[%i%p1%dd");
    dialect.has_column = is_string("hpa", "\033[%i%p1%dG");
    dialect.waits_at_margin = tigetflag("am") <= 0 || tigetflag("xenl") > 0;
    dialect.clear = unpadded(capability("clear"));
    if (!is_ecma48(dialect.colors, promised_colors)) {
        dialect.has_erase_line = dialect.has_erase_cells = dialect.has_repeat = false;
        dialect.move = described_move;
        dialect.style = described_style;
    }
    return dialect;
}

std::string plain_style_bytes() {
    return unpadded(capability("sgr0")) + unpadded(capability("op"));
}

std::string farewell_bytes(int rows) {
    const std::string bytes = plain_style_bytes() + unpadded(capability("cnorm"));
    const char* const other_screen = capability("rmcup");
    if (other_screen != nullptr) return bytes + unpadded(other_screen);
    return bytes + unpadded(tiparm(capability("cup"), rows - 1, 0)) + "\r\n";
}

}  // namespace carom
