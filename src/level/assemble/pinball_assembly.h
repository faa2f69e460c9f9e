#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "level/assemble/assemble.h"
#include "level/assemble/resolve_names.h"
#include "level/scene/scene.h"

/// Assembles a pinball table: groups its devices by name.
namespace carom {

class PinballAssembly {
  public:
    /// Pre: `names` resolves the names of the context.
    PinballAssembly(const ResolvedNames& names, Context& context)
        : names_(names), context_(context), ir_(context.ir) {}

    /// Groups the devices, and reports errors in the groups.
    void collect_devices();
    /// Reports what a game of pinball lacks.
    void check(const std::vector<StartingBall>& balls);

    /// The group of devices with this name, or that of one of them (lanes.2); if `may_be_edge`, the
    /// edges of that name become one device. None: there is no such name, which is reported.
    std::optional<std::uint32_t> group_named(const Word& name, bool may_be_edge);
    DeviceKind kind_of(std::uint32_t group) const { return table_.groups[group].kind; }
    /// Whether each of the group's holes keeps its ball.
    bool keeps_balls(std::uint32_t group) const;
    bool is_one_of_group(std::uint32_t group) const {
        const std::vector<std::uint32_t>& members = table_.groups[group].devices;
        return members.size() == 1 &&
               table_.devices[members.front()].own_group == static_cast<std::int32_t>(group);
    }
    const std::vector<Device>& devices() const { return table_.devices; }
    /// Index into devices() of one of LevelIr::devices; -1: a mirror duplicate.
    int device_of(std::size_t spec) const { return scene_device_[spec]; }
    bool has_device(std::uint32_t group, int device) const {
        return std::ranges::count(table_.groups[group].devices,
                                  static_cast<std::uint32_t>(device)) > 0;
    }

    /// Sets Scene::table and World::flippers. `world_zones` has the index into World::zones for
    /// each of LevelIr::zones. Pre: checked without errors; the world has all capsules and zones.
    void fill_in(const std::vector<StartingBall>& balls, Scene& scene,
                 const std::vector<std::uint32_t>& world_zones);

  private:
    std::string name_of(const DeviceIr& device) const;
    std::optional<std::uint32_t> one_of_group(std::string_view name);
    void check_layers(const DeviceIr& ramp);
    /// Index into LevelIr::devices; -1: the ball is not captive.
    int captive_device(const StartingBall& ball) const;
    void fill_in_edges(Scene& scene);
    void fill_in_captives(const std::vector<StartingBall>& balls, Scene& scene);

    const ResolvedNames& names_;
    Context& context_;
    LevelIr& ir_;
    PinballTable table_;
    std::vector<DeviceDress> looks_;  ///< for each of the table's devices
    std::vector<int> scene_device_;   ///< for each of LevelIr::devices; -1: a duplicate
    std::map<std::string, std::uint32_t, std::less<>> groups_;
};

}  // namespace carom
