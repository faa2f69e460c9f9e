#pragma once

#include <cstddef>
#include <cstdint>

#include "physics/tick/work_budget.h"

// clang-format off
/// The thresholds of the method `swept`, in one table. Thresholds with a single use stand beside
/// it: when paths that have changed are searched in cells (candidates.cpp), from how many edges a
/// ball they get a map of their own, and the minimum step of the search at a moving edge
/// (geometry/impact.h).
///
/// | constant             | value | unit                           | ten times larger / smaller |
/// |----------------------|-------|--------------------------------|----------------------------|
/// | resting_approach     | 1.5   | g h (gravity over a substep)   | low bounces are lost / resting balls cost ever more impacts |
/// | resting_restitution  | 1e-6  | share of the approach          | resting balls hop / rounding makes them meet again |
/// | seesaw_restitution   | 0.01  | share of the approach          | balls hop on seesaws / they meet the turning edge again and freeze |
/// | seesaw_following     | 4     | gravity                        | a fast light seesaw gains energy / balls hop on seesaws that turn |
/// | uncounted_lift       | 1e-5  | radii of the ball, in a substep | balls that leave edges gain energy / balls come to rest elsewhere between two edges |
/// | rounding             | 1e-14 | share of the speeds            | slow contacts are lost / rounding counts as contact |
/// | most_resting_impacts | 16    | of a ball in a substep         | piles cost more / sliding balls freeze |
/// | budget               | 12500 | tests of a pair, by ball and tick | ticks of 10 s / time stands still in jams and tubes |
/// | far                  | 16    | radii of the ball, in a substep | 100 times as many pairs / substeps where none are needed |
/// | short_path           | 4     | radii of the ball, in a substep | 100 times as many pairs / ever more substeps |
/// | most_far_balls       | 400   | balls in a substep             | substeps of ever more pairs / shots cost substeps of all balls |
/// | most_substeps        | 256   | of a tick                      | endless ticks / fast balls stand still |
// clang-format on
namespace carom::swept_tolerance {

/// A pair that loses energy and approaches slower than this many times the speed that gravity gives
/// in a substep does not bounce.
inline constexpr double resting_approach = 1.5;
/// A ball that comes to rest separates at this share of its approach, so that rounding does not
/// make it meet again.
inline constexpr double resting_restitution = 1e-6;
/// A ball that comes to rest on a seesaw separates at this share of its approach. x10: it hops
/// visibly; /10: as the edge turns it meets the edge again in the substep, and freezes.
inline constexpr double seesaw_restitution = 0.01;
/// A ball rests on a seesaw only where following it takes an acceleration of at most this many
/// times gravity.
inline constexpr double seesaw_following = 4.0;
/// A resting ball that leaves one of its edges along another one may rise by this much without
/// paying for it.
inline constexpr double uncounted_lift = 1e-5;
/// An approach slower than this share of the speeds of two bodies that touch, and of what gravity
/// gives, is rounding.
inline constexpr double rounding = 1e-14;
/// A ball freezes after so many impacts in a substep that leave it resting; on cloth after twice
/// as many, since at the first limit it stops sliding.
inline constexpr std::uint32_t most_resting_impacts = 16;
/// The work of a tick (tick/work_budget.h): tests of a pair of bodies, each some 40 ns, by ball. An
/// impact counts as `work_of_impact` tests more.
inline constexpr WorkBudget::Allowance budget{.per_ball = 12'500, .least_balls = 20};
inline constexpr std::uint64_t work_of_impact = 16;
/// A ball goes far in a substep if its path is longer than this many of its radii. In a substep in
/// which more than `most_far_balls` go far, pairs are too many (division.h): then they go about
/// `short_path` in each substep.
inline constexpr double far = 16.0;
inline constexpr double short_path = 4.0;
inline constexpr std::ptrdiff_t most_far_balls = 400;
inline constexpr int most_substeps = 256;

}  // namespace carom::swept_tolerance
