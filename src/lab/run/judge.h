#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "lab/run/figures.h"
#include "level/scene/quantities.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// Judges the experiments of a level: measures the quantity of an `expect` and decides whether it
/// holds.
namespace carom {

/// The present value of the quantity. None if it has no value: for a ball that is gone, the mean of
/// empty bins, a ratio to a variance of 0, an observable that is not observed or not defined
/// (lab/observe), or a quantity of scope `run` without a watch. Units: those of the world.
std::optional<double> measure(const Quantity& quantity, const World& world, const RunWatch* watch);

enum class Verdict : std::uint8_t { holds, fails, not_judged };
/// The word in reports: "holds", "fails", "not judged".
std::string_view name(Verdict verdict);
/// At which ticks an expectation is judged: "at", "end", "by", "always" or "never".
std::string_view when_word(const Expect& expect);

struct Judgement {
    Verdict verdict = Verdict::not_judged;
    /// At the tick that decided, else at the last one judged.
    std::optional<double> measured;
    std::string_view reason;     ///< why not judged; empty otherwise
    std::optional<double> time;  ///< of the tick that `measured` is from, s
    /// Of Expect::When::by: the value that came nearest to holding, at its first tick, and when.
    std::optional<double> nearest{};
    double nearest_time = 0.0;  ///< s
    bool is_decided = false;    ///< no later tick can change the verdict
};

/// Judges the expectation at the present tick, and updates its judgement. Called after every tick,
/// in order, the start included. `is_last`: the run ends here, so expectations without a time are
/// judged.
///
/// A tick at which the quantity has no value (see measure()) counts for none of `by`, `always` and
/// `never`; if it had none at any tick, the expectation fails. So does one at a certain time.
void judge(const Expect& expect, const World& world, const RunWatch& watch, bool is_last,
           Judgement& judgement);

}  // namespace carom
