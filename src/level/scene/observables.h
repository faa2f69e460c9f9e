#pragma once

#include <cstdint>
#include <span>
#include <string_view>

/// What a laboratory measures of a run beyond its final state. Each costs time and memory, so it is
/// measured only where the level asks for it, by `observe`, `show` or `expect`. The measuring is in
/// lab/observe.
namespace carom {

enum class Observable : std::uint8_t {
    pressure,  ///< of the virial, and of impacts on edges
    msd,       ///< mean square displacement
    vacf,      ///< velocity autocorrelation function
    speeds,    ///< the distribution of speeds
    pairs,     ///< g(r), the pair distribution function
    lyapunov   ///< the time in which a small difference grows by a factor of e
};

struct ObservableRow {
    Observable what = Observable::pressure;
    std::string_view name;   ///< in levels and reports
    std::string_view title;  ///< of its panel
};
/// All of them, in the order of reports.
std::span<const ObservableRow> observables();
const ObservableRow& row_of(Observable what);
/// Null: there is none of this name.
const ObservableRow* observable_named(std::string_view name);

/// A set of observables.
class ObservableSet {
  public:
    void add(Observable what) { bits_ |= bit(what); }
    void add(ObservableSet other) { bits_ |= other.bits_; }
    bool has(Observable what) const { return (bits_ & bit(what)) != 0; }
    bool is_empty() const { return bits_ == 0; }

  private:
    static std::uint32_t bit(Observable what) { return 1U << static_cast<unsigned>(what); }
    std::uint32_t bits_ = 0;
};

/// The level's statement `observe`.
struct Observation {
    ObservableSet what;
    double from = 0.0;  ///< s: what was before that time does not count
};

}  // namespace carom
