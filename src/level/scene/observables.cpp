#include "level/scene/observables.h"

#include <algorithm>
#include <array>

namespace carom {
namespace {

constexpr std::array<ObservableRow, 6> table{{
    {Observable::pressure, "pressure", "pressure"},
    {Observable::msd, "msd", "mean square displacement"},
    {Observable::vacf, "vacf", "velocity autocorrelation"},
    {Observable::speeds, "speeds", "speeds / Maxwell-Boltzmann"},
    {Observable::pairs, "pairs", "pair distribution g(r)"},
    {Observable::lyapunov, "lyapunov", "Lyapunov exponent"},
}};

}  // namespace

std::span<const ObservableRow> observables() {
    return table;
}

const ObservableRow& row_of(Observable what) {
    return table[static_cast<std::size_t>(what)];
}

const ObservableRow* observable_named(std::string_view name) {
    const auto found = std::ranges::find(table, name, &ObservableRow::name);
    return found == table.end() ? nullptr : &*found;
}

}  // namespace carom
