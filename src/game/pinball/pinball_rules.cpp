#include <algorithm>
#include <limits>
#include <utility>

#include "game/pinball/pinball.h"
#include "game/pinball/pinball_players.h"
#include "game/pinball/pinball_table.h"
#include "game/rules/rules.h"

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

void add_or_set(std::int64_t& sum, const RuleAction& action, std::int64_t value) {
    if (action.adds)
        add(sum, value);
    else
        sum = std::max<std::int64_t>(0, value);
}

void begin_multiball(Pinball game, std::int64_t wanted) {
    constexpr std::int64_t most = 8;
    const auto there = static_cast<std::int64_t>(all_balls(game));
    wanted = std::min(wanted, most);
    if (wanted <= there) return;
    game.state.to_serve += static_cast<std::uint32_t>(wanted - there);
    game.state.serves_itself = true;
    save_for(game, game.table().save);
    game.say("MULTIBALL", 3.0);
}

void set_lights(Pinball game, const RuleAction& action) {
    for (const std::uint32_t device : game.table().groups[action.index].devices) {
        set_lit(game, device, action.what == What::light || action.what == What::open);
        if (action.seconds > 0.0)
            game.state.lit_until[device] = game.now() + game.ticks(action.seconds);
        const bool drops = game.table().devices[device].kind == DeviceKind::droptarget;
        if (drops && action.what == What::reset) game.state.is_rising[device] = 1;
    }
}

/// What the rules of a table may ask.
class PinballAnswers : public RuleHost {
  public:
    PinballAnswers(const Scene& scene, const World& world, const PinballState& state)
        : scene_(scene), world_(world), state_(state) {}

    std::uint64_t now() const override { return world_.tick(); }
    double rate() const override { return world_.rate(); }
    std::int64_t quantity(RuleQuantity what) const override;
    std::int64_t count(const RuleBalls&, const RulePlace*) const override {
        return static_cast<std::int64_t>(world_.balls().size());
    }
    std::pair<std::int64_t, std::int64_t> lights(std::uint32_t group) const override {
        const std::vector<std::uint32_t>& devices = scene_.table.groups[group].devices;
        const auto is_lit = [&](std::uint32_t device) { return state_.is_lit[device] != 0; };
        return {std::ssize(devices), std::ranges::count_if(devices, is_lit)};
    }
    bool moves(std::uint32_t mover) const override { return world_.movers()[mover].runs; }
    void act(const RuleAction&, std::int64_t, int) override {}

  private:
    const Scene& scene_;
    const World& world_;
    const PinballState& state_;
};

/// What the rules of a table may ask and do.
class PinballHost final : public PinballAnswers {
  public:
    explicit PinballHost(Pinball game)
        : PinballAnswers(game.scene, game.world, game.state), game_(game) {}

    void act(const RuleAction& action, std::int64_t value, int depth) override;

    Rules rules() { return {game_.scene.rules, game_.state.rules, *this}; }

  private:
    void advance(std::uint32_t group, int depth);

    Pinball game_;
};

std::int64_t PinballAnswers::quantity(RuleQuantity what) const {
    switch (what) {
        case RuleQuantity::score:
            return state_.score;
        case RuleQuantity::player:
            return std::int64_t{state_.rules.player} + 1;
        case RuleQuantity::players:
            return std::int64_t{state_.players};
        case RuleQuantity::ball:
            return std::int64_t{state_.ball};
        case RuleQuantity::bonus:
            return state_.bonus;
        case RuleQuantity::multiplier:
            return state_.multiplier;
        case RuleQuantity::best:
            return best_score(state_);
        case RuleQuantity::multiball:
            return std::ranges::count_if(
                       world_.balls().id,
                       [&](BallId ball) { return is_in_play(scene_, state_, ball); }) >= 2
                       ? 1
                       : 0;
        default:
            return 0;
    }
}

// Lights the first unlit device. If that completes the group, its `all` rules apply.
void PinballHost::advance(std::uint32_t group, int depth) {
    for (const std::uint32_t device : game_.table().groups[group].devices) {
        if (game_.state.is_lit[device] != 0) continue;
        set_lit(game_, device, true);
        if (are_all_lit(game_, group)) happen(rules(), RuleEvent::all, group, depth + 1);
        return;
    }
}

void PinballHost::act(const RuleAction& action, std::int64_t value, int depth) {
    PinballState& state = game_.state;
    constexpr std::int64_t most_multiplier = 100;
    switch (action.what) {
        case What::score:
            add(state.score, value);
            break;
        case What::bonus:
            add_or_set(state.bonus, action, value);
            break;
        case What::multiplier:
            add_or_set(state.multiplier, action, value);
            state.multiplier = std::clamp<std::int64_t>(state.multiplier, 1, most_multiplier);
            break;
        case What::multiball:
            begin_multiball(game_, value);
            break;
        case What::save:
            save_for(game_, action.seconds);
            break;
        case What::extraball:
            ++state.extra_balls;
            state.extra_ball_is_untold = true;
            break;
        case What::message:
            game_.say(text_of(game_.scene.rules, state.rules, *this, action.text), 3.0);
            break;
        case What::advance:
            advance(action.index, depth);
            break;
        case What::light:
        case What::unlight:
        case What::reset:
        case What::open:
        case What::shut:
            set_lights(game_, action);
            break;
        case What::release:
            release(game_, game_.table().groups[action.index]);
            break;
        case What::start_motion:
        case What::stop_motion:
            game_.world.edit_movers()[action.index].runs = action.what == What::start_motion;
            break;
        default:
            break;  // actions of other games, which the loader refuses
    }
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

void apply_rules(Pinball game, std::uint32_t device, RuleEvent event) {
    ++game.state.events[device];
    if (!game.is_scoring()) return;
    const std::uint32_t group = game.table().devices[device].group;
    const std::int32_t own = game.table().devices[device].own_group;
    PinballHost host(game);
    if (own >= 0) happen(host.rules(), event, static_cast<std::uint32_t>(own));
    happen(host.rules(), event, group);
    const DeviceKind kind = game.table().devices[device].kind;
    const bool lights = kind == DeviceKind::rollover || kind == DeviceKind::target ||
                        kind == DeviceKind::droptarget || kind == DeviceKind::lock ||
                        game.table().devices[device].keeps;
    if (!lights || game.state.is_lit[device] != 0) return;
    set_lit(game, device, true);
    if (are_all_lit(game, group)) happen(host.rules(), RuleEvent::all, group);
}

void apply_rules(Pinball game, RuleEvent moment) {
    if (!game.is_scoring()) return;
    PinballHost host(game);
    happen(host.rules(), moment);
}

void run_rules(Pinball game) {
    RuleState& rules = game.state.rules;
    if (!game.is_scoring()) return;
    if (std::exchange(rules.game_is_new, false)) apply_rules(game, RuleEvent::game_begins);
    if (std::exchange(rules.turn_is_new, false)) apply_rules(game, RuleEvent::turn_begins);
    if (rules.timer_ends.empty()) return;
    PinballHost host(game);
    end_timers(host.rules());
}

void tell_extra_ball(Pinball game) {
    constexpr double least_shown = 1.5;  // s of the message before it
    PinballState& state = game.state;
    const bool waits =
        !state.message.empty() && game.now() < state.message_since + game.ticks(least_shown);
    if (waits || !std::exchange(state.extra_ball_is_untold, false)) return;
    game.say("EXTRA BALL", 3.0);
}

void note_goal(Pinball game) {
    if (game.scene.rules.goals.empty() || !game.is_scoring()) return;
    note_goal(game.scene.rules, game.state.rules, PinballHost(game), game.state.goal);
}

std::string task_text(const Scene& scene, const World& world, const PinballState& state) {
    if (scene.rules.tasks.empty() && scene.rules.goals.empty()) return {};
    if (state.is_tilted) return "TILT";
    if (state.rules.turn_is_new) return {};  // its rules have not said what to shoot for
    const PinballAnswers answers(scene, world, state);
    std::string task = task_text(scene.rules, state.rules, answers);
    return task.empty() ? goal_text(scene.rules, state.goal) : task;
}

std::span<const std::uint32_t> shots_to_make(const Scene& scene, const World& world,
                                             const PinballState& state) {
    const bool is_played =
        state.phase == PinballState::Phase::playing && !state.is_tilted && !state.rules.turn_is_new;
    if (scene.rules.tasks.empty() || !is_played) return {};
    const RuleTask* const task =
        task_of(scene.rules, state.rules, PinballAnswers(scene, world, state));
    return task ? std::span<const std::uint32_t>(task->shots) : std::span<const std::uint32_t>();
}

void save_for(Pinball game, double seconds) {
    if (!(seconds > 0.0) || game.state.is_tilted) return;
    game.state.save_until = std::max(game.state.save_until, game.now() + game.ticks(seconds));
}

}  // namespace carom
