#pragma once

#include <cstdint>
#include <vector>

#include "level/ir/context.h"

/// Names looked up, once the whole file is known: kinds, materials, and who meets whom.
namespace carom {

struct ResolvedEdges {
    ClassIndex material = 0;
    std::string name;  ///< empty: none
    Span name_at;
    bool is_valid = true;  ///< false: its material is not known, told already
};

struct ResolvedBalls {
    ClassIndex kind = 0;
    bool is_valid = true;
};

struct ResolvedNames {
    std::vector<ResolvedEdges> edges;     ///< by LevelIr::edge_bindings
    std::vector<ResolvedBalls> balls;     ///< by LevelIr::ball_bindings
    std::vector<ResolvedBalls> fills;     ///< by LevelIr::fills
    std::vector<ResolvedBalls> emitters;  ///< by LevelIr::emitters
    std::vector<Kind> kinds;
    std::vector<std::string> kind_names;
    std::vector<Material> materials;
    std::vector<std::string> material_names;
    std::vector<std::uint8_t> material_layers;  ///< by `materials`
    std::size_t layers = 1;                     ///< `kinds` has each kind once a layer
    /// As World::meets; empty: all meet.
    std::vector<std::uint8_t> meets;

    bool kinds_meet(ClassIndex a, ClassIndex b) const;
    bool kind_meets_material(ClassIndex kind, ClassIndex material) const;
    bool some_balls_meet() const;
    bool some_edges_meet() const;
    bool all_meet() const;
};

/// Reports unknown names, and warns of unused ones. The kind "ball" and the material "edge" stand
/// for those that the level does not name; they are there when they are used, or nothing else is.
ResolvedNames resolve_names(Context& context);

}  // namespace carom
