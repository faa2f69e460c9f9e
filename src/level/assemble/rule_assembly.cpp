#include "level/assemble/rule_assembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "level/assemble/futile_rules.h"
#include "level/assemble/idle_words.h"
#include "level/statements/rule_actions.h"

namespace carom {
namespace {

// Why this kind of device never gives this event; none: it does.
std::optional<std::string> never_gives(DeviceKind kind, RuleEvent event) {
    const DeviceTraits& device = traits(kind);
    if (event == RuleEvent::all) {
        if (device.completes_group) return std::nullopt;
        return "only rollovers, targets, lamps and locks light up one by one";
    }
    if (kind == DeviceKind::lamp) return "a lamp only shines: wait for what lights it";
    if (event == RuleEvent::enter)
        return device.is_zone ? std::nullopt
                              : std::optional<std::string>("balls hit it: write hit");
    if (event != RuleEvent::hit) return "a part of a pinball table gives hit, enter and all";
    if (!device.is_zone || kind == DeviceKind::spinner) return std::nullopt;
    return "balls enter it: write enter";
}

// Replaces the indices into RuleIr::names by those of what the names denote.
void renumber(RuleValue& value, const std::vector<std::uint32_t>& meanings) {
    for (RuleStep& step : value) {
        if (step.what == RuleStep::What::count || step.what == RuleStep::What::lit)
            step.number = meanings[static_cast<std::size_t>(step.number)];
        if (step.place >= 0)
            step.place = static_cast<std::int32_t>(meanings[static_cast<std::size_t>(step.place)]);
    }
}

void renumber(RuleText& text, const std::vector<std::uint32_t>& meanings) {
    for (auto& piece : text.pieces) {
        if (auto* value = std::get_if<RuleValue>(&piece)) renumber(*value, meanings);
        if (auto* counted = std::get_if<RuleText::Counted>(&piece))
            renumber(counted->value, meanings);
    }
}

void renumber(std::vector<RuleClause>& needs, const std::vector<std::uint32_t>& meanings) {
    for (RuleClause& clause : needs)
        for (RuleCondition& condition : clause.all) {
            if (condition.what == RuleCondition::What::lit)
                condition.index = meanings[condition.index];
            renumber(condition.left, meanings);
            renumber(condition.right, meanings);
        }
}

void renumber(RuleAction& action, const std::vector<std::uint32_t>& meanings) {
    using enum RuleAction::What;
    renumber(action.value, meanings);
    renumber(action.text, meanings);
    if (action.what == light || action.what == unlight || action.what == reset ||
        action.what == advance || action.what == open || action.what == shut ||
        action.what == release || action.what == respot || action.what == remove)
        action.index = meanings[action.index];
    if (action.place >= 0)
        action.place = static_cast<std::int32_t>(meanings[static_cast<std::size_t>(action.place)]);
}

}  // namespace

std::nullopt_t RuleAssembly::refuse(FaultCode code, const Word& at, std::string message,
                                    std::string remedy) {
    context_.reporter.error(code, at.span(), std::move(message), std::move(remedy));
    return std::nullopt;
}

bool RuleAssembly::resolve_moment(const RuleIr& spec) {
    using enum RuleEvent;
    const RuleEvent event = spec.rule.event;
    const bool is_of_shots = event == shot_begins || event == shot_ends || event == shot_judged;
    const bool is_of_pinball = event == launch || event == drain;
    if (is_of_shots && is_pinball())
        refuse("event-of-other-game", spec.subject, "pinball has no shots",
               "wait for: ball launch, ball drain, turn begins");
    else if (is_of_pinball && !is_pinball())
        refuse("event-of-other-game", spec.event, "only pinball launches and drains balls",
               "wait for: shot begins, shot ends, ball pocketed");
    else
        return true;
    return false;
}

bool RuleAssembly::resolve_device_event(RuleIr& spec) {
    const auto group = table_.group_named(spec.subject, true);
    if (!group) return false;
    spec.rule.subject = *group;
    const DeviceKind kind = table_.kind_of(*group);
    if (const auto why = never_gives(kind, spec.rule.event)) {
        refuse("event-never-happens", spec.event,
               fmt::format("'{}' is a {}, which never gives '{}'", spec.subject.text,
                           traits(kind).name, spec.event.text),
               *why);
        return false;
    }
    if (spec.rule.event == RuleEvent::all && kind == DeviceKind::hole &&
        !table_.keeps_balls(*group)) {
        refuse("event-never-happens", spec.event,
               fmt::format("'{}' keeps no balls, so it is never full", spec.subject.text),
               "write the word keeps in the line of the hole, or wait for enter");
        return false;
    }
    if (spec.rule.event == RuleEvent::all && table_.is_one_of_group(*group)) {
        refuse("event-never-happens", spec.event, "one device alone never gives 'all'",
               "wait for the whole group, or for hit or enter");
        return false;
    }
    if (!spec.other) return true;
    refuse("event-of-other-game", *spec.other, "at pinball every ball counts alike",
           fmt::format("write it as: on {} {}", spec.subject.text, spec.event.text));
    return false;
}

bool RuleAssembly::resolve_subject(RuleIr& spec) {
    using enum RuleEvent;
    switch (spec.rule.event) {
        case timer_ends:
            return true;
        case game_begins:
        case turn_begins:
        case shot_begins:
        case shot_ends:
        case shot_judged:
        case launch:
        case drain:
            return resolve_moment(spec);
        default:
            return is_pinball() ? resolve_device_event(spec) : resolve_ball_event(spec);
    }
}

bool RuleAssembly::check_actions(const RuleIr& spec) {
    const RuleGames other = is_pinball() ? RuleGames::shots : RuleGames::pinball;
    for (std::size_t i = 0; i < spec.actions.size(); ++i) {
        if (games_of(spec.rule.actions[i].what) != other) continue;
        refuse("action-of-other-game", spec.actions[i],
               fmt::format("'{}' belongs to game {}", spec.actions[i].text,
                           is_pinball() ? "shots" : "pinball"),
               "take another action");
        return false;
    }
    if (!spec.rule.once || !is_pinball()) return true;
    refuse("action-of-other-game", spec.event, "'once' belongs to game shots",
           "pinball has no shots: take a variable of turn");
    return false;
}

// `it` is the ball that an event names last, so there is none without such an event.
bool RuleAssembly::check_it(const std::vector<RuleNameIr>& names, const Rule* rule) {
    using enum RuleEvent;
    constexpr std::array with_ball{balls_meet, rail, pocketed, place_entered, place_left, edge_hit};
    if (rule && !is_pinball() && std::ranges::count(with_ball, rule->event) > 0) return true;
    const auto it = std::ranges::find_if(names, [](const RuleNameIr& name) {
        return name.role == Role::balls && name.word.text == "it";
    });
    if (it == names.end()) return true;
    refuse("it-without-ball", it->word, "'it' is the ball of an event of balls",
           "name the ball, or wait for hit, rail, pocketed, enter or leave");
    return false;
}

void RuleAssembly::resolve_rule(RuleIr& spec) {
    if (!resolve_subject(spec) || !check_actions(spec) || !check_it(spec.names, &spec.rule)) return;
    const auto meanings = resolve(spec.names);
    if (!meanings) return;
    renumber(spec.rule.needs, *meanings);
    for (RuleAction& action : spec.rule.actions)
        renumber(action, *meanings);
    book_.rules.push_back(spec.rule);
}

// Rules and tasks need a game that follows them; a goal does not, but a referee has its own.
bool RuleAssembly::check_placement() {
    if (has_game()) return true;
    if (!ir_.rules.empty() || !ir_.tasks.empty()) {
        refuse("rules-without-game",
               ir_.rules.empty() ? ir_.tasks.front().text : ir_.rules.front().subject,
               "rules need a game that follows them", "say which: game pinball, or game shots");
        return false;
    }
    const GameRow* game = ir_.settings.game ? game_named(*ir_.settings.game) : nullptr;
    if (ir_.goals.empty() || !game || !game->rack) return !ir_.goals.empty();
    refuse("goal-of-referee", ir_.goals.front().text,
           fmt::format("the goal of game {} is to win", game->name),
           "take the goal out, or play without game");
    return false;
}

void RuleAssembly::resolve_goals() {
    for (GoalIr& spec : ir_.goals) {
        if (!check_it(spec.names, nullptr)) continue;
        const auto meanings = resolve(spec.names);
        if (!meanings) continue;
        renumber(spec.goal.needs, *meanings);
        renumber(spec.goal.value, *meanings);
        book_.goals.push_back(spec.goal);
    }
}

void RuleAssembly::check() {
    book_.variables = ir_.variables;
    book_.timers = ir_.timers;
    book_.players = ir_.settings.players;
    book_.is_shots = ir_.settings.is_shots;
    book_.least_wins = ir_.settings.least_wins;
    book_.settle = ir_.settings.settle;
    book_.may_miss = ir_.settings.may_miss;
    if (!check_placement()) return;
    for (RuleIr& rule : ir_.rules)
        resolve_rule(rule);
    for (TaskIr& spec : ir_.tasks) {
        if (!check_it(spec.names, nullptr)) continue;
        const auto meanings = resolve(spec.names);
        if (!meanings) continue;
        renumber(spec.task.needs, *meanings);
        renumber(spec.task.text, *meanings);
        for (std::uint32_t& shot : spec.task.shots)
            shot = (*meanings)[shot];
        book_.tasks.push_back(spec.task);
    }
    resolve_goals();
    check_symbols();
    check_motions();
    if (context_.reporter.has_errors()) return;
    if (!has_game()) return;
    check_game();
    check_events();
    const RuleFacts known = facts();
    warn_of_futile_rules(book_, known, context_);
    warn_of_idle_words(book_, known, context_);
}

void RuleAssembly::fill_in(Scene& scene, const std::vector<std::uint32_t>& world_zones) {
    for (const BallsIr& set : ball_sets_) {
        RuleBalls balls{set.who, {}, set.kind};
        for (const std::uint32_t ball : set.balls)
            balls.balls.push_back(scene.world.balls().id[ball]);
        std::ranges::sort(balls.balls);
        book_.balls.push_back(std::move(balls));
    }
    for (const PlaceIr& from : places_) {
        RulePlace place{from.name, {}, {}};
        for (const std::uint32_t zone : from.zones)
            place.zones.push_back(world_zones[zone]);
        for (const std::uint32_t capsule : from.capsules)
            place.edges.push_back(scene.world.capsules().id[capsule]);
        std::ranges::sort(place.edges);
        book_.places.push_back(std::move(place));
    }
    index_rules(book_);
    scene.rules = std::move(book_);
}

}  // namespace carom
