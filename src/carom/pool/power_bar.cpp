#include "carom/pool/power_bar.h"

#include <cmath>

namespace carom {

std::string power_bar(double share, const Look& look) {
    constexpr int width = 12;
    const int full = static_cast<int>(std::lround(share * width));
    std::string text = look.utf8 ? "▕" : "[";
    for (int i = 0; i < width; ++i)
        text += i < full ? (look.utf8 ? "█" : "#") : (look.utf8 ? "░" : "-");
    return text + (look.utf8 ? "▏" : "]");
}

}  // namespace carom
