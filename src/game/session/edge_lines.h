#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "level/scene/scene.h"
#include "physics/world/world.h"

/// Which edges of a world a level states in one line, when it is saved.
namespace carom {

/// Edges that are alike, each of which begins where the one before ends.
struct EdgeLine {
    std::size_t first = 0;  ///< index of a capsule
    std::size_t last = 0;
    bool is_smooth = false;
    bool closes = false;  ///< the loader adds the last edge, back to the start
};

/// All edges, in their order. Read back, each line gives its edges and their joints again.
std::vector<EdgeLine> edge_lines(const Scene& scene, const World& world);

// What an edge has of its own, besides its material. `i`: index of a capsule.
std::optional<Rgb24> color_of_edge(const Scene& scene, const World& world, std::size_t i);
Side side_of_edge(const World& world, std::size_t i);
/// Empty: it belongs to no group.
std::string_view group_of_edge(const Scene& scene, CapsuleId id);

}  // namespace carom
