#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "game/rules/rules.h"
#include "game/shots/shots_state.h"
#include "level/scene/scene.h"
#include "physics/world/contact.h"
#include "physics/world/world.h"

/// Declarations shared by the files of this room.
namespace carom {

/// What the rules of a game of shots may ask.
class ShotsAnswers : public RuleHost {
  public:
    ShotsAnswers(const Scene& scene, const World& world, const ShotsState& state)
        : scene_(scene), world_(world), state_(state) {}

    std::uint64_t now() const override { return world_.tick(); }
    double rate() const override { return world_.rate(); }
    std::int64_t quantity(RuleQuantity what) const override;
    std::int64_t count(const RuleBalls& balls, const RulePlace* place) const override;
    std::pair<std::int64_t, std::int64_t> lights(std::uint32_t) const override { return {0, 0}; }
    bool moves(std::uint32_t mover) const override { return world_.movers()[mover].runs; }
    void act(const RuleAction&, std::int64_t, int) override {}

    /// Whether ball number `ball` is one of these; `it` is known too.
    bool is_meant(const RuleBalls& balls, std::uint32_t ball) const;
    /// Whether ball number `ball` is on the table and its centre in one of the place's zones.
    bool lies_in(const RulePlace& place, std::uint32_t ball) const;

  private:
    const Scene& scene_;
    const World& world_;
    const ShotsState& state_;
};

/// What the rules of a game of shots may ask and do.
class ShotsPlay final : public ShotsAnswers {
  public:
    ShotsPlay(const Scene& from, World& in, ShotsState& of)
        : ShotsAnswers(from, in, of), scene(from), world(in), state(of) {}

    void act(const RuleAction& action, std::int64_t value, int depth) override;
    Rules rules() { return {scene.rules, state.rules, *this}; }

    const Scene& scene;
    World& world;
    ShotsState& state;
};

/// Whether ball number `ball` is one of these. Pre: it is a ball of the scene.
bool is_among(const Scene& scene, const ShotsState& state, const RuleBalls& balls,
              std::uint32_t ball);
/// The number of a ball; none: it was added later.
std::optional<std::uint32_t> number_of(const ShotsState& state, BallId ball);
/// Puts a ball at the free place nearest to `place`, at rest.
void put(ShotsPlay& play, std::uint32_t ball, Vec2 place);
/// The place of ball number `ball` at the start.
Vec2 start_of(const Scene& scene, std::uint32_t ball);

/// Notes which balls touch edges and lie in places, at the start of a shot (shot_events.cpp).
void begin_shot_events(ShotsPlay& play);
/// Hands the events of a tick to the rules (shot_events.cpp).
void happen_in_tick(ShotsPlay& play, std::span<const Contact> contacts);

}  // namespace carom
