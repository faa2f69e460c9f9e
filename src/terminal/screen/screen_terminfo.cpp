#include "terminal/screen/screen_terminfo.h"

#define NCURSES_NOMACROS 1
#include <curses.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <string_view>

// Last, for it defines macros with names of everyday words.
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
    // Extended names: what 5 (Ctrl) and 3 (Alt) stand for in xterm's.
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

// Without the padding that tputs() would turn into time.
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
        // The second twelve are the first with Shift.
        const bool is_shifted = number > 12;
        table.add(sent, key::f1 + (is_shifted ? number - 12 : number) - 1,
                  is_shifted ? shift : no_modifier);
    }
    return table;
}

bool has_own_colors() {
    return unpadded(capability("op")).find("39;49") != std::string::npos;
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
