#include "terminal/input/capabilities.h"

namespace carom {

std::optional<bool> light_background_from(std::string_view colorfgbg) {
    const std::size_t cut = colorfgbg.rfind(';');
    if (cut == std::string_view::npos) return std::nullopt;
    const std::string_view background = colorfgbg.substr(cut + 1);
    const bool is_number = !background.empty() && background.size() <= 2 &&
                           background.find_first_not_of("0123456789") == std::string_view::npos;
    if (!is_number) return std::nullopt;
    int number = 0;
    for (const char digit : background) {
        number = 10 * number + (digit - '0');
    }
    if (number > 15) return std::nullopt;
    return number == 7 || number > 8;
}

std::optional<double> cell_aspect_from(int pixels_wide, int pixels_high, int columns, int rows) {
    if (columns <= 0 || rows <= 0) return std::nullopt;
    // Integer division, because a window is not always a whole number of cells.
    const int wide = pixels_wide / columns;
    const int high = pixels_high / rows;
    if (wide < 2 || high < 2 || high > 8 * wide || wide > 4 * high) return std::nullopt;
    return static_cast<double>(high) / wide;
}

}  // namespace carom
