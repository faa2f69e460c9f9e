#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec2.h"
#include "physics/world/bodies.h"
#include "physics/world/ids.h"

/// The devices of a pinball table, as plain data; the game moves them (game/pinball/pinball.h). Its
/// rules are in scene/rules.h.
namespace carom {

enum class DeviceKind : std::uint8_t {
    edge,        ///< an edge, arc, peg or box that a rule names
    flipper,     ///< moved through World::flippers
    bumper,      ///< kicks: Material::kick
    slingshot,   ///< kicks
    plunger,     ///< launches balls that rest on it
    gate,        ///< a one-way edge
    droptarget,  ///< an edge that drops when a ball hits it
    target,      ///< a standing target: an edge that stays up
    rollover,    ///< a zone
    spinner,     ///< a zone with a vane that a passing ball spins
    kickback,    ///< a zone that sends balls back while it is lit
    drain,       ///< a zone that removes balls from play
    lamp,        ///< a light only
    hole,        ///< a saucer: a zone that holds a ball for a time, then ejects it
    ramp,        ///< a zone that moves passing balls to another layer
    post,        ///< an edge that stands up until a rule opens it
    lock,        ///< a zone: a ball that comes to lie in it is out of play until it leaves
    magnet,      ///< a zone that catches a ball while it is lit, and lets it go
    captive      ///< a ball that stays where it is shut in, and that other balls hit
};

/// What lights a device.
enum class DeviceLight : std::uint8_t {
    none,
    rules,   ///< `light NAME`, and of some kinds a ball
    ball,    ///< it is lit while it holds a ball
    opening  ///< rules `open` and `shut` it, and it is lit while it is open
};

/// What a kind of device can do, for the statements and the rules of a level.
struct DeviceTraits {
    DeviceKind kind;
    std::string_view name;  ///< the keyword of its statement
    bool is_zone = false;   ///< balls enter it instead of bouncing off
    DeviceLight light = DeviceLight::none;
    bool completes_group = false;  ///< it takes part in `on NAME all`
};

/// Each kind of device, in the order of DeviceKind.
inline constexpr std::array device_traits{
    DeviceTraits{DeviceKind::edge, "edge"},
    DeviceTraits{DeviceKind::flipper, "flipper"},
    DeviceTraits{DeviceKind::bumper, "bumper"},
    DeviceTraits{DeviceKind::slingshot, "slingshot"},
    DeviceTraits{DeviceKind::plunger, "plunger"},
    DeviceTraits{DeviceKind::gate, "gate", false, DeviceLight::opening},
    DeviceTraits{DeviceKind::droptarget, "droptarget", false, DeviceLight::rules, true},
    DeviceTraits{DeviceKind::target, "target", false, DeviceLight::rules, true},
    DeviceTraits{DeviceKind::rollover, "rollover", true, DeviceLight::rules, true},
    DeviceTraits{DeviceKind::spinner, "spinner", true},
    DeviceTraits{DeviceKind::kickback, "kickback", true, DeviceLight::rules},
    DeviceTraits{DeviceKind::drain, "drain", true},
    DeviceTraits{DeviceKind::lamp, "lamp", false, DeviceLight::rules, true},
    DeviceTraits{DeviceKind::hole, "hole", true, DeviceLight::ball, true},
    DeviceTraits{DeviceKind::ramp, "ramp", true},
    DeviceTraits{DeviceKind::post, "post", false, DeviceLight::opening},
    DeviceTraits{DeviceKind::lock, "lock", true, DeviceLight::ball, true},
    DeviceTraits{DeviceKind::magnet, "magnet", true, DeviceLight::rules},
    DeviceTraits{DeviceKind::captive, "captive"}};

static_assert([] {
    for (std::size_t i = 0; i < device_traits.size(); ++i)
        if (device_traits[i].kind != static_cast<DeviceKind>(i)) return false;
    return true;
}());

constexpr const DeviceTraits& traits(DeviceKind kind) {
    return device_traits[static_cast<std::size_t>(kind)];
}

/// One device. A statement with several positions makes several devices.
struct Device {
    DeviceKind kind = DeviceKind::edge;
    std::uint32_t group = 0;            ///< index into PinballTable::groups
    std::int32_t own_group = -1;        ///< that of this device alone, if a rule names it; -1: none
    std::vector<CapsuleId> capsules;    ///< its solid shapes, which balls hit
    std::optional<std::uint32_t> zone;  ///< index into World::zones, if it has one
    Vec2 place;                         ///< its centre
    Vec2 direction;  ///< unit: the launch of a plunger, kickback or hole; across a ramp
    /// Plunger: launch speed of a light pull. Ramp: that a ball needs to climb it. length/s
    double least_speed = 0.0;
    double most_speed = 0.0;  ///< plunger: of a full pull; kickback, hole: launch speed
    double scatter = 0.0;     ///< plunger: share by which launch speeds vary, to either side
    double hold = 0.0;        ///< hole, magnet: how long it holds a ball, s
    std::uint8_t from = 0;    ///< the layer of a zone; ramp: that which a ball leaves
    std::uint8_t to = 0;      ///< ramp, hole: the layer that it enters
    bool keeps = false;       ///< hole: holds a ball, out of play, until a rule releases it
    Side side = Side::both;   ///< gate, post: on which side it pushes while it is shut
};

/// Devices that share a name, in the order of the file; or one of them, such as lanes.2.
struct DeviceGroup {
    std::string name;
    DeviceKind kind = DeviceKind::edge;
    std::vector<std::uint32_t> devices;
};

/// A ball that stays where it is, and the device that it is.
struct CaptiveBall {
    BallId ball{};
    std::uint32_t device = 0;
};

/// The buttons of a table. A nudge pushes the balls on the table in its direction.
enum class Button : std::uint8_t {
    left_flipper,
    right_flipper,
    plunger,
    nudge_left,
    nudge_right,
    nudge_up,
    add_player  ///< another player joins, during the first ball
};
inline constexpr int button_count = 7;

struct PinballTable {
    std::vector<Device> devices;
    std::vector<DeviceGroup> groups;
    std::vector<std::int32_t>
        device_of_capsule;                ///< by index of the capsule at the start; -1: no device
    std::vector<Button> flipper_buttons;  ///< by World::flippers
    std::vector<CaptiveBall> captives;    ///< ascending by ball
    std::vector<std::uint32_t> openings;  ///< the devices that rules open and shut
    bool has_locks = false;               ///< locks, or holes that keep balls

    bool is_game = false;     ///< the level says `game pinball`: balls are counted and rules apply
    std::uint32_t balls = 3;  ///< of a game
    double save = 10.0;       ///< ball saver at the start of a ball, s
    std::uint32_t warnings = 3;    ///< nudges before the tilt
    std::int64_t replay = 0;       ///< a score that gives an extra ball, once a game; 0: none does
    std::int64_t bonus = 1000;     ///< points for one of the bonus
    std::uint32_t highscores = 5;  ///< rows in the table of high scores

    bool is_empty() const { return devices.empty() && !is_game; }
};

}  // namespace carom
