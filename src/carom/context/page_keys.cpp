#include "carom/context/page_keys.h"

namespace carom {

std::optional<int> scroll_of(const InputEvent& event) {
    constexpr int page = 10;
    constexpr int all = 1 << 20;
    switch (event.key) {
        case key::up:
        case U'k':
            return -1;
        case key::down:
        case U'j':
            return 1;
        case key::page_up:
            return -page;
        case key::page_down:
        case key::space:
            return page;
        case key::home:
            return -all;
        case key::end:
            return all;
        default:
            return std::nullopt;
    }
}

}  // namespace carom
