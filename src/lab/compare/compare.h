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

/// Two solvers from one start: when they part, at which collision, and how fast. Lengths are told
/// in ball radii (Comparison::radius is one), but for places.
namespace carom {

struct CompareSettings {
    Choice first;
    Choice second;
    double time = 10.0;  ///< s, > 0
    double tolerance =
        1e-3;            ///< radii, > 0: further than this from its twin, and a ball has parted
    double nudge = 0.0;  ///< radii that balls of the second start from their twins at most
};

/// How far the two are apart at one instant at which both have just ended a tick.
struct Apart {
    double time = 0.0;  ///< s
    double rms = 0.0;   ///< radii; infinite where something is not finite
    double max = 0.0;
};

struct Parting {
    double time = 0.0;  ///< s
    BallId ball{};      ///< the one that is furthest from its twin
    Vec2 place;         ///< where it is in the first, in the level's lengths
    double distance = 0.0;
};

struct Comparison {
    Choice first;
    Choice second;
    double radius = 1.0;
    double tolerance = 0.0;
    std::vector<Apart> differences;  ///< from the start on, one a period of the common rate
    std::optional<Parting> parting;  ///< none: they did not part
    /// The first contact that differs in order or partners; see first_difference.
    std::optional<FirstDifference> contact;
    /// Where the RMS difference grows exponentially. None where the two did not part.
    std::optional<Growth> growth;
    /// The run ended early, because an RMS difference of a radius means that the two have nothing
    /// to do with each other any more.
    bool is_lost = false;
    bool is_interrupted = false;

    double time() const { return differences.back().time; }
};

Comparison compare(const Scene& scene, const CompareSettings& settings, const GoOn& go_on);

/// For people: the answer, the contact, the doubling time, and a table of the growth.
std::string compare_text(const Scene& scene, const Comparison& comparison);

/// One JSON object; docs/command-line.md lists the keys. At most 1,000 of the differences, evenly
/// spread.
std::string compare_json(std::string_view level, const Scene& scene, const Comparison& comparison);

}  // namespace carom
