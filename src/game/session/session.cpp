#include "game/session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace carom {
namespace {

// After a step back, there is a snapshot of each of the last ticks before the present, so that the
// next step back is quick. These snapshots may take this share of the memory.
constexpr std::size_t dense_share = 4;
constexpr std::uint64_t most_dense_ticks = 240;

using Pair = std::array<std::uint32_t, 3>;

Pair pair_of(const Contact& contact) {
    return {static_cast<std::uint32_t>(contact.kind), contact.a, contact.b};
}

/// The pairs that met, sorted.
std::vector<Pair> pairs_of(std::span<const Contact> contacts) {
    std::vector<Pair> pairs;
    pairs.reserve(contacts.size());
    for (const Contact& contact : contacts)
        pairs.push_back(pair_of(contact));
    std::ranges::sort(pairs);
    return pairs;
}

std::size_t bytes_of(const std::vector<TimedCommand>& log) {
    return log.capacity() * sizeof(TimedCommand);
}

}  // namespace

Session::Session(Scene scene, const SolverSettings& solver, std::size_t rewind_bytes)
    : scene_(std::move(scene)),
      first_solver_(solver),
      solver_(solver),
      world_(scene_.world),
      game_(begin_game(scene_)),
      history_(rewind_bytes),
      rewind_bytes_(rewind_bytes) {}

Session::Session(Session&& other) noexcept = default;
Session& Session::operator=(Session&& other) noexcept = default;
Session::~Session() = default;

std::optional<std::string> Session::apply(const Command& command) {
    if (is_following_) return "this is a recording, which is only watched";
    if (auto why_not = refusal(scene_, world_, game_, command)) return why_not;
    forget_future();
    fingerprints_.forget_from(world_.tick());
    execute_now(command);
    log(command);
    return std::nullopt;
}

void Session::execute_now(const Command& command) {
    if (const auto* change = std::get_if<command::SetSolver>(&command))
        use_solver(change->settings);
    execute(scene_, world_, game_, command);
}

void Session::use_solver(const SolverSettings& settings) {
    if (!(settings == solver_.settings())) solver_ = Solver(settings);
}

void Session::log(const Command& command) {
    const auto earlier = std::find_if(log_.rbegin(), log_.rend(), [&](const TimedCommand& logged) {
        return logged.tick != world_.tick() || !continues_gesture(logged.command, command) ||
               moves_same_hand(logged.command, command) || !moves_capsule(logged.command);
    });
    if (earlier != log_.rend() && earlier->tick == world_.tick() &&
        moves_same_hand(earlier->command, command))
        earlier->command = command;
    else
        log_.push_back({world_.tick(), command});
    executed_ = log_.size();
    bound_log();
}

void Session::forget_future() {
    if (executed_ == log_.size() && latest_ == world_.tick()) return;
    log_.resize(executed_);
    history_.forget_from(world_.tick());
    fingerprints_.forget_from(world_.tick());
    latest_ = world_.tick();
    const auto balls = world_.held_balls();
    const auto capsules = world_.held_capsules();
    for (const HeldBall& held : balls) {
        execute_now(command::DropBall{held.id});
        log(command::DropBall{held.id});
    }
    for (const HeldCapsule& held : capsules) {
        execute_now(command::DropCapsule{held.id});
        log(command::DropCapsule{held.id});
    }
    for (const Button button : pressed_buttons(game_)) {
        execute_now(command::Press{button, false});
        log(command::Press{button, false});
    }
    if (is_plunger_pulled(game_)) {  // by a hand in the forgotten future
        execute_now(command::Pull{});
        log(command::Pull{});
    }
}

// Keeps the newer half of the log, and a snapshot from which its oldest command can be reached.
void Session::bound_log() {
    if (!keeps_all_commands_ && bytes_of(log_) > rewind_bytes_ / 2 && log_.size() > 1) {
        const Snapshot* kept = history_.at_or_before(log_[log_.size() / 2].tick);
        if (kept && kept->world.tick() > earliest())
            base_ = *kept;
        else
            base_ = Snapshot{world_, solver_.settings(), game_};
        const std::uint64_t start = base_->world.tick();
        const auto stays = std::ranges::upper_bound(log_, start, {}, &TimedCommand::tick);
        log_ = std::vector<TimedCommand>(stays, log_.end());
        executed_ = log_.size();
        history_.forget_before(start);
    }
    const std::size_t taken =
        bytes_of(log_) + (base_ ? bytes_of_snapshot(base_->world) + bytes_of(base_->game) : 0);
    history_.set_limit(rewind_bytes_ - std::min(rewind_bytes_, taken), world_.tick());
}

void Session::execute_log_of_this_tick() {
    while (executed_ < log_.size() && log_[executed_].tick == world_.tick()) {
        const Command& command = log_[executed_].command;
        if (is_following_) {
            if (const auto why_not = refusal(scene_, world_, game_, command)) {
                fault_ = fmt::format("at tick {}: {}", world_.tick(), *why_not);
                log_.resize(executed_);
                latest_ = world_.tick();
                return;
            }
        }
        execute_now(command);
        ++executed_;
    }
}

void Session::follow(std::vector<TimedCommand> commands, std::uint64_t end, int version) {
    fingerprints_ = FingerprintLog(version);
    log_ = std::move(commands);
    latest_ = end;
    keeps_all_commands_ = true;
    is_following_ = true;
    execute_log_of_this_tick();
}

// Returns false when the tick was cancelled.
bool Session::advance() {
    fingerprints_.add_if_due(world_, game_);
    outcome_ = solver_.tick(world_, keep_going_);
    if (outcome_ == TickOutcome::cancelled) return false;
    contacts_.assign(solver_.contacts().begin(), solver_.contacts().end());
    update_game(scene_, world_, game_, contacts_);
    latest_ = std::max(latest_, world_.tick());
    if (after_tick_) after_tick_(*this);
    execute_log_of_this_tick();
    return true;
}

bool Session::step_forward() {
    if (is_at_end()) return false;
    if (world_.tick() % History::spacing == 0) history_.keep(world_, solver_.settings(), game_);
    return advance();
}

bool Session::step_back() {
    return world_.tick() > earliest() && go_to(world_.tick() - 1);
}

bool Session::go_to(std::uint64_t tick) {
    if (tick < earliest() || tick > latest_) return false;
    const Snapshot* nearest = tick > 0 ? history_.at_or_before(tick - 1) : nullptr;
    const bool forward_is_shorter =
        tick >= world_.tick() && (!nearest || nearest->world.tick() <= world_.tick());
    if (!forward_is_shorter && !restore(tick)) return false;
    while (world_.tick() < tick && step_forward()) {
    }
    return world_.tick() == tick;
}

// Starts at the last snapshot before the tick, not at it: the last tick is computed again, so that
// its contacts are known. Returns false when a tick was cancelled: the present is then before it.
bool Session::restore(std::uint64_t tick) {
    const Snapshot* from = tick > earliest() ? history_.at_or_before(tick - 1) : nullptr;
    contacts_.clear();
    if (from) {
        world_ = from->world;
        game_ = from->game;
        use_solver(from->solver);
        const auto next = std::ranges::upper_bound(log_, world_.tick(), {}, &TimedCommand::tick);
        executed_ = static_cast<std::size_t>(next - log_.begin());
    } else {
        world_ = base_ ? base_->world : scene_.world;
        game_ = base_ ? base_->game : begin_game(scene_);
        use_solver(base_ ? base_->solver : first_solver_);
        executed_ = 0;
        execute_log_of_this_tick();
    }
    const std::uint64_t affordable = rewind_bytes_ / dense_share / bytes_of_snapshot(world_);
    const std::uint64_t dense = std::min(affordable, most_dense_ticks);
    while (world_.tick() < tick) {
        if (tick - world_.tick() <= dense || world_.tick() % History::spacing == 0)
            history_.keep(world_, solver_.settings(), game_);
        if (!advance()) return false;
    }
    return true;
}

std::optional<Contact> Session::step_to_collision(std::uint64_t limit) {
    for (; limit > 0; --limit) {
        const std::vector<Pair> before = pairs_of(contacts_);
        if (!step_forward()) return std::nullopt;
        for (const Contact& contact : contacts_)
            if (!std::ranges::binary_search(before, pair_of(contact))) return contact;
    }
    return std::nullopt;
}

bool Session::undo() {
    if (executed_ == 0) return false;
    std::size_t first = executed_ - 1;
    while (first > 0 && continues_gesture(log_[first - 1].command, log_[first].command))
        --first;
    const std::uint64_t tick = log_[first].tick;
    log_.resize(first);
    history_.forget_from(tick);
    fingerprints_.forget_from(tick);
    latest_ = tick;
    restore(tick);
    return true;
}

void Session::restart() {
    log_.clear();
    log_.shrink_to_fit();
    history_.clear();
    fingerprints_ = FingerprintLog();
    base_.reset();
    latest_ = 0;
    first_solver_ = solver_.settings();
    history_.set_limit(rewind_bytes_, 0);
    restore(0);
}

std::size_t Session::rewind_bytes_used() const {
    return history_.bytes() + bytes_of(log_) +
           (base_ ? bytes_of_snapshot(base_->world) + bytes_of(base_->game) : 0);
}

}  // namespace carom
