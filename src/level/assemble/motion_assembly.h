#pragma once

#include <cstdint>
#include <vector>

#include "level/assemble/resolve_names.h"
#include "level/scene/scene.h"

/// From the statements `motion` and `seesaw` to the movers and the seesaws of the world.
namespace carom {

class MotionAssembly {
  public:
    MotionAssembly(const ResolvedNames& names, Context& context)
        : names_(names), context_(context), ir_(context.ir) {}

    /// Reports motions that move nothing. Call before edges are amended: all edges of a motion may
    /// be removed in play.
    void check_names();

    /// Finds the edges of each motion, and puts them where its clock has them. Reports motions of
    /// what cannot move, or of what another one moves, and motions too fast for ticks of this rate.
    /// Pre: edges are amended.
    void place_edges(double rate);

    /// Sets World::movers and Scene::mover_names. Pre: placed without errors; the world has all
    /// capsules.
    void fill_in(Scene& scene) const;

  private:
    void check_name(const Word& name);
    void amend_clocks();
    void check_times(const MotionIr& motion, double rate);
    void place(std::uint32_t number, const Word& name);

    const ResolvedNames& names_;
    Context& context_;
    LevelIr& ir_;
    struct Moved {
        std::uint32_t motion = 0;
        std::uint32_t edge = 0;  ///< index into LevelIr::capsules
        Capsule home;
    };
    std::vector<Moved> moved_;
};

class SeesawAssembly {
  public:
    SeesawAssembly(const LoadOptions& options, const ResolvedNames& names, Context& context)
        : options_(options), names_(names), context_(context), ir_(context.ir) {}

    /// Reports seesaws of nothing. Call before edges are amended: all of them may be removed in
    /// play.
    void check_names();

    /// Finds the edge of each seesaw, and tilts it. Reports what cannot turn on a hinge. Pre: edges
    /// are amended, and the edges of motions are placed.
    void place_edges();

    /// Sets World::seesaws. Pre: placed without errors; the world has all capsules.
    void fill_in(World& world) const;

  private:
    void check_name(const Word& name);
    void check_terms();
    void amend_tilts();
    void check_angles(const SeesawIr& seesaw);
    void place(SeesawIr& seesaw);
    bool can_turn(const CapsuleIr& edge, std::size_t pieces, const Word& name);

    const LoadOptions& options_;
    const ResolvedNames& names_;
    Context& context_;
    LevelIr& ir_;
    struct Placed {
        std::uint32_t edge = 0;  ///< index into LevelIr::capsules
        Seesaw seesaw;           ///< without its capsule
    };
    std::vector<Placed> placed_;
};

}  // namespace carom
