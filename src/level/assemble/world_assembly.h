#pragma once

#include <vector>

#include "level/assemble/amend.h"
#include "level/assemble/assemble.h"
#include "level/assemble/resolve_names.h"
#include "level/scene/scene.h"

/// From the checked level to the world, and to what the scene tells of the level as a whole.
namespace carom {

/// Ticks a second: the option's, else the level's, else the default of its game.
double level_rate(const LoadOptions& options, const LevelIr& ir);

class WorldAssembly {
  public:
    /// Pre: no errors; edges and `balls` are amended.
    WorldAssembly(const LoadOptions& options, const ResolvedNames& names,
                  const std::vector<StartingBall>& balls, const Amended& amended,
                  const Context& context)
        : options_(options),
          names_(names),
          balls_(balls),
          amended_(amended),
          context_(context),
          ir_(context.ir) {}

    /// Sets Scene::world with all balls, removed ones too, so that their numbers hold, and all
    /// edges and emitters; then names, outlines, the view, and what options override.
    void fill_in(Scene& scene) const;

  private:
    ClassIndex material_of(const CapsuleIr& edge) const;
    void make_model(Model& model) const;
    bool is_inelastic() const;
    void make_outlines(Scene& scene) const;
    Box view(const World& world) const;

    const LoadOptions& options_;
    const ResolvedNames& names_;
    const std::vector<StartingBall>& balls_;
    const Amended& amended_;
    const Context& context_;
    const LevelIr& ir_;
};

}  // namespace carom
