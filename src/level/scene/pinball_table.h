#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec2.h"
#include "physics/world/ids.h"

/// The devices of a pinball table and the rules that its author has written. They are data; the
/// game runs them (game/pinball/pinball.h).
namespace carom {

enum class DeviceKind : std::uint8_t {
    edge,        ///< an edge, arc, peg or box that rules speak of
    flipper,     ///< World::flippers moves it
    bumper,      ///< kicks: Material::kick
    slingshot,   ///< kicks
    plunger,     ///< sends balls that lie on it
    gate,        ///< a one-way edge
    droptarget,  ///< an edge that steps aside when it is hit
    target,      ///< an edge that stays
    rollover,    ///< a zone
    spinner,     ///< a zone whose vane a ball sets turning
    kickback,    ///< a zone that, while lit, sends balls back
    drain,       ///< a zone that swallows balls
    lamp,        ///< a light, and nothing else
    hole,        ///< a zone that keeps a ball for a while, and then sends it on
    ramp         ///< a zone that takes balls which pass it to another layer
};

/// What a kind of device can do, for the statements and the rules of a level.
struct DeviceTraits {
    DeviceKind kind;
    std::string_view name;         ///< the keyword of its statement
    bool is_zone = false;          ///< balls enter it, and do not bounce off it
    bool has_light = false;        ///< rules may light it: `light NAME`
    bool completes_group = false;  ///< it takes part in `on NAME all`
};

/// Each kind of device, in the order of DeviceKind.
inline constexpr std::array device_traits{
    DeviceTraits{DeviceKind::edge, "edge"},
    DeviceTraits{DeviceKind::flipper, "flipper"},
    DeviceTraits{DeviceKind::bumper, "bumper"},
    DeviceTraits{DeviceKind::slingshot, "slingshot"},
    DeviceTraits{DeviceKind::plunger, "plunger"},
    DeviceTraits{DeviceKind::gate, "gate"},
    DeviceTraits{DeviceKind::droptarget, "droptarget", false, true, true},
    DeviceTraits{DeviceKind::target, "target", false, true, true},
    DeviceTraits{DeviceKind::rollover, "rollover", true, true, true},
    DeviceTraits{DeviceKind::spinner, "spinner", true},
    DeviceTraits{DeviceKind::kickback, "kickback", true, true},
    DeviceTraits{DeviceKind::drain, "drain", true},
    DeviceTraits{DeviceKind::lamp, "lamp", false, true, true},
    DeviceTraits{DeviceKind::hole, "hole", true},
    DeviceTraits{DeviceKind::ramp, "ramp", true}};

constexpr const DeviceTraits& traits(DeviceKind kind) {
    return device_traits[static_cast<std::size_t>(kind)];
}

/// One device. A statement that draws several makes several.
struct Device {
    DeviceKind kind = DeviceKind::edge;
    std::uint32_t group = 0;            ///< index into PinballTable::groups
    std::vector<CapsuleId> capsules;    ///< what is hit, if anything
    std::optional<std::uint32_t> zone;  ///< index into World::zones, if it has one
    Vec2 place;                         ///< its middle
    Vec2 direction;            ///< plunger, kickback, hole: unit, where balls are sent; ramp:
                               ///< where they pass
    double least_speed = 0.0;  ///< plunger: hardly pulled, length/s
    double most_speed = 0.0;   ///< plunger: pulled all the way; kickback, hole: always
    double hold = 0.0;         ///< hole: s
    std::uint8_t from = 0;     ///< ramp: the layer before it
    std::uint8_t to = 0;       ///< and behind it
};

/// Devices that share a name, in the order in which they are drawn.
struct DeviceGroup {
    std::string name;
    DeviceKind kind = DeviceKind::edge;
    std::vector<std::uint32_t> devices;
};

/// What a player can press. A nudge sends the balls on the table that way.
enum class Button : std::uint8_t {
    left_flipper,
    right_flipper,
    plunger,
    nudge_left,
    nudge_right,
    nudge_up
};
inline constexpr int button_count = 6;

struct RuleAction {
    enum class What : std::uint8_t {
        score,       ///< adds `amount`
        bonus,       ///< adds it, or sets to it
        multiplier,  ///< of the bonus: the same
        multiball,   ///< so many balls in play
        save,        ///< a drained ball comes back, for `seconds`
        extraball,   ///< the same player plays once more
        reset,       ///< lights of `group` off, its targets up
        light,       ///< lights of `group` on
        unlight,     ///< and off
        advance,     ///< the next light of `group` on
        message      ///< `text` is shown
    };
    What what = What::score;
    std::int64_t amount = 0;
    bool adds = false;     ///< bonus, multiplier
    double seconds = 0.0;  ///< save; light: 0 is for good
    std::uint32_t group = 0;
    std::string text;
};

/// `on NAME hit|all|enter [while|unless NAME|multiball ...] action, action ...`
struct Rule {
    enum class When : std::uint8_t {
        hit,    ///< a ball hits one of the group
        all,    ///< all of the group are lit, for the first time since they were reset
        enter,  ///< a ball comes into one of the group's zones
    };
    std::uint32_t group = 0;
    When when = When::hit;
    struct Need {
        std::optional<std::uint32_t> group;  ///< all of it are lit; none: there is multiball
        bool is_not = false;                 ///< the rule holds unless it is so
    };
    std::vector<Need> needs;
    std::vector<RuleAction> actions;
};

struct PinballTable {
    std::vector<Device> devices;
    std::vector<DeviceGroup> groups;
    std::vector<std::int32_t>
        device_of_capsule;                ///< by number of the capsule at the start; -1: none
    std::vector<Button> flipper_buttons;  ///< by World::flippers
    std::vector<Rule> rules;

    bool is_game = false;          ///< `game pinball`: balls are counted, and rules hold
    std::uint32_t balls = 3;       ///< a game's
    double save = 10.0;            ///< s after the start in which a drained ball comes back
    std::uint32_t warnings = 3;    ///< before the tilt
    std::int64_t bonus = 1000;     ///< what one of the bonus is worth
    std::uint32_t highscores = 5;  ///< lines of the table of honour

    bool is_empty() const { return devices.empty() && !is_game; }
};

}  // namespace carom
