#include "figures.h"

#include <fmt/format.h>

#include <cmath>

namespace carom::bench {

std::string grouped(double value) {
    std::string text = fmt::format("{:.0f}", value);
    for (std::size_t at = text.size(); at > 3 + (text.front() == '-' ? 1u : 0u);) {
        at -= 3;
        text.insert(at, ",");
    }
    return text;
}

std::string figure(double value) {
    const double size = std::abs(value);
    if (size >= 1e3) {
        const double unit = std::pow(10.0, std::floor(std::log10(size)) - 2.0);
        return grouped(std::round(value / unit) * unit);
    }
    if (size >= 100.0) return fmt::format("{:.0f}", value);
    if (size >= 10.0) return fmt::format("{:.1f}", value);
    if (size >= 1.0) return fmt::format("{:.2f}", value);
    if (size >= 0.1) return fmt::format("{:.3f}", value);
    if (size >= 0.01) return fmt::format("{:.4f}", value);
    return fmt::format("{:.3g}", value);
}

std::string small_figure(double value) {
    if (std::abs(value) >= 0.01) return fmt::format("{:.2g}", value);
    return value == 0.0 ? "0" : fmt::format("{:.0e}", value);
}

std::string change(double value) {
    if (std::abs(value) < 1e-5) return small_figure(std::abs(value));
    return fmt::format("{:+.2g} %", 100.0 * value);
}

}  // namespace carom::bench
