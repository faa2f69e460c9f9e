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
/// empty bins, a ratio to a variance of 0, or a quantity of scope `run` without a watch. Units:
/// those of the world.
std::optional<double> measure(const Quantity& quantity, const World& world, const RunWatch* watch);

enum class Verdict : std::uint8_t { holds, fails, not_judged };
/// The word in reports: "holds", "fails", "not judged".
std::string_view name(Verdict verdict);

struct Judgement {
    Verdict verdict = Verdict::not_judged;
    std::optional<double> measured;
    std::string_view reason;  ///< why not judged; empty otherwise
};

/// Holds if there is a value and it is within the tolerance, limits included.
Judgement judge(const Expect& expect, const World& world, const RunWatch& watch);

}  // namespace carom
