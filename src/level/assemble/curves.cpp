#include "level/assemble/curves.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "physics/laws/curve.h"

namespace carom {
namespace {

// An end of an edge.
struct End {
    Vec2 point;
    std::uint32_t edge = 0;    // index
    std::uint32_t number = 0;  // 0: its start
};

// The sine of the turn where two edges meet.
double turn_at(const Capsule& one, const Capsule& other) {
    const Vec2 own = one.end - one.start;
    const Vec2 theirs = other.end - other.start;
    return std::abs(cross(own, theirs)) / (length(own) * length(theirs));
}

class Joiner {
  public:
    Joiner(const LevelIr& ir, World& world)
        : ir_(ir), world_(world), joints_(ir.capsules.size(), {no_joint, no_joint}) {}

    void run() {
        find_ends();
        for_each_meeting([&](const End& a, const End& b) {
            if (is_smooth(a) && ir_.capsules[a.edge].chain == ir_.capsules[b.edge].chain)
                join(a, b);
        });
        const std::vector<Joints> within = joints_;
        for_each_meeting([&](const End& a, const End& b) {
            if (ir_.capsules[a.edge].chain == ir_.capsules[b.edge].chain) return;
            const double most = std::max(turn_beyond(a, within), turn_beyond(b, within));
            // Equal to the turn within an arc of equal pieces, up to rounding.
            constexpr double hair = 1e-6;
            if (turn_at(shape(a), shape(b)) <= most * (1.0 + hair)) join(a, b);
        });
        for (std::size_t i = 0; i < joints_.size(); ++i)
            if (joints_[i] != Joints{no_joint, no_joint})
                set_joints(world_, world_.capsules().id[i], joints_[i]);
    }

  private:
    const Capsule& shape(const End& end) const { return world_.capsules().shape[end.edge]; }
    bool is_smooth(const End& end) const {
        return ir_.chains[static_cast<std::size_t>(ir_.capsules[end.edge].chain)].is_smooth;
    }

    void find_ends() {
        for (std::uint32_t i = 0; i < ir_.capsules.size(); ++i) {
            const Capsule& edge = world_.capsules().shape[i];
            if (edge.start == edge.end || ir_.capsules[i].is_moved) continue;
            ends_.push_back({edge.start, i, 0});
            ends_.push_back({edge.end, i, 1});
        }
        std::ranges::sort(ends_, {}, [](const End& end) {
            return std::tuple(end.point.x, end.point.y, end.edge, end.number);
        });
    }

    // Calls visit(a, b) for each two ends that are in the same point, with no third one.
    template <typename Visit>
    void for_each_meeting(Visit&& visit) const {
        for (std::size_t first = 0; first < ends_.size();) {
            std::size_t behind = first + 1;
            while (behind < ends_.size() && ends_[behind].point == ends_[first].point)
                ++behind;
            if (behind - first == 2) visit(ends_[first], ends_[first + 1]);
            first = behind;
        }
    }

    void join(const End& a, const End& b) {
        if (!can_join(shape(a), shape(b), a.point)) return;
        joints_[a.edge][a.number] = world_.capsules().id[b.edge];
        joints_[b.edge][b.number] = world_.capsules().id[a.edge];
    }

    // The turn of a smooth chain at the other end of its piece; 0 if it has none.
    double turn_beyond(const End& end, const std::vector<Joints>& within) const {
        const CapsuleId next = within[end.edge][1 - end.number];
        if (!is_smooth(end) || next == no_joint) return 0.0;
        return turn_at(shape(end), world_.capsules().shape[*index_of(world_, next)]);
    }

    const LevelIr& ir_;
    World& world_;
    std::vector<Joints> joints_;  // by edge
    std::vector<End> ends_;       // by place
};

}  // namespace

void join_curves(const LevelIr& ir, World& world) {
    if (std::ranges::any_of(ir.chains, &ChainIr::is_smooth)) Joiner(ir, world).run();
}

}  // namespace carom
