#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/hooks.h"
#include "lab/measure/contact_order.h"
#include "lab/measure/growth.h"
#include "lab/run/choice.h"
#include "level/scene/scene.h"

/// Compares two solvers from one start: when they diverge, at which collision, and how fast.
/// Distances are in ball radii (Comparison::radius is one), positions in lengths of the level.
namespace carom {

struct CompareSettings {
    Choice first;
    Choice second;
    double time = 10.0;       ///< s, > 0
    double tolerance = 1e-3;  ///< radii, > 0: a ball further from its counterpart has diverged
    double nudge = 0.0;       ///< radii: largest offset of the second run's balls at the start
};

/// The distance between the runs at an instant at which both have just completed a tick.
struct DifferenceAt {
    double time = 0.0;  ///< s
    double rms = 0.0;   ///< radii; infinite if a position is not finite
    double max = 0.0;
};

struct Divergence {
    double time = 0.0;  ///< s
    BallId ball{};      ///< the ball furthest from its counterpart
    Vec2 place;         ///< of that ball in the first run
    double distance = 0.0;
};

struct Comparison {
    Choice first;
    Choice second;
    double radius = 1.0;
    double tolerance = 0.0;
    std::vector<DifferenceAt>
        differences;                       ///< from the start on, one per period of the common rate
    std::optional<Divergence> divergence;  ///< none: the runs did not diverge
    /// The first contact that differs in order or partners; see first_difference.
    std::optional<FirstDifference> contact;
    /// The exponential part of the RMS difference. None where the runs did not diverge.
    std::optional<Growth> growth;
    /// The run ended early: from an RMS difference of one radius the runs are unrelated.
    bool is_lost = false;
    bool is_interrupted = false;

    double time() const { return differences.back().time; }
};

Comparison compare(const Scene& scene, const CompareSettings& settings, const GoOn& go_on);

/// For people: the result, the contact, the doubling time, and a table of the growth.
std::string compare_text(const Scene& scene, const Comparison& comparison);

/// One JSON object; docs/command-line.md lists the keys. At most 1,000 of the differences, evenly
/// spread.
std::string compare_json(std::string_view level, const Scene& scene, const Comparison& comparison);

}  // namespace carom
