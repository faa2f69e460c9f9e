#pragma once

#include "level/ir/arguments.h"
#include "level/ir/emit.h"
#include "level/language/statement.h"

/// Helpers of the statements that make pinball devices (pinball.cpp, pinball_zones.cpp,
/// pinball_holders.cpp).
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

/// The radius of the zone of a device: r=, or a default.
double zone_radius(const Arguments& arguments, Context& context);

/// The device with its place.
DeviceIr device_at(Vec2 at, const Device& device, int binding, const Arguments& arguments,
                   const Frame& frame);

/// Makes a device for each at=: a round zone that detects balls on its layer.
void build_zones(Device device, const Arguments& arguments, const Frame& frame, Context& context);

/// The row of a statement that makes a device for each at=.
Statement placed_device(std::string_view name, std::string_view usage, StatementAction action,
                        const std::vector<KeyRule>& other_keys,
                        std::vector<std::string_view> flags = {});

/// The value of a key that is up, down, left or right, as a unit vector. None: reported.
std::optional<Vec2> read_direction(const Arguments& arguments, std::string_view key,
                                   Context& context);

}  // namespace carom
