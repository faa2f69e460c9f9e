#pragma once

#include <cstdint>
#include <vector>

#include "level/ir/context.h"

/// Resolves the names of kinds and materials, once the whole file is read, and which of them
/// collide.
namespace carom {

struct ResolvedEdges {
    ClassIndex material = 0;
    std::string name;  ///< empty: the edges have none
    Span name_at;
    bool is_valid = true;  ///< false: its material is unknown, which is reported
};

struct ResolvedBalls {
    ClassIndex kind = 0;
    bool is_valid = true;
};

struct ResolvedNames {
    std::vector<ResolvedEdges> edges;     ///< for each of LevelIr::edge_bindings
    std::vector<ResolvedBalls> balls;     ///< for each of LevelIr::ball_bindings
    std::vector<ResolvedBalls> fills;     ///< for each of LevelIr::fills
    std::vector<ResolvedBalls> emitters;  ///< for each of LevelIr::emitters
    std::vector<Kind> kinds;
    std::vector<std::string> kind_names;
    std::vector<Material> materials;
    std::vector<std::string> material_names;
    std::vector<std::uint8_t> material_layers;  ///< for each of `materials`
    std::size_t layers = 1;                     ///< `kinds` has each kind once for each layer
    /// The collision matrix of kinds and materials, like World::meets; empty: all collide.
    std::vector<std::uint8_t> collision_matrix;

    bool kinds_collide(ClassIndex a, ClassIndex b) const;
    bool kind_collides_with(ClassIndex kind, ClassIndex material) const;
    bool some_balls_collide() const;
    bool some_edges_collide() const;
    bool all_collide() const;
};

/// Reports unknown names, and warns of unused ones. Balls without a kind have the kind "ball", and
/// edges without a material the material "edge"; each is there if it is used, or if the level
/// declares no other.
ResolvedNames resolve_names(Context& context);

}  // namespace carom
