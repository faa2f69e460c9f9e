#pragma once

#include <map>
#include <string>
#include <vector>

#include "level/assemble/resolve_names.h"
#include "level/scene/scene.h"

/// What stands on a pinball table: devices in groups, and the rules' names looked up.
namespace carom {

class PinballAssembly {
  public:
    /// Pre: the names are those of the context's draft.
    PinballAssembly(const ResolvedNames& names, Context& context)
        : names_(names), context_(context), ir_(context.ir) {}

    /// Reports what is wrong with groups and rules. `has_balls`: one starts on the table.
    void check(bool has_balls);

    /// Pre: checked, without errors; the scene's world has all capsules and zones. `world_zones`:
    /// by LevelIr::zones, the index into World::zones.
    void fill_in(Scene& scene, const std::vector<std::uint32_t>& world_zones);

  private:
    std::string name_of(const DeviceIr& device) const;
    void collect_devices();
    void collect_rules();
    void check_layers(const DeviceIr& ramp);
    bool resolve_rule(const RuleIr& spec);
    std::optional<std::uint32_t> group_named(const Word& name, bool may_be_edge);
    void check_game(bool has_balls);

    const ResolvedNames& names_;
    Context& context_;
    LevelIr& ir_;
    PinballTable table_;
    std::vector<int> device_of_spec_;  ///< by LevelIr::devices; -1: a twin
    std::map<std::string, std::uint32_t, std::less<>> groups_;
};

}  // namespace carom
