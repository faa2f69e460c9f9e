#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/double_double.h"
#include "physics/tick/work_budget.h"

/// The thresholds of the method `event`, in one table: what each one decides, its unit, how it
/// relates to the others, and what breaks when it is ten times as large or as small.
///
/// Four families, of which the heights stand in increasing order:
///
///   rounding   approach_rounding, residual_rounding, pressed_rounding, *_rounding: how much of a
///              computed quantity is rounding. They scale with the precision of the number type,
///              but for `pressed_rounding`, which guards against errors of positions.
///   heights    unpressed_rest_height < rest_height < cloth_rest_height < moving_rest_height: a
///              rebound that rises less than this share of the smaller radius is none. All of the
///              energy that the solver removes by choice is removed below these heights, in wedges
///              (`wedge_rest_heights`), by the collapse guard, or when a kinematic body squeezes a
///              ball.
///   counts     of collisions: when the collapse guard acts.
///   costs      limits of work. But for the few that say so, they never change what is found, only
///              when it is found.
///
/// `contact_slop` < rest_height: two bodies that count as touching must be nearer than the lowest
/// hop that is still a bounce.
///
/// Thresholds with a single use stand beside it: those of the pivoting of simultaneous impacts
/// (laws/simultaneous_impact.cpp: 240 contacts, 400 relaxations, 1e-11 and 1e-12), of searches
/// (geometry/conservative_advancement.h: 65,536 iterations, the factor 64 of a sharper bound), of
/// rebuilding (world_begin.cpp: every 64 ticks, n/8 + 1 balls) and of the hybrid step
/// (hybrid_step.h: substeps, attempts; hybrid_cluster.h: `most_overlap`, hands).
namespace carom {

// --- Contact --------------------------------------------------------------------------------

/// Bodies touch within this share of the smaller radius. x10: a hop as high as `rest_height` is
/// lost in a contact; /10: rounding at coordinates of 1e5 radii separates resting bodies.
inline constexpr double contact_slop = 1e-10;

/// Rounding of a gap that is measured anew, in roundings of one evaluation (`rounding_at`).
/// x10: distant coordinates make touching bodies of near ones; /10: contacts at an instant are
/// missed, and simultaneous impacts come one by one.
inline constexpr double gap_roundings = 16.0;

/// Where contacts last (Model::modulus), a ball further away than this share of the smaller radius
/// takes no part in an impact, although its gap may close in time. Cells must show it
/// (ball_cells.cpp). x10: cells of ten balls; /10: fast breaks pass through a loose rack ball by
/// ball.
inline constexpr double most_lasting_gap = 0.2;

// --- Heights of a rebound, as shares of the smaller radius ------------------------------------

/// Balls on cloth that touch and that nothing presses together: approaches below the speed of a
/// fall through this height, with the whole relative acceleration, are no impacts.
/// x10: slow rolls stop short of what they touch; /10: impacts of rounding's making.
inline constexpr double unpressed_rest_height = 1e-11;

/// A ball that gravity presses on an edge or on a resting ball comes to rest on it once its rebound
/// would rise less. x10: a bouncing ball rests earlier, from ten times the height; /10: the
/// rebound drowns in the rounding of positions and rest comes at a wrong instant.
inline constexpr double rest_height = 1e-9;

/// Two balls, one of which cloth drives towards the other: lower rebounds lose no energy, so that
/// it pushes the other in finitely many impacts. x10: pushed balls rattle higher; /10: more impacts
/// for the same push.
inline constexpr double cloth_rest_height = 1e-7;

/// Two moving balls that gravity presses together: lower rebounds lose no energy, and the pair may
/// sink in by this much before it meets again. Inelastic collapse stays finite by it. x10: heaps
/// overlap more; /10: more impacts until a heap settles.
inline constexpr double moving_rest_height = 1e-5;

/// The kinetic energy up to which a ball comes to rest: in rest heights if it leans on a barrier,
/// in rest heights over the squared sine of the angle between the normals if two supports hold it.
/// So the flatter a wedge, the sooner a ball stops in it. x10: balls stop in wedges early; /10: a
/// ball in a wedge bounces between its sides forever.
inline constexpr double wedge_rest_heights = 8.0;

// --- Rounding of speeds ---------------------------------------------------------------------

/// Approaches below this share of the speeds are rounding, and no impacts. x10: grazing impacts
/// are missed; /10: an impact that has been resolved is found again, and time stands still.
template <typename Real>
inline constexpr double approach_rounding = 1024.0 * precision<Real>;

/// What an impact may leave of an approach, as a share of the speeds. It must be well below
/// `approach_rounding`, or the solver finds its own remainder.
template <typename Real>
inline constexpr double residual_rounding = 0.125 * approach_rounding<Real>;

/// The rounding of an approach where bodies are pressed together, as a share of the speed that
/// gravity gives in a fall through a radius. It covers errors of the position, hence the same for
/// every number type. Its square over two, a height of 3.2e-19 radii, is far below `rest_height`.
inline constexpr double pressed_rounding = 8e-10;

/// The approach that an impact may leave, as a share of `pressed_rounding`.
inline constexpr double pressed_residual = 0.125;

/// Slower approaches do not count, length/s: shares of them would be subnormal numbers.
inline constexpr double least_approach = 1e-280;

/// The part of gravity, or of a velocity, along a direction below which it is rounding: a share of
/// the whole. x10: shallow slopes of 1e-12 rad hold a ball; /10: level floors let it slide.
template <typename Real>
inline constexpr double component_rounding = 256.0 * precision<Real>;

/// Slip that is left at the end of a slip, as a share of the speeds, and what gravity and friction
/// add to it, as a share of acceleration times time. x10: rolling begins early; /10: a rolling ball
/// slips again.
template <typename Real>
inline constexpr double slip_rounding = 1e6 * precision<Real>;
template <typename Real>
inline constexpr double slip_time_rounding = 64.0 * precision<Real>;

/// Two supports hold nothing between them if the sine of the angle between their normals is below
/// this.
inline constexpr double parallel_supports = 1e-9;

/// An acceleration presses a ball on a barrier, or rolls it off a wedge, if its component that way
/// is at least this share of it.
inline constexpr double pressing_share = 1e-9;

// --- The inelastic-collapse guard and dense clusters ------------------------------------------

/// Above this count of collisions, in a row without moving (no gravity) or in quick succession
/// (gravity), two such balls meet without restitution, without gravity also such a ball and an
/// edge; kinematic bodies in contact with such a ball stop; a jammed ball is frozen. Equals
/// `dense_collisions` by choice: nothing relies on it.
/// x10: a collapse takes more impacts to end; /10: long cradles may lose energy.
inline constexpr std::uint32_t most_recent_collisions = 64;

/// Above this count of collisions in quick succession, a slow ball is frozen for a while. x10:
/// heaps take longer to freeze; /10: balls that merely rattle are frozen. It exceeds
/// `dense_collisions`, so that `contact` takes a heap first.
inline constexpr std::uint32_t most_collisions_before_freezing = 256;

/// The count of collisions with which a frozen ball continues: high, so that it is soon frozen
/// again.
inline constexpr std::uint32_t collisions_after_freezing = most_collisions_before_freezing / 4 * 3;

/// Above this count in quick succession, the last with a ball, a ball is in a dense cluster, which
/// `contact` takes over at the end of the tick (README.md, hybrid stepping). x10: heaps cost more
/// before `contact` takes them; /10: a lively bounce is taken for a heap.
inline constexpr std::uint32_t dense_collisions = 64;

/// "Quick succession": within this share of the time of a fall through the radius. x10: bouncing
/// balls count as a heap; /10: slow heaps are never noticed.
inline constexpr double quick_succession = 1.0 / 64.0;

/// How long a ball stays frozen: a share of the time of a fall through its radius.
inline constexpr double frozen_share = 0.25;

/// Position correction separates balls that overlap by more than this many rest heights
/// (`moving_rest_height`, on cloth `cloth_rest_height`), by at most `most_correction` of the radius
/// at once. A larger share could carry a ball past a thin edge.
inline constexpr double overlap_heights = 0.5;
inline constexpr double overlap_heights_on_cloth = 2.0;
inline constexpr double most_correction = 0.5;

/// Two balls that meet overlapping by more than this share of the smaller radius, after more than
/// `sunk_collisions` in quick succession, are in a dense cluster: position correction cannot open
/// them, as where walls and third balls bar them. x10: overlaps that `carom run --check` does not
/// allow; /10: `contact` takes balls that events could part.
inline constexpr double most_sunk = 5e-4;
inline constexpr std::uint32_t sunk_collisions = dense_collisions / 4;

/// Position correction takes at most this share of the kinetic energy of an impact's bodies at
/// once, to pay for lifting them. x10: they stop within heaps, and meet at once again, without end;
/// /10: deep overlaps open later.
inline constexpr double most_paid = 0.03;

/// Position correction pushes a ball no deeper into a third one, in the smaller radius. x10: balls
/// that start inside one another, or that a hand squeezes, are pushed into their neighbours; /10:
/// balls in the middle of a heap are no longer separated.
inline constexpr double most_correction_into_ball = 1e-4;

// --- Costs: limits of work ----------------------------------------------------------------------

/// The work of a tick (tick/work_budget.h), in events for each ball; an event takes about 1 us.
/// `iterations_per_unit` iterations of a search count as one event. Changes the result.
inline constexpr WorkBudget::Allowance event_budget{.per_ball = 1'000};
inline constexpr std::uint64_t iterations_per_unit = 32;
/// An iteration about a ball that turns, or that drag slows, takes as long as so many others.
inline constexpr std::uint64_t turning_iteration = 10;
inline constexpr std::uint64_t drag_iteration = 5;

/// How far a ball may go in the rounding of time, as a share of its radius: that is how wrong the
/// place of an impact gets. Time stands still for faster balls (engine.cpp). x10: they overlap as
/// `carom run --check` does not allow; /10: fast balls stand still, which would be right enough.
inline constexpr double most_untimed_travel = 1e-4;

/// The number of events between two polls of the cancellation token; for this count,
/// `iterations_per_event` iterations of a search are an event.
inline constexpr std::uint64_t events_between_polls = 4096;
inline constexpr std::uint64_t iterations_per_event = 8;

/// The most rounds of a simultaneous impact: `most_impact_rounds`, plus `impact_rounds_per_contact`
/// for each contact point. After half of them restitution is dropped. Changes the result of impacts
/// that take as many.
inline constexpr std::size_t most_impact_rounds = 200;
inline constexpr std::size_t impact_rounds_per_contact = 8;

/// Rounds of impact friction where several contacts share a body: changes the result of impacts
/// that take so many.
inline constexpr int most_friction_rounds = 64;

/// The reach of edges into cells, in largest radii, and how late a curved trajectory may leave a
/// cell, in cell widths: the second must stay within what the first gives, or an edge is missed.
inline constexpr double edge_reach = 1.01;
inline constexpr double most_transfer_delay = 1e-3;

/// How far ahead searches look whose cost grows with their horizon, in ticks.
inline constexpr double search_horizon_ticks = 16.0;

/// A trajectory on a torus starts again inside of the frame after so many periods: image indices
/// have 8 bits. A kept trajectory is not checked against edges over more than a few.
inline constexpr double most_periods = 50.0;
inline constexpr double most_checked_periods = 4.0;

/// On a torus, oversized balls are in no cell, so searches test their periodic images by number:
/// so many to each side of the nearest. An oversized ball predicts again before it has gone this
/// share of a period, and every other ball at the border of its cell: between two predictions, no
/// image further away can come into reach. x10 of the share: impacts are missed; /10: more events.
inline constexpr double oversized_periods = 0.25;
inline constexpr int oversized_images = 2;

/// The angle, rad, through which one piece of a pendulum's series may lead: the series is exact to
/// rounding up to here. x10: it is not; /10: more events of a ball on a round end.
inline constexpr double most_piece_angle = 0.05;

/// The longest such piece under drag, in its time constants, for the same reason. x10: a ball that
/// turns under strong drag is thrown out of the scene; /10: more events of it.
inline constexpr double most_piece_decay = 0.5;

/// Under drag, rolling friction is constant for this share of drag's time constant: changes the
/// result slightly. x10: a rolling ball slips more between two pieces; /10: more events.
inline constexpr double rolling_piece = 1.0 / 1024.0;

/// The number of balls from which on memory is prefetched.
inline constexpr std::size_t balls_worth_prefetching = 4096;

/// The most balls that may be oversized (much larger than the rest, and in no cell).
inline constexpr std::size_t most_oversized = 8;

}  // namespace carom
