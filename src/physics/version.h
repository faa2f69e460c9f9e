#pragma once

/// Versions of what a computed game depends on. Recordings name them.
namespace carom {

/// The version of the physics: raised when the same level, seed, solver and commands give other
/// bits than before. A level that says `physics N` loads under every version from N on.
///
/// 2: `event` misses no impact of oversized balls that cross a torus several times within a search;
/// a hand that moves an edge of a cluster and lets go of it ends the hybrid step.
/// 3:
/// - `event`: a ball whose spin has been braked keeps its supports. A contact of a jam that does
///   not approach never pulls. Balls that start inside an edge or a ball meet it where they touch
///   again, balls that fly together under drag meet however slowly, and position correction pushes
///   no ball into a third one. A ball leaves a held ball as under the other solvers.
/// - Hybrid steps: the contacts of this step, not of the one before, decide which balls stay in the
///   cluster; so do balls that `contact` has left overlapping.
/// - Kinematic edges: a turning one meets in time a ball whose centre is further away than the edge
///   is long. Driven ones keep their speed at every impact under `contact`, and at the end of a
///   tick under `event`. `swept` and `contact` meet edges that are dragged without turning in
///   closed form, and fast balls no longer pass through kinematic ones.
/// - Flippers recoil from their stop, are held there with less force, and stall when they jam.
/// - Hands yield (tick/hands.h).
/// - Arcs and fillets have smooth joints, along which balls roll on without a loss (laws/curve.h).
/// - `swept` and `event` limit the work of a tick by one budget (tick/work_budget.h), and `swept`
///   no longer takes the velocity of a ball that meets too much in an elastic scene.
/// - `contact`: constraints give back no more energy than they took (contact/energy.h), and what a
///   fast ball hits does not leave its skin. Without gravity, impacts without a bounce are not
///   left to constraints that nobody makes. Balls in one place separate in all directions,
///   and stay out of impacts until they have.
/// - The levels of pool say `use modulus`, by which contacts last under `event`. The end of the
///   shot clock is a command.
/// - `event`: pressed balls that an edge bars from separating do so along the edge
///   (event/impact/position_correction.h).
/// - `event`: a ball that gravity presses on a driven edge leaves it so that it rises by at least
///   5e-4 of its radius (driven_lift_height, laws/bounce.h).
/// - `event`: balls that are lifted apart pay for it with what the impact took from them, and with
///   their speed.
/// - `contact`: a small impulse no longer moves a ball off its parabola by g h^2 / 2, small balls
///   get more substeps, and under drag impacts are on the chord. Balls that start inside others are
///   hit by those that do not. Walls hold such balls, though another edge is one-way.
/// - `event`: what sinks in deeper than position correction opens goes to `contact`. Time stands
///   still for balls that are too fast for the rounding of time.
/// - The spin of a ball that cannot move (held, frozen, at rest in an impact) drives nothing.
/// 4:
/// - Seesaws: a stop ends the search of `event`. Under `contact` one that bounces may meet both
///   stops in a substep, and one that a ball presses on a stop stays there. Under `swept` no ball
///   rests on a fast one. Under `event` a hand that presses a ball on one yields.
/// - `contact`: a heap that owes energy is moved back, together with slow balls that have followed
///   it. So are balls that have pressed at any time in the substep.
/// - `event`: balls come to rest in every scene that loses energy, whether by restitution, slip,
///   drag or a stop speed.
/// - `contact`: an edge that is about to hit a ball is not held back, so it hits at its full speed.
/// - Pinball: the ball saver and timers stand while the only ball waits at the plunger.
/// 5:
/// - Contacts that last: the fastest of an impact sets the steps, not the first, and one that would
///   press by less than rounding takes no time.
/// - `event`: a ball that gets out of a body that it started in does not enter it again unseen.
/// - `swept`: a ball with the same index as the edge that it meets is charged for its work, too.
/// - `swept`: a ball that rises with the ball below it loses the kinetic energy that the height
///   costs.
/// 6:
/// - `event`: what the stop speed or the speed limit changes goes on counting its collisions, and
///   slow pairs meet once they have sunk in, whatever accelerates them. Position correction pushes
///   no ball into an edge, however far from the origin.
/// - `contact`: only balls that might leave their skins get new reference positions, so constraints
///   are solved in another order. Impacts are searched where something has moved a ball off its
///   free flight.
/// 7:
/// - `swept`: a ball that rests weighs on a ball that lifts it, and pays for its height where a hit
///   lifts it off its supports.
inline constexpr int physics_version = 7;

}  // namespace carom
