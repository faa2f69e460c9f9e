#pragma once

#include "level/language/statement.h"

/// Keys that several families of statements share.
namespace carom::keys {

inline constexpr KeyRule at{"at", KeyShape::pair, Measure::length, Bound::any, true};
/// at=X,Y any number of times, one position each.
inline constexpr KeyRule places{"at", KeyShape::pair, Measure::length, Bound::any, true, true};
inline constexpr KeyRule kind{"kind", KeyShape::word};
inline constexpr KeyRule material{"material", KeyShape::word};
/// Of edges, whose first plain word may be a material.
inline constexpr KeyRule name{"name", KeyShape::word};
inline constexpr KeyRule ball_radius{"r", KeyShape::scalar, Measure::length, Bound::positive};
inline constexpr KeyRule edge_radius{"r", KeyShape::scalar, Measure::length, Bound::not_negative};
inline constexpr KeyRule required_edge_radius{"r", KeyShape::scalar, Measure::length,
                                              Bound::not_negative, true};
inline constexpr KeyRule restitution{"e", KeyShape::scalar, Measure::number, Bound::unit_interval};
inline constexpr KeyRule friction{.name = "mu",
                                  .shape = KeyShape::scalar,
                                  .measure = Measure::number,
                                  .bound = Bound::not_negative,
                                  .needs_spin = true};
inline constexpr KeyRule ball_mass{"m", KeyShape::scalar, Measure::mass, Bound::positive};

/// Of a pinball device that detects balls around its place.
inline constexpr KeyRule zone_radius{"r", KeyShape::scalar, Measure::length, Bound::positive};

/// Of such a device: the layer on which it detects balls.
inline constexpr KeyRule zone_layer{"layer", KeyShape::scalar, Measure::whole, Bound::layer};

/// The looks of what a statement makes; no part of the physics.
inline constexpr KeyRule color{"color", KeyShape::color};

}  // namespace carom::keys
