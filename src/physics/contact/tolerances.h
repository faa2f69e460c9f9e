#pragma once

// clang-format off
/// The thresholds of the method `contact`, in one table. README.md in this folder names the
/// invariants that they serve. Thresholds with a single use stand beside it: how large skins are
/// (reference_positions.cpp), how far one that presses on a one-way edge may be through it
/// (classification.cpp), and from which speed `swept` takes more pieces (swept_fallback.cpp).
///
/// | constant          | value | unit                         | ten times larger / smaller |
/// |-------------------|-------|------------------------------|---|
/// | rest_speed_factor | 1.5   | g h (gravity over a substep) | piles never bounce / piles boil |
/// | most_travel       | 0.25  | radii a substep              | tunnelling through constraints / all is CCD, slow |
/// | most_fall         | 0.25  | smallest radius              | small balls pass through one another / more substeps |
/// | most_substeps     | 64    | substeps                     | a grain makes a scene slow / as most_fall |
/// | stiffness         | 0.22  | cycles a substep             | piles ring and gain energy / overlap grows a hundredfold |
/// | damping           | 10    | of critical damping          | overlaps close too slowly / piles ring |
/// | stiffening        | 5     | per radius of overlap        | piles tremble / loads sink in deeper |
/// | most_stiffening   | 0.5   | share                        | piles throw up what lands on them / as `stiffening` |
/// | over_relaxation   | 0.6   | share                        | iterations gain energy (from 1) / high piles swing for minutes |
/// | high_mass_ratio   | 4     | masses                       | heavy on light rocks for ever / most pairs cost four rounds |
/// | loaded_iterations | 4     | iterations                   | slower / heavy on light rocks |
/// | full_press        | 0.5   | g h                          | balls on slopes hop / a light push moves a ball the other way |
/// | far_fall          | 0.01  | ball's radius                | grains sink into what they fall with / rolling on steep curves costs energy |
/// | most_excess       | 4     | rest speeds                  | landings are thrown back up / falling piles overlap more |
/// | enclosed_contacts | 3     | contacts on a ball           | lively piles boil / no ball bounces in a pile |
/// | overlap_limit     | 0.5   | smaller radius               | balls pass through one another / pressed pairs become CCD |
/// | embedded          | 1.1   | overlap_limit                | crowds in one place freeze / pressed pairs sink through |
/// | soft_overlap      | 0.2   | of overlap_limit             | deep pairs are left to the constraints / falling piles never finish |
/// | strict_overlap    | 0.018 | smaller radius               | pushes squash jams / jams without gravity stand still longer |
/// | strict_share      | 0.5   | of the room left             | jams stand still longer, both ways |
/// | kinematic_overlap | 0.1   | ball's radius                | held edges sink into balls / they stutter |
/// | deep_overlap      | 0.25  | smallest radius              | overlap goes unnoticed by CCD, crowds stay crowds / every pair is searched |
/// | closing_margin    | 0.02  | smallest radius              | more idle constraints / pushed balls reach others late |
/// | few_leaving       | 32    | balls to one that leaves     | pairs are sorted in every substep / new pairs are solved last |
/// | least_turn        | 1e-3  | rest speeds                  | curves cost energy / jitter in a heap counts as rolling |
/// | most_impacts      | 64    | impacts of a ball a substep  | jams cost more / fast balls freeze early |
/// | most_pushes       | 8     | pushes by kinematic bodies   | jams rattle longer / freeze early |
/// | most_holds        | 8     | rounds of holding back       | slower / balls between two hands keep their speed |
/// | most_stored       | 0.005 | of the balls' energy         | squashed columns throw up loads / deep heaps stay deep |
/// | most_owed         | 0.001 | of the balls' energy         | as above / heaps at rest are moved back in each substep |
/// | rounding          | 1e-14 | share of the speeds          | slow contacts are lost / rounding counts as contact |
// clang-format on
namespace carom::contact_tolerance {

/// A pair that approaches slower than this many times the speed that gravity gives in a substep
/// does not bounce.
inline constexpr double rest_speed_factor = 1.5;
/// A pair is a constraint only while it moves less than this share of a radius in a substep.
inline constexpr double most_travel = 0.25;

/// A tick has more substeps than asked for, up to `most_substeps`, while g h^2 is more than this
/// share of the smallest radius.
inline constexpr double most_fall = 0.25;
inline constexpr int most_substeps = 64;

/// Constraints are springs of this many cycles a substep. A pile of 2,000 without friction comes to
/// rest at 0.22 (speeds of 1e-12), and at 0.25 never (0.01).
inline constexpr double stiffness = 0.22;
/// Damping ratio of these springs.
inline constexpr double damping = 10.0;
/// The speed that closes an overlap of x grows by the factor 1 + stiffening x / radius, with the
/// smaller radius: loads sink in less, and lightly loaded pairs stay soft.
inline constexpr double stiffening = 5.0;
/// Bound of that growth, without which piles throw up what lands hard on them.
inline constexpr double most_stiffening = 0.5;

/// Relaxing takes back this share more of a speed (successive over-relaxation), up to this share of
/// the rest speed, where the pair already pressed in the last substep.
inline constexpr double over_relaxation = 0.6;

/// Two balls whose masses are this many times apart have a high mass ratio: all constraints below
/// them are solved `loaded_iterations` times. With one iteration 400 on balls of mass 1 rocks for
/// ever; with two it rests after a minute, with four after some seconds.
inline constexpr double high_mass_ratio = 4.0;
inline constexpr int loaded_iterations = 4;

/// From this share of the speed that gravity gives in a substep on, an impulse presses a ball, and
/// the ball leaves its parabola. With less than a half, an upward impulse would move the ball down.
/// Below that, only where g h^2 is more than `far_fall` of its radius: balls that roll down steep
/// curves are pressed as little.
inline constexpr double full_press = 0.5;
inline constexpr double far_fall = 0.01;

/// An impulse that lets the upper body leave the lower one at this many rest speeds has stopped an
/// impact. It is no load to warm start from, and the excess is taken back.
inline constexpr double most_excess = 4.0;
/// A ball with this many pressing contacts is enclosed: it has no room to bounce.
inline constexpr int enclosed_contacts = 3;

/// Two bodies stop where they overlap by this share of the smaller radius, however hard they are
/// pressed: their minimum separation.
inline constexpr double overlap_limit = 0.5;
/// A pair that overlaps by this many times the limit has started so: its balls are embedded.
/// Pressed pairs stop at the limit, but for the distance of a parabola from its chord, along which
/// impacts are searched: g h^2 / 8, which is at most `most_fall` / 8 / `overlap_limit` = 0.0625 of
/// the limit.
inline constexpr double embedded = 1.1;
/// A constraint that does not bounce is left to the next substep while it overlaps by less than
/// this share of the limit.
inline constexpr double soft_overlap = 0.2;
/// In a strict tick, and without gravity, pairs overlap by no more than this share of the smaller
/// radius, unless they did before; just below the 0.02 that hands may cause (tick/hands.cpp).
inline constexpr double strict_overlap = 0.018;
/// In each substep, a pair may use up this share of the overlap that remains until that bound.
/// Without it, every slow approach would be an impact, and jams would reach `most_impacts`.
inline constexpr double strict_share = 0.5;
/// A kinematic body goes no further into a ball than this share of the ball's radius.
inline constexpr double kinematic_overlap = 0.1;
/// A constraint that overlaps by more than this share of the smallest radius makes the solver look
/// for impacts of all pairs, not only of the fast ones. It opens even if constraints owe too much.
inline constexpr double deep_overlap = 0.25;
/// A gap, as a share of the smallest radius, that pressed pairs may close for others in a substep.
inline constexpr double closing_margin = 0.02;

/// In the middle of a tick, pairs that balls form with new reference positions stay out of order
/// where that many times as few balls have new ones as there are.
inline constexpr int few_leaving = 32;
/// A ball meets the next piece of a curve at its time of impact from this many rest speeds on.
inline constexpr double least_turn = 1e-3;
/// A ball freezes after this many impacts in a substep.
inline constexpr int most_impacts = 64;
/// A ball stops after kinematic bodies have pushed it this often in a substep.
inline constexpr int most_pushes = 8;
/// Rounds in which kinematic bodies give way to what they press against each other.
inline constexpr int most_holds = 8;
/// Constraints store at most this share of the energy of all balls: of what they take, they give
/// back no more.
inline constexpr double most_stored = 0.005;
/// Constraints may give this share of the energy of all balls before they have taken it.
inline constexpr double most_owed = 0.001;
/// An approach slower than this share of the speeds of both bodies is rounding.
inline constexpr double rounding = 1e-14;

}  // namespace carom::contact_tolerance
