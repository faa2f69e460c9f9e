#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "lab/run/figures.h"
#include "level/scene/quantities.h"
#include "level/scene/scene.h"
#include "physics/world/world.h"

/// The experiments of a level: what an `expect` measures, and whether it holds.
namespace carom {

/// The quantity's value now. None where there is none: of a ball that is no longer there, of the
/// mean of empty bins, of a ratio to a variance of 0, of a quantity of scope `run` without a watch.
/// Units: those of the world.
std::optional<double> measure(const Quantity& quantity, const World& world, const RunWatch* watch);

enum class Verdict : std::uint8_t { holds, fails, not_judged };
/// As reports have it: "holds", "fails", "not judged".
std::string_view name(Verdict verdict);

struct Judgement {
    Verdict verdict = Verdict::not_judged;
    std::optional<double> measured;
    std::string_view reason;  ///< why not judged; empty otherwise
};

/// Holds when there is a value and it is within the tolerance, its ends included.
Judgement judge(const Expect& expect, const World& world, const RunWatch& watch);

}  // namespace carom
