#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "level/assemble/assemble.h"
#include "level/assemble/futile_rules.h"
#include "level/assemble/pinball_assembly.h"
#include "level/assemble/resolve_names.h"
#include "level/scene/scene.h"

/// Resolves the names in the rules of a level (scene/rules.h), and warns of rules that are no use.
namespace carom {

class RuleAssembly {
  public:
    /// Pre: the devices of `table` are collected.
    RuleAssembly(PinballAssembly& table, const ResolvedNames& names,
                 const std::vector<StartingBall>& balls, Context& context)
        : table_(table), names_(names), balls_(balls), context_(context), ir_(context.ir) {}

    /// Reports errors in rules, and warns of what cannot happen, is not read, or does not end.
    void check();

    /// Sets Scene::rules. Pre: checked without errors; the world has all balls, capsules and zones;
    /// `world_zones` has the index into World::zones for each of LevelIr::zones.
    void fill_in(Scene& scene, const std::vector<std::uint32_t>& world_zones);

  private:
    using Role = RuleNameIr::Role;

    bool is_pinball() const { return ir_.settings.table.is_game; }
    bool has_game() const { return is_pinball() || ir_.settings.is_shots; }
    std::nullopt_t refuse(FaultCode code, const Word& at, std::string message, std::string remedy);

    // rule_assembly.cpp: rules; rule_names.cpp: events of balls, by what their names denote
    void resolve_rule(RuleIr& spec);
    bool resolve_subject(RuleIr& spec);
    bool resolve_moment(const RuleIr& spec);
    bool resolve_device_event(RuleIr& spec);
    bool resolve_ball_event(RuleIr& spec);
    bool resolve_meeting(RuleIr& spec);
    bool resolve_visit(RuleIr& spec);
    bool check_actions(const RuleIr& spec);
    bool check_placement();
    void resolve_goals();
    bool check_it(const std::vector<RuleNameIr>& names, const Rule* rule);

    // rule_names.cpp: what names denote
    std::optional<std::vector<std::uint32_t>> resolve(const std::vector<RuleNameIr>& names);
    std::optional<std::uint32_t> meaning_of(const RuleNameIr& name);
    std::optional<std::uint32_t> lights_named(const Word& name, Role role);
    std::optional<std::uint32_t> opening_named(const Word& name);
    std::optional<std::uint32_t> holder_named(const Word& name);
    std::optional<std::uint32_t> shot_named(const Word& name);
    std::optional<std::uint32_t> balls_named(const Word& name);
    std::optional<std::uint32_t> find_balls(std::string_view name);
    std::optional<std::uint32_t> find_place(std::string_view name);
    std::optional<std::uint32_t> place_named(const Word& name, bool is_edge);
    bool is_ball(std::string_view name) const;
    bool has_error(std::string_view name) const;
    std::vector<std::string_view> known_names() const;
    bool has_zones(std::uint32_t place) const { return !places_[place].zones.empty(); }

    // rule_checks.cpp: warnings
    void check_symbols();
    void check_motions();
    void check_game();
    void check_devices();
    void check_use_of_devices();
    void check_events();
    RuleFacts facts();
    bool has_action(std::initializer_list<RuleAction::What> wanted) const;
    bool has_action(RuleAction::What wanted, std::uint32_t index) const;

    /// Before the world exists: balls and zones by their indices in the IR.
    struct BallsIr {
        RuleBalls::Who who = RuleBalls::Who::listed;
        std::vector<std::uint32_t> balls;  ///< indices into `balls_`
        std::int32_t kind = -1;            ///< RuleBalls::kind
    };
    struct PlaceIr {
        std::string name;
        std::vector<std::uint32_t> zones;     ///< indices into LevelIr::zones
        std::vector<std::uint32_t> capsules;  ///< indices into LevelIr::capsules
    };

    PinballAssembly& table_;
    const ResolvedNames& names_;
    const std::vector<StartingBall>& balls_;
    Context& context_;
    LevelIr& ir_;
    RuleBook book_;
    std::vector<BallsIr> ball_sets_;
    std::map<std::string, std::uint32_t, std::less<>> ball_sets_index_;
    std::vector<PlaceIr> places_;
    std::map<std::string, std::uint32_t, std::less<>> places_index_;
};

}  // namespace carom
