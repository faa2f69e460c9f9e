#include "lab/run/escape.h"

#include <algorithm>
#include <optional>

#include "lab/observe/region.h"

namespace carom {

EscapeWatch::EscapeWatch(const Scene& scene) {
    const Capsules& capsules = scene.world.capsules();
    for (const std::vector<CapsuleId>& ids : scene.outlines) {
        Outline outline;
        for (const CapsuleId id : ids) {
            const std::optional<std::size_t> index = index_of(scene.world, id);
            if (!index) continue;
            const Capsule& shape = capsules.shape[*index];
            const Capsule thin{shape.start, shape.end, 0.0};
            const Box spine = carom::bounds(thin);
            outline.bounds = outline.spines.empty() ? spine : join(outline.bounds, spine);
            outline.spines.push_back(thin);
        }
        outlines_.push_back(std::move(outline));
    }
    note_births(scene.world);
}

bool EscapeWatch::Outline::contains(Vec2 point) const {
    return !spines.empty() && carom::contains(bounds, point) && is_inside(spines, point);
}

bool EscapeWatch::Outline::contains(const World& world, Vec2 point) const {
    if (!world.model().wrap) return contains(point);
    const Vec2 torus = size(*world.model().wrap);
    for (int across = -1; across <= 1; ++across)
        for (int along = -1; along <= 1; ++along)
            if (contains(point + Vec2{across * torus.x, along * torus.y})) return true;
    return false;
}

void EscapeWatch::note_births(const World& world) {
    if (outlines_.empty() || start_outlines_.size() == world.next_ball()) return;
    const std::size_t known = start_outlines_.size();
    start_outlines_.resize(world.next_ball());
    for (std::size_t i = world.balls().size(); i-- > 0 && number(world.balls().id[i]) >= known;) {
        for (std::uint32_t outline = 0; outline < outlines_.size(); ++outline) {
            if (!outlines_[outline].contains(world, world.balls().position[i])) continue;
            start_outlines_[number(world.balls().id[i])].push_back(outline);
        }
    }
}

std::size_t EscapeWatch::escaped(const World& world) const {
    if (outlines_.empty()) return 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const std::vector<std::uint32_t>& home = start_outlines_[number(world.balls().id[i])];
        const bool is_out = std::ranges::any_of(home, [&](std::uint32_t outline) {
            return !outlines_[outline].contains(world, world.balls().position[i]);
        });
        if (is_out) ++count;
    }
    return count;
}

}  // namespace carom
