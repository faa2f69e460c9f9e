#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "level/assemble/rule_assembly.h"
#include "level/text/spelling.h"

// What the names in rules denote: members of RuleAssembly.
namespace carom {

std::optional<std::uint32_t> RuleAssembly::lights_named(const Word& name, Role role) {
    if (!is_pinball()) {
        if (find_balls(name.text))
            return refuse(
                "unknown-variable", name,
                fmt::format("'{}' names balls, which are no condition", name.text),
                fmt::format("to ask whether one is on the table: if count({})>0", name.text));
        if (find_place(name.text))
            return refuse("unknown-variable", name,
                          fmt::format("'{}' names a place, which is no condition", name.text),
                          fmt::format("to ask whether a ball lies in a zone: if count(ball,{})>0",
                                      name.text));
        refuse("unknown-variable", name,
               fmt::format("there is no variable or timer '{}'", name.text),
               fmt::format("add a line above: var {}", name.text));
        return std::nullopt;
    }
    const auto lit = table_.group_named(name, false);
    if (!lit) return std::nullopt;
    const DeviceKind kind = table_.kind_of(*lit);
    const DeviceLight light = traits(kind).light;
    const bool is_empty_hole = kind == DeviceKind::hole && !table_.keeps_balls(*lit);
    if (light == DeviceLight::none || is_empty_hole)
        return refuse("device-without-light", name, fmt::format("'{}' has no lights", name.text),
                      "only rollovers, targets, lamps, kickbacks and magnets are lit");
    if (role == Role::lights || light == DeviceLight::rules) return lit;
    return refuse("device-without-light", name,
                  fmt::format("'{}' is lit while it {}", name.text,
                              light == DeviceLight::ball ? "holds a ball" : "is open"),
                  kind == DeviceKind::lock   ? "rules do not switch it"
                  : kind == DeviceKind::hole ? fmt::format("write: release {}", name.text)
                                             : fmt::format("write: open {}", name.text));
}

std::optional<std::uint32_t> RuleAssembly::opening_named(const Word& name) {
    const auto door = table_.group_named(name, false);
    if (!door || traits(table_.kind_of(*door)).light == DeviceLight::opening) return door;
    return refuse("device-does-not-open", name, fmt::format("'{}' does not open", name.text),
                  "only gates and posts open and shut");
}

std::optional<std::uint32_t> RuleAssembly::holder_named(const Word& name) {
    const auto holder = table_.group_named(name, false);
    if (!holder) return std::nullopt;
    const DeviceKind kind = table_.kind_of(*holder);
    if (kind == DeviceKind::hole || kind == DeviceKind::magnet) return holder;
    return refuse("device-holds-nothing", name, fmt::format("'{}' does not hold balls", name.text),
                  kind == DeviceKind::lock ? "open the post on which its balls lie"
                                           : "only holes and magnets do");
}

std::optional<std::uint32_t> RuleAssembly::shot_named(const Word& name) {
    if (is_pinball()) return table_.group_named(name, true);
    return refuse("event-of-other-game", name, "only at pinball parts of the table can be lit",
                  "say in the text what to aim at");
}

// The balls of a name: any, cue, opponent; a ball or a rack, or one ball of it (rack.3); a kind.
std::optional<std::uint32_t> RuleAssembly::find_balls(std::string_view name) {
    if (const auto found = ball_sets_index_.find(name); found != ball_sets_index_.end())
        return found->second;
    BallsIr set;
    using enum RuleBalls::Who;
    if (name == "ball" || name == "cue" || name == "opponent" || name == "it") {
        set.who = name == "ball" ? any : name == "cue" ? cue : name == "it" ? it : opponent;
    } else {
        const std::size_t dot = name.find('.');
        const std::string_view base = name.substr(0, dot);
        std::uint32_t number = 0;
        if (dot != std::string_view::npos)
            std::from_chars(name.data() + dot + 1, name.data() + name.size(), number);
        const auto is_called = [&](const StartingBall& ball) {
            if (ball.binding < 0) return false;
            const auto& binding = ir_.ball_bindings[static_cast<std::size_t>(ball.binding)];
            if (binding.name) return binding.name->text == base;
            return binding.is_numbered && binding.node->keyword().text == base;
        };
        const auto is_of_kind = [&](const StartingBall& ball) {
            return names_.kind_names[ball.kind % names_.kind_names.size()] == base;
        };
        for (std::uint32_t i = 0; i < balls_.size(); ++i)
            if (is_called(balls_[i])) set.balls.push_back(i);
        const auto kind = std::ranges::find(names_.kind_names, base);
        const bool is_kind = set.balls.empty() && number == 0 && kind != names_.kind_names.end();
        for (std::uint32_t i = 0; is_kind && i < balls_.size(); ++i)
            if (is_of_kind(balls_[i])) set.balls.push_back(i);
        // Without a game, balls of the kind may come later.
        if (is_kind && !has_game())
            set.kind = static_cast<std::int32_t>(kind - names_.kind_names.begin());
        else if (number > set.balls.size() || set.balls.empty())
            return std::nullopt;
        if (number > 0) set.balls = {set.balls[number - 1]};
    }
    const auto index = static_cast<std::uint32_t>(ball_sets_.size());
    ball_sets_index_.emplace(std::string(name), index);
    ball_sets_.push_back(std::move(set));
    return index;
}

std::optional<std::uint32_t> RuleAssembly::find_place(std::string_view name) {
    if (const auto found = places_index_.find(name); found != places_index_.end())
        return found->second;
    PlaceIr place{std::string(name), {}, {}};
    const auto is_called = [&](int binding) {
        return names_.edges[static_cast<std::size_t>(binding)].name == name;
    };
    for (std::uint32_t i = 0; i < ir_.zones.size(); ++i)
        if (ir_.zones[i].device < 0 && is_called(ir_.zones[i].binding)) place.zones.push_back(i);
    for (std::uint32_t i = 0; i < ir_.capsules.size(); ++i)
        if (is_called(ir_.capsules[i].binding)) place.capsules.push_back(i);
    if (place.zones.empty() && place.capsules.empty()) return std::nullopt;
    const auto index = static_cast<std::uint32_t>(places_.size());
    places_index_.emplace(std::string(name), index);
    places_.push_back(std::move(place));
    return index;
}

std::vector<std::string_view> RuleAssembly::known_names() const {
    std::vector<std::string_view> known{"ball", "cue", "opponent"};
    for (const BallBinding& binding : ir_.ball_bindings)
        if (binding.name) known.push_back(binding.name->text);
    for (const ResolvedEdges& edges : names_.edges)
        if (!edges.name.empty()) known.emplace_back(edges.name);
    for (const std::string& kind : names_.kind_names)
        known.emplace_back(kind);
    return known;
}

// Whether a ball is called so: one that was not found has an error of its own.
bool RuleAssembly::is_ball(std::string_view name) const {
    return std::ranges::any_of(ir_.ball_bindings, [&](const BallBinding& binding) {
        return binding.name && binding.name->text == name;
    });
}

bool RuleAssembly::has_error(std::string_view name) const {
    return std::ranges::count(ir_.error_names, name) > 0;
}

std::optional<std::uint32_t> RuleAssembly::balls_named(const Word& name) {
    if (const auto found = find_balls(name.text)) return found;
    if (has_error(name.text) || is_ball(name.text)) return std::nullopt;
    if (find_place(name.text))
        return refuse("unknown-ball", name,
                      fmt::format("'{}' names a place, where balls are wanted", name.text),
                      fmt::format("to count the balls in a zone, write count(ball,{})", name.text));
    refuse("unknown-ball", name, fmt::format("there are no balls '{}'", name.text),
           did_you_mean(name.text, known_names(),
                        "write the name of a ball, a rack or a kind; ball, cue or opponent"));
    return std::nullopt;
}

std::optional<std::uint32_t> RuleAssembly::place_named(const Word& name, bool is_edge) {
    const auto found = find_place(name.text);
    const bool fits = found && (is_edge ? !places_[*found].capsules.empty() : has_zones(*found));
    if (fits) return found;
    if (has_error(name.text) || (is_edge && is_ball(name.text))) return std::nullopt;
    constexpr std::array edges{"wall",    "walls",    "edge", "edges",
                               "cushion", "cushions", "rail", "rails"};
    if (is_edge && std::ranges::count(edges, name.text) > 0) {
        refuse("unknown-place", name, fmt::format("no edge is called '{}'", name.text),
               "for any edge, write rail in place of hit, as in: on cue rail; or name it: edge "
               "name=top");
        return std::nullopt;
    }
    // A ball where a place is wanted must not be suggested again.
    std::vector<std::string_view> known = known_names();
    std::erase(known, name.text);
    refuse("unknown-place", name,
           is_edge ? fmt::format("nothing that a ball can hit is called '{}'", name.text)
                   : fmt::format("there is no pocket or zone '{}'", name.text),
           did_you_mean(name.text, known,
                        is_edge ? "name an edge: edge name=wall 0,0 9,0"
                                : "name a zone or a pocket: zone tee 0,0 0,0 r=1"));
    return std::nullopt;
}

std::optional<std::uint32_t> RuleAssembly::meaning_of(const RuleNameIr& name) {
    switch (name.role) {
        case Role::lights:
        case Role::switched:
            return lights_named(name.word, name.role);
        case Role::opening:
            return opening_named(name.word);
        case Role::holder:
            return holder_named(name.word);
        case Role::balls:
            return balls_named(name.word);
        case Role::device:
            return shot_named(name.word);
        case Role::place:
            break;
    }
    return place_named(name.word, false);
}

std::optional<std::vector<std::uint32_t>> RuleAssembly::resolve(
    const std::vector<RuleNameIr>& names) {
    std::vector<std::uint32_t> meanings;
    for (const RuleNameIr& name : names) {
        const auto found = meaning_of(name);
        if (!found) return std::nullopt;
        meanings.push_back(*found);
    }
    return meanings;
}

// Two balls meet, or a ball meets an edge: on BALLS hit BALLS|EDGE, on EDGE hit [BALLS], on BALLS
// rail [EDGE].
bool RuleAssembly::resolve_meeting(RuleIr& spec) {
    Rule& rule = spec.rule;
    const auto balls = find_balls(spec.subject.text);
    if (!balls) {
        const auto edge = place_named(spec.subject, true);
        if (!edge) return false;
        const auto other = spec.other ? balls_named(*spec.other) : std::nullopt;
        if (spec.other && !other) return false;
        rule.event = RuleEvent::edge_hit;
        rule.subject = *edge;
        rule.other = other.value_or(no_subject);
        return true;
    }
    if (!spec.other && rule.event == RuleEvent::hit) {
        refuse("event-incomplete", spec.event, fmt::format("'{}' hits what?", spec.subject.text),
               "write hit and the name of balls, or ball for any; rail for a cushion");
        return false;
    }
    rule.subject = *balls;
    if (!spec.other) return true;
    const auto others = rule.event == RuleEvent::hit ? find_balls(spec.other->text)
                                                     : std::optional<std::uint32_t>{};
    if (others) {
        rule.event = RuleEvent::balls_meet;
        rule.other = *others;
        return true;
    }
    const auto edge = place_named(*spec.other, true);
    if (!edge) return false;
    rule.event = RuleEvent::edge_hit;
    rule.subject = *edge;
    rule.other = *balls;
    return true;
}

// on PLACE enter|leave [BALLS], on BALLS enter|leave PLACE, on BALLS pocketed [PLACE].
bool RuleAssembly::resolve_visit(RuleIr& spec) {
    Rule& rule = spec.rule;
    const bool is_pocketed = rule.event == RuleEvent::pocketed;
    if (rule.event == RuleEvent::enter) rule.event = RuleEvent::place_entered;
    if (is_pocketed && !find_balls(spec.subject.text) && find_place(spec.subject.text)) {
        refuse("event-malformed", spec.subject, "balls are pocketed: their name stands first",
               fmt::format("write it as: on ball pocketed {}", spec.subject.text));
        return false;
    }
    const auto balls = is_pocketed ? balls_named(spec.subject) : find_balls(spec.subject.text);
    if (is_pocketed && !balls) return false;
    if (balls && !is_pocketed && !spec.other) {
        refuse("event-incomplete", spec.event,
               fmt::format("'{}' enters or leaves what?", spec.subject.text),
               "write the name of a zone behind it");
        return false;
    }
    std::optional<std::uint32_t> place;
    std::optional<std::uint32_t> who = balls;
    if (balls) {
        if (spec.other && !(place = place_named(*spec.other, false))) return false;
    } else {
        if (!(place = place_named(spec.subject, false))) return false;
        if (spec.other && !(who = balls_named(*spec.other))) return false;
    }
    rule.subject = is_pocketed ? *balls : *place;
    rule.other = is_pocketed ? place.value_or(no_subject) : who.value_or(no_subject);
    return true;
}

bool RuleAssembly::resolve_ball_event(RuleIr& spec) {
    using enum RuleEvent;
    if (spec.subject.text == "it" || (spec.other && spec.other->text == "it")) {
        refuse("it-without-ball", spec.subject.text == "it" ? spec.subject : *spec.other,
               "an event names the ball, and its conditions and actions call it 'it'",
               "write ball for any ball, or a name");
        return false;
    }
    if (spec.rule.event == all) {
        refuse("event-of-other-game", spec.event, "only parts of a pinball table light up",
               "count with a variable instead");
        return false;
    }
    if (spec.rule.event == hit || spec.rule.event == rail) return resolve_meeting(spec);
    return resolve_visit(spec);
}

}  // namespace carom
