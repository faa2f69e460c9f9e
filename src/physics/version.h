#pragma once

/// Versions of what a computed game depends on. Recordings name them.
namespace carom {

/// The version of the physics: raised when the same level, seed, solver and commands give other
/// bits than before. A level that says `physics N` loads under every version from N on.
///
/// 2: `event` misses no impact of oversized balls that cross a torus several times within a search;
/// a hand that moves an edge of a cluster and lets go of it ends the hybrid step.
/// 3: under `event` a ball whose spin has been braked keeps its supports, and the contacts of a
/// hybrid step, not those of the one before, decide which balls stay in the cluster; a contact of a
/// jam that does not approach never pulls; a turning kinematic edge meets in time a ball whose
/// centre is further away than the edge is long; a flipper recoils from its stop, and is held
/// there with less force; hands yield (tick/hands.h); driven edges keep their speed at every impact
/// under `contact`, and at the end of a tick under `event`; arcs and fillets have smooth joints,
/// along which balls roll on without a loss under `event`, `swept` and `contact` (laws/curve.h);
/// `swept` and `event` limit the work of a tick by one budget (tick/work_budget.h), and `swept` no
/// longer takes the velocity of a ball that meets too much in an elastic scene; the shot clock of
/// pool is no part of the game: its end is a command;
/// under `event`, balls that start inside an edge or a ball and get out meet it where they touch
/// again, balls that fly together under drag meet however slowly, position correction pushes no
/// ball into a third one, balls that `contact` has left overlapping stay in the cluster, and a ball
/// leaves a held ball as under the other solvers;
/// the levels of pool say `use modulus`, by which contacts last under `event`;
/// under `contact` constraints give back no more energy than they took (contact/energy.h), and
/// what a fast ball hits no longer leaves its skin; under `swept` and `contact` balls meet edges
/// that are dragged without turning in closed form, and fast balls no longer pass through kinematic
/// ones.
inline constexpr int physics_version = 3;

}  // namespace carom
