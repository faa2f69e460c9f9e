#pragma once

/// Versions of what a computed game depends on. Recordings name them.
namespace carom {

/// The version of the physics: raised when the same level, seed, solver and commands give other
/// bits than before. A level that says `physics N` loads under every version from N on.
inline constexpr int physics_version = 1;

}  // namespace carom
