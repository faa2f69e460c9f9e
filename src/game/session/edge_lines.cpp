#include "game/session/edge_lines.h"

#include <algorithm>
#include <span>

#include "physics/laws/curve.h"

namespace carom {
namespace {

class LineFinder {
  public:
    LineFinder(const Scene& scene, const World& world)
        : scene_(scene), world_(world), capsules_(world.capsules()) {}

    std::vector<EdgeLine> find() const {
        std::vector<EdgeLine> lines;
        for (std::size_t first = 0; first < capsules_.size();) {
            const bool is_smooth = is_curved(first);
            std::size_t last = first;
            while (continues(last) && !ends_outline(first, last) &&
                   is_curved(last + 1) == is_smooth && keeps_joint(last, last + 1, is_smooth))
                ++last;
            const bool closes = is_outline(first, last) && keeps_joint(last, first, is_smooth);
            lines.push_back({first, last, is_smooth, closes});
            first = last + 1;
        }
        return lines;
    }

  private:
    /// Whether capsule i continues smoothly in `next`.
    bool is_joined(std::size_t i, std::size_t next) const {
        return !capsules_.joints.empty() && capsules_.joints[i][1] == capsules_.id[next];
    }

    /// Whether capsule i has smooth joints that only a smooth line gives it.
    bool is_curved(std::size_t i) const {
        return (continues(i) && is_joined(i, i + 1)) ||
               (i > 0 && continues(i - 1) && is_joined(i - 1, i));
    }

    /// Whether the loader makes the joint of the two smooth or not as it is now, if the line that
    /// they are in is smooth or not.
    bool keeps_joint(std::size_t i, std::size_t next, bool is_smooth) const {
        const Capsule& shape = capsules_.shape[i];
        const bool becomes_one = is_smooth && can_join(shape, capsules_.shape[next], shape.end);
        return becomes_one == is_joined(i, next);
    }

    /// Whether capsule i + 1 continues where capsule i ends, as one line.
    bool continues(std::size_t i) const {
        if (i + 1 >= capsules_.size()) return false;
        const Capsule& a = capsules_.shape[i];
        const Capsule& b = capsules_.shape[i + 1];
        return a.end == b.start && !(a.start == a.end) && !(b.start == b.end) &&
               a.radius == b.radius && capsules_.material[i] == capsules_.material[i + 1] &&
               side_of_edge(world_, i) == side_of_edge(world_, i + 1) &&
               color_of_edge(scene_, world_, i) == color_of_edge(scene_, world_, i + 1) &&
               group_of_edge(scene_, capsules_.id[i]) == group_of_edge(scene_, capsules_.id[i + 1]);
    }

    bool is_outline(std::size_t first, std::size_t last) const {
        if (last - first < 2 || !ends_outline(first, last)) return false;
        return std::ranges::any_of(scene_.outlines, [&](const std::vector<CapsuleId>& outline) {
            return std::ranges::equal(outline,
                                      std::span(capsules_.id).subspan(first, last - first + 1));
        });
    }

    bool ends_outline(std::size_t first, std::size_t last) const {
        return capsules_.shape[first].start == capsules_.shape[last].end;
    }

    const Scene& scene_;
    const World& world_;
    const Capsules& capsules_;
};

}  // namespace

std::vector<EdgeLine> edge_lines(const Scene& scene, const World& world) {
    return LineFinder(scene, world).find();
}

std::optional<Rgb24> color_of_edge(const Scene& scene, const World& world, std::size_t i) {
    return color_in(scene.dress.edges, number(world.capsules().id[i]));
}

Side side_of_edge(const World& world, std::size_t i) {
    return world.capsules().side.empty() ? Side::both : world.capsules().side[i];
}

std::string_view group_of_edge(const Scene& scene, CapsuleId id) {
    for (const Group& group : scene.groups)
        if (std::ranges::binary_search(group.capsules, id)) return group.name;
    return {};
}

}  // namespace carom
