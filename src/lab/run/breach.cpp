#include "lab/run/breach.h"

#include <fmt/format.h>

namespace carom {

std::string_view name(Breach::Kind kind) {
    constexpr std::string_view names[] = {"finite", "energy", "side", "escape", "overlap", "time"};
    return names[static_cast<std::size_t>(kind)];
}

std::string text(const Breach& breach, double rate) {
    std::string where;
    if (breach.ball) where += fmt::format(", ball {}", number(*breach.ball));
    if (breach.other) where += fmt::format(", ball {}", number(*breach.other));
    if (breach.edge) where += fmt::format(", edge {}", number(*breach.edge));
    return fmt::format("{} is broken in tick {} ({:.6g} s){}: by {:.6g}", name(breach.kind),
                       breach.tick, static_cast<double>(breach.tick) / rate, where, breach.amount);
}

}  // namespace carom
