#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "game/pinball/pinball_table.h"

// Executes the rules that the author of a table wrote.
namespace carom {
namespace {

using What = RuleAction::What;

bool are_all_lit(const Pinball& game, std::uint32_t group) {
    const DeviceGroup& devices = game.table().groups[group];
    return !devices.devices.empty() && std::ranges::all_of(devices.devices, [&](std::uint32_t d) {
        return game.state.is_lit[d] != 0;
    });
}

void add(std::int64_t& sum, std::int64_t amount) {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max() / 4;
    sum = std::clamp<std::int64_t>(sum + amount, 0, most);
}

void add_or_set(std::int64_t& sum, const RuleAction& action) {
    if (action.adds)
        add(sum, action.amount);
    else
        sum = std::max<std::int64_t>(0, action.amount);
}

void begin_multiball(Pinball game, std::int64_t wanted) {
    const auto there = static_cast<std::int64_t>(game.world.balls().size() + game.state.to_serve);
    if (wanted <= there) return;
    game.state.to_serve += static_cast<std::uint32_t>(wanted - there);
    game.state.serves_itself = true;
    save_for(game, game.table().save);
    game.say("MULTIBALL", 3.0);
}

void follow(Pinball game, std::uint32_t group, Rule::When when, int depth);

// Lights the first unlit device. If that completes the group, its `all` rules apply.
void advance(Pinball game, std::uint32_t group, int depth) {
    for (const std::uint32_t device : game.table().groups[group].devices) {
        if (game.state.is_lit[device] != 0) continue;
        set_lit(game, device, true);
        if (are_all_lit(game, group)) follow(game, group, Rule::When::all, depth + 1);
        return;
    }
}

void carry_out(Pinball game, const RuleAction& action, int depth) {
    PinballState& state = game.state;
    constexpr std::int64_t most_multiplier = 100;
    switch (action.what) {
        case What::score:
            add(state.score, action.amount);
            break;
        case What::bonus:
            add_or_set(state.bonus, action);
            break;
        case What::multiplier:
            add_or_set(state.multiplier, action);
            state.multiplier = std::clamp<std::int64_t>(state.multiplier, 1, most_multiplier);
            break;
        case What::multiball:
            begin_multiball(game, action.amount);
            break;
        case What::save:
            save_for(game, action.seconds);
            break;
        case What::extraball:
            ++state.extra_balls;
            game.say("EXTRA BALL", 3.0);
            break;
        case What::message:
            game.say(action.text, 3.0);
            break;
        case What::advance:
            advance(game, action.group, depth);
            break;
        case What::light:
        case What::unlight:
        case What::reset:
            for (const std::uint32_t device : game.table().groups[action.group].devices) {
                set_lit(game, device, action.what == What::light);
                if (action.seconds > 0.0)
                    state.lit_until[device] = game.now() + game.ticks(action.seconds);
                const bool drops = game.table().devices[device].kind == DeviceKind::droptarget;
                if (drops && action.what == What::reset) state.is_rising[device] = 1;
            }
            break;
    }
}

bool holds(const Pinball& game, const Rule& rule) {
    return std::ranges::all_of(rule.needs, [&](const Rule::Need& need) {
        const bool is_so =
            need.group ? are_all_lit(game, *need.group) : game.world.balls().size() >= 2;
        return is_so != need.is_not;
    });
}

// Evaluates all conditions first: the actions of a rule must not change whether the next one holds.
void follow(Pinball game, std::uint32_t group, Rule::When when, int depth) {
    constexpr int deepest = 8;  // ends rules that light each other in a cycle
    if (depth > deepest) return;
    std::vector<const Rule*> due;
    for (const Rule& rule : game.table().rules)
        if (rule.group == group && rule.when == when && holds(game, rule)) due.push_back(&rule);
    for (const Rule* rule : due)
        for (const RuleAction& action : rule->actions)
            carry_out(game, action, depth);
}

}  // namespace

void set_lit(Pinball game, std::uint32_t device, bool is_lit) {
    game.state.is_lit[device] = is_lit ? 1 : 0;
    game.state.lit_until[device] = 0;
}

void expire_lights(Pinball game) {
    for (std::uint32_t device = 0; device < game.state.lit_until.size(); ++device) {
        const std::uint64_t until = game.state.lit_until[device];
        if (until > 0 && game.now() >= until) set_lit(game, device, false);
    }
}

void apply_rules(Pinball game, std::uint32_t device, Rule::When when) {
    if (!game.is_scoring()) return;
    const std::uint32_t group = game.table().devices[device].group;
    follow(game, group, when, 0);
    const DeviceKind kind = game.table().devices[device].kind;
    const bool lights = kind == DeviceKind::rollover || kind == DeviceKind::target ||
                        kind == DeviceKind::droptarget;
    if (!lights || game.state.is_lit[device] != 0) return;
    set_lit(game, device, true);
    if (are_all_lit(game, group)) follow(game, group, Rule::When::all, 0);
}

void save_for(Pinball game, double seconds) {
    if (!(seconds > 0.0)) return;
    game.state.save_until = std::max(game.state.save_until, game.now() + game.ticks(seconds));
}

}  // namespace carom
