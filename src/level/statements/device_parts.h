#pragma once

#include "level/ir/arguments.h"
#include "level/ir/emit.h"

/// Helpers of the statements that make pinball devices (pinball.cpp, pinball_zones.cpp).
namespace carom {

bool has_units(const Context& context);

/// The default size of a device: `metres` in a level with units, else `natural`.
double default_size(double metres, double natural, const Context& context);

/// The default material of a device. In a level without units it does not soften, since no speed
/// scale is known.
Material default_material(Material material, const Context& context);

/// An index into LevelIr::edge_bindings for the statement's device. `material`: absent for a device
/// that is only a zone, which has no material.
int bind_device(const Arguments& arguments, const std::optional<Material>& material,
                Context& context);

Origin origin_of(const Arguments& arguments, const Frame& frame);

/// Adds the device to the intermediate representation; returns its index there.
int add_device(DeviceIr device, Context& context);

/// Adds the device and the capsule that is its shape. An end of the capsule near another edge is
/// intended, so it is not reported as a gap.
void emit_device_capsule(const Capsule& shape, Side side, DeviceIr device, const Span& at,
                         const Frame& frame, Context& context);

/// Adds the device and the zone that is its shape, in the frame's coordinates.
void emit_device_zone(const Capsule& shape, Zone::Effect effect, DeviceIr device, const Span& at,
                      const Frame& frame, Context& context);

/// The value of a key that is up, down, left or right, as a unit vector. None: reported.
std::optional<Vec2> read_direction(const Arguments& arguments, std::string_view key,
                                   Context& context);

}  // namespace carom
