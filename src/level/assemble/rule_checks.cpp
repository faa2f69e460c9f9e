#include <fmt/format.h>

#include <algorithm>

#include "level/assemble/rule_assembly.h"

// What is no error in rules, but of no use: members of RuleAssembly.
namespace carom {
namespace {

bool is_sink(const ZoneIr& zone) {
    return zone.is_pocket || zone.zone.effect == Zone::Effect::sink;
}

}  // namespace

bool RuleAssembly::has_action(std::initializer_list<RuleAction::What> wanted) const {
    return std::ranges::any_of(book_.rules, [&](const Rule& rule) {
        return std::ranges::any_of(rule.actions, [&](const RuleAction& action) {
            return std::ranges::find(wanted, action.what) != wanted.end();
        });
    });
}

bool RuleAssembly::has_action(RuleAction::What wanted, std::uint32_t index) const {
    return std::ranges::any_of(book_.rules, [&](const Rule& rule) {
        return std::ranges::any_of(rule.actions, [&](const RuleAction& action) {
            return action.what == wanted && action.index == index;
        });
    });
}

// Variables that nothing reads, timers that nothing starts or waits for.
void RuleAssembly::check_symbols() {
    const auto starts = [&](std::uint32_t timer) {
        return has_action(RuleAction::What::start, timer);
    };
    const auto is_awaited = [&](std::uint32_t timer) {
        return std::ranges::any_of(book_.rules, [&](const Rule& rule) {
            return rule.event == RuleEvent::timer_ends && rule.subject == timer;
        });
    };
    for (const auto& [name, symbol] : ir_.rule_symbols) {
        const Span at = symbol.name.span();
        if (!symbol.is_timer) {
            const bool is_turns =
                is_pinball() && ir_.variables[symbol.index].scope == RuleScope::shot;
            if (is_turns)
                context_.reporter.error("event-of-other-game", at, "pinball has no shots",
                                        fmt::format("write: var {} of turn", name));
            else if (!symbol.is_read)
                context_.reporter.warning("variable-unread", at,
                                          fmt::format("nothing reads the variable '{}'", name),
                                          "take it out, or use it in a condition or a message");
            continue;
        }
        if (context_.reporter.has_errors()) continue;
        if (!starts(symbol.index))
            context_.reporter.warning("timer-never-starts", at,
                                      fmt::format("nothing starts the timer '{}'", name),
                                      fmt::format("add an action: start {}", name));
        else if (!symbol.is_read && !is_awaited(symbol.index))
            context_.reporter.warning("variable-unread", at,
                                      fmt::format("nothing waits for the timer '{}'", name),
                                      fmt::format("add a rule: on {} ends ...", name));
    }
}

// Motions that wait, and that nothing starts.
void RuleAssembly::check_motions() {
    if (context_.reporter.has_errors()) return;
    for (std::uint32_t i = 0; i < ir_.motions.size(); ++i) {
        const Word& name = ir_.motions[i].names.front();
        if (ir_.motions[i].waits && !has_action(RuleAction::What::start_motion, i))
            context_.reporter.warning("motion-never-starts", name.span(),
                                      fmt::format("nothing starts the motion '{}'", name.text),
                                      fmt::format("add an action: start {}", name.text));
    }
}

// Parts of a pinball table that only game pinball moves or lights.
void RuleAssembly::check_devices() {
    for (const DeviceIr& device : ir_.devices) {
        using enum DeviceKind;
        const DeviceKind kind = device.device.kind;
        if (kind == bumper || kind == slingshot || kind == gate || kind == edge) continue;
        context_.reporter.error(
            "device-in-shots", device.origin.span(),
            fmt::format("a {} works in pinball only", traits(kind).name),
            "game shots has edges, pegs, bumpers, slingshots, gates, zones and pockets");
    }
}

// Parts that do nothing until a rule moves them, and that no rule does.
void RuleAssembly::check_use_of_devices() {
    using enum RuleAction::What;
    const auto is_used = [&](std::size_t spec, RuleAction::What what) {
        return std::ranges::any_of(book_.rules, [&](const Rule& rule) {
            return std::ranges::any_of(rule.actions, [&](const RuleAction& action) {
                return action.what == what &&
                       table_.has_device(action.index, table_.device_of(spec));
            });
        });
    };
    for (std::size_t i = 0; i < ir_.devices.size(); ++i) {
        const Device& device = ir_.devices[i].device;
        const auto warn = [&](RuleAction::What what, std::string message, std::string remedy) {
            if (table_.device_of(i) < 0 || is_used(i, what)) return;
            context_.reporter.warning("device-unused", ir_.devices[i].origin.span(),
                                      std::move(message), std::move(remedy));
        };
        if (device.keeps)
            warn(release, "nothing releases the balls of this hole", "add an action: release NAME");
        if (device.kind == DeviceKind::magnet)
            warn(light, "nothing lights this magnet", "add an action: light NAME");
        if (device.kind == DeviceKind::post)
            warn(open, "nothing opens this post", "add an action: open NAME; or draw an edge");
    }
}

void RuleAssembly::check_game() {
    if (is_pinball()) return check_use_of_devices();
    check_devices();
    using enum RuleAction::What;
    const Span at = *ir_.settings.game_at;
    if (!has_action({win, lose, end}) && book_.goals.empty())
        context_.reporter.warning("game-without-end", at, "this game has no way to end",
                                  "add a rule with win, lose or end; or a goal");
    if (!has_action({turn}) && book_.players > 1)
        context_.reporter.warning(
            "game-without-turns", at,
            fmt::format("of {} players only the first ever plays", book_.players),
            "add a rule with: turn");
    const LevelSettings& s = ir_.settings;
    if (!s.cloth && !s.stop_speed && !s.drag)
        context_.reporter.warning("balls-never-rest", at,
                                  "the balls never come to rest, so no shot ends",
                                  "add a line: use cloth slide=0.2 roll=0.01 spin=10");
}

RuleFacts RuleAssembly::facts() {
    RuleFacts facts;
    const bool has_more_balls = !ir_.fills.empty() || !ir_.emitters.empty();
    const bool has_one_cue = ir_.cues.size() == 1;
    const auto struck = has_one_cue ? find_balls(ir_.cues.front().ball.text) : std::nullopt;
    facts.has_one_cue_ball = struck && ball_sets_[*struck].balls.size() == 1;
    for (const BallsIr& set : ball_sets_) {
        const bool is_listed = set.who == RuleBalls::Who::listed;
        const std::size_t balls = is_listed ? set.balls.size() : balls_.size();
        facts.balls.push_back(has_more_balls ? most_rule_number : static_cast<std::int64_t>(balls));
    }
    for (const PlaceIr& place : places_)
        facts.takes_balls.push_back(!place.zones.empty() &&
                                    std::ranges::all_of(place.zones, [&](std::uint32_t zone) {
                                        return is_sink(ir_.zones[zone]);
                                    }));
    return facts;
}

// Rules whose events nothing on the table can cause.
void RuleAssembly::check_events() {
    const RuleFacts known = facts();
    const auto is_cue_and_opponent = [&](const Rule& rule) {
        using enum RuleBalls::Who;
        const auto a = ball_sets_[rule.subject].who;
        const auto b = ball_sets_[rule.other].who;
        return (a == cue && b == opponent) || (a == opponent && b == cue);
    };
    for (const RuleIr& spec : ir_.rules) {
        using enum RuleEvent;
        const auto warn = [&](std::string message, std::string remedy) {
            context_.reporter.warning("event-never-happens", spec.event.span(), std::move(message),
                                      std::move(remedy));
        };
        if (spec.rule.event == pocketed && std::ranges::none_of(ir_.zones, is_sink))
            warn("there are no pockets on this table", "add one: pocket NAME at=0,0 r=62");
        else if (spec.rule.event == pocketed && spec.other && !known.takes_balls[spec.rule.other])
            warn(fmt::format("balls pass through '{}', which takes none", spec.other->text),
                 "write the word sink in the line of the zone, or wait for enter");
        else if (spec.rule.event == balls_meet && known.has_one_cue_ball &&
                 is_cue_and_opponent(spec.rule))
            warn("with one cue, the ball of the opponent is the cue ball itself",
                 "add a line for each player: cue ball=NAME power=A..B");
        else if (spec.rule.event == rail && ir_.capsules.empty())
            warn("there are no edges on this table", "add one: box 0,0 100,60");
        else if (spec.rule.event == launch &&
                 std::ranges::count(table_.devices(), DeviceKind::plunger, &Device::kind) == 0)
            warn("there is no plunger on this table", "add one: plunger NAME at=0,0 dir=up ...");
        else if (spec.rule.event == balls_meet && balls_.size() < 2)
            warn("there is one ball on this table", "add another: ball NAME at=0,0");
    }
}

}  // namespace carom
