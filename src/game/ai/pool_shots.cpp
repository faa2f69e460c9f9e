#include "game/ai/pool_shots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "game/commands/aiming.h"
#include "geometry/impact.h"
#include "geometry/unit.h"

namespace carom {
namespace {

/// Cuts thinner than about 78 degrees are not proposed.
constexpr double least_cosine = 0.2;
/// The factor by which a bank or a kick is harder than its line: cushions are not perfect mirrors.
constexpr double cushion_factor = 0.25;

struct Cushion {
    bool is_upright = false;
    double at = 0.0;  ///< coordinate of the centre of a ball that touches it
};

std::array<Cushion, 4> cushions(const Box& cloth, double radius) {
    return {{{true, cloth.low.x + radius},
             {true, cloth.high.x - radius},
             {false, cloth.low.y + radius},
             {false, cloth.high.y - radius}}};
}

Vec2 mirrored(Vec2 place, const Cushion& cushion) {
    if (cushion.is_upright) return {2.0 * cushion.at - place.x, place.y};
    return {place.x, 2.0 * cushion.at - place.y};
}

// Where the line crosses the cushion; none if it does not cross it between the two points.
std::optional<Vec2> meeting(Vec2 from, Vec2 image, const Cushion& cushion) {
    const double start = cushion.is_upright ? from.x : from.y;
    const double end = cushion.is_upright ? image.x : image.y;
    const double share = (cushion.at - start) / (end - start);
    if (!(share > 0.0 && share < 1.0)) return std::nullopt;
    return from + (image - from) * share;
}

bool is_near_pocket(const Scene& scene, const Box& cloth, Vec2 place) {
    // Share of the table's width: near a pocket a cushion does not reflect.
    constexpr double berth = 0.09;
    for (std::size_t i = 0; i < scene.pool.pockets.size(); ++i)
        if (length(place - mouth(scene, cloth, static_cast<int>(i))) < berth * size(cloth).y)
            return true;
    return false;
}

struct Ball {
    BallId id{};
    Vec2 place;
    double radius = 0.0;
};

Ball ball_of(const World& world, BallId id) {
    const std::size_t i = *index_of(world, id);
    return {id, world.balls().position[i], world.balls().radius[i]};
}

// How straight a ball enters a pocket: the cosine of the angle to the pocket's axis.
double squareness(const Scene& scene, const Box& cloth, int pocket, Vec2 way) {
    const Vec2 place =
        scene.world.zones()[scene.pool.pockets[static_cast<std::size_t>(pocket)]].shape.start;
    const Vec2 axis = place - mouth(scene, cloth, pocket);
    return length(axis) > 0.0 ? dot(way, axis) / length(axis) : 1.0;
}

// The admissible error of the strike's angle: half a mouth of room at the pocket, divided by the
// path lengths that magnify the error.
double tolerance_of(double object_way, double cue_way, double cut_cosine, double squareness,
                    double radius) {
    const double spare = radius * squareness;
    return spare / std::max(object_way, radius) * cut_cosine * 2.0 * radius /
           std::max(cue_way, radius);
}

class Proposer {
  public:
    Proposer(const Scene& scene, const World& world, const Box& cloth, BallId struck, Vec2 from)
        : scene_(scene), world_(world), cloth_(cloth), cue_(ball_of(world, struck)) {
        cue_.place = from;
    }

    void propose(BallId object_id) {
        const Ball object = ball_of(world_, object_id);
        for (int pocket = 0; pocket < static_cast<int>(scene_.pool.pockets.size()); ++pocket) {
            const Vec2 target = mouth(scene_, cloth_, pocket);
            if (length(target - object.place) <= 0.0) continue;
            direct(object, pocket, target);
            for (const Cushion& cushion : cushions(cloth_, object.radius))
                bank(object, pocket, target, cushion);
        }
    }
    std::vector<PotLine> take() {
        std::ranges::sort(lines_, [](const PotLine& a, const PotLine& b) {
            return std::tuple(-a.tolerance, a.object, a.pocket, a.direction.x, a.direction.y) <
                   std::tuple(-b.tolerance, b.object, b.pocket, b.direction.x, b.direction.y);
        });
        return std::move(lines_);
    }

  private:
    void direct(const Ball& object, int pocket, Vec2 target) {
        const Vec2 way = unit(target - object.place);
        if (!is_clear(world_, object.place, target, object.radius, object.id, cue_.id)) return;
        const double square = squareness(scene_, cloth_, pocket, way);
        if (square < 0.35) return;
        add(PotLine::Way::direct, object, pocket, target, length(target - object.place), square);
        for (const Cushion& cushion : cushions(cloth_, cue_.radius))
            kick(object, pocket, target, square, cushion);
    }
    void bank(const Ball& object, int pocket, Vec2 target, const Cushion& cushion) {
        const Vec2 image = mirrored(target, cushion);
        const auto at = meeting(object.place, image, cushion);
        if (!at || is_near_pocket(scene_, cloth_, *at)) return;
        if (!is_clear(world_, object.place, *at, object.radius, object.id, cue_.id)) return;
        if (!is_clear(world_, *at, target, object.radius, object.id, cue_.id)) return;
        const double square = squareness(scene_, cloth_, pocket, unit(target - *at));
        if (square < 0.5) return;
        add(PotLine::Way::bank, object, pocket, *at, length(image - object.place),
            square * cushion_factor);
    }
    // The ball is sent towards `aim`.
    void add(PotLine::Way how, const Ball& object, int pocket, Vec2 aim, double object_way,
             double square) {
        const Vec2 ghost = ghost_place(object.place, object.radius, cue_.radius, aim);
        const Vec2 to_ghost = ghost - cue_.place;
        if (!(length(to_ghost) > 0.0)) return;
        const Vec2 way = unit(to_ghost);
        const double cosine = dot(way, unit(aim - object.place));
        if (cosine < least_cosine || !is_inside(ghost)) return;
        if (!is_clear(world_, cue_.place, ghost, cue_.radius, cue_.id, object.id)) return;
        lines_.push_back(
            {how, object.id, pocket, way, ghost, cosine, length(to_ghost) + object_way,
             tolerance_of(object_way, length(to_ghost), cosine, square, object.radius)});
    }
    void kick(const Ball& object, int pocket, Vec2 target, double square, const Cushion& cushion) {
        const Vec2 ghost = ghost_place(object.place, object.radius, cue_.radius, target);
        if (!is_inside(ghost)) return;
        const Vec2 image = mirrored(ghost, cushion);
        const auto at = meeting(cue_.place, image, cushion);
        if (!at || is_near_pocket(scene_, cloth_, *at)) return;
        const double cosine = dot(unit(ghost - *at), unit(target - object.place));
        if (cosine < least_cosine) return;
        if (!is_clear(world_, cue_.place, *at, cue_.radius, cue_.id, cue_.id)) return;
        if (!is_clear(world_, *at, ghost, cue_.radius, cue_.id, object.id)) return;
        const double cue_way = length(image - cue_.place);
        const double object_way = length(target - object.place);
        lines_.push_back(
            {PotLine::Way::kick, object.id, pocket, unit(image - cue_.place), ghost, cosine,
             cue_way + object_way,
             tolerance_of(object_way, cue_way, cosine, square * cushion_factor, object.radius)});
    }
    bool is_inside(Vec2 place) const {
        const Vec2 middle = center(cloth_);
        const Vec2 room = size(cloth_) * 0.5 - Vec2{cue_.radius, cue_.radius};
        return std::abs(place.x - middle.x) <= room.x && std::abs(place.y - middle.y) <= room.y;
    }

    const Scene& scene_;
    const World& world_;
    const Box& cloth_;
    Ball cue_;
    std::vector<PotLine> lines_;
};

}  // namespace

std::optional<Box> cloth_box(const Scene& scene) {
    if (scene.pool.pockets.empty() || scene.world.capsules().size() == 0) return std::nullopt;
    Box pockets{scene.world.zones()[scene.pool.pockets.front()].shape.start,
                scene.world.zones()[scene.pool.pockets.front()].shape.start};
    for (const std::uint32_t pocket : scene.pool.pockets) {
        const Vec2 place = scene.world.zones()[pocket].shape.start;
        pockets.low = {std::min(pockets.low.x, place.x), std::min(pockets.low.y, place.y)};
        pockets.high = {std::max(pockets.high.x, place.x), std::max(pockets.high.y, place.y)};
    }
    // For pockets that are neither at the middle of a side nor in a corner.
    const Vec2 from = center(pockets) + size(pockets) * 0.125;
    const auto reach = [&](Vec2 way) {
        double nearest = length(size(pockets));
        for (const Capsule& edge : scene.world.capsules().shape)
            if (const auto impact = first_impact(Disc{from, 0.0}, way, edge, nearest))
                nearest = impact->time;
        return nearest;
    };
    return Box{{from.x - reach({-1.0, 0.0}), from.y - reach({0.0, -1.0})},
               {from.x + reach({1.0, 0.0}), from.y + reach({0.0, 1.0})}};
}

Vec2 mouth(const Scene& scene, const Box& cloth, int pocket) {
    const Vec2 place =
        scene.world.zones()[scene.pool.pockets[static_cast<std::size_t>(pocket)]].shape.start;
    return {std::clamp(place.x, cloth.low.x, cloth.high.x),
            std::clamp(place.y, cloth.low.y, cloth.high.y)};
}

bool is_clear(const World& world, Vec2 from, Vec2 to, double radius, BallId one, BallId other) {
    const Disc disc{from, radius};
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        if (world.balls().id[i] == one || world.balls().id[i] == other) continue;
        const Disc ball{world.balls().position[i], world.balls().radius[i]};
        if (first_impact(disc, to - from, ball, 1.0)) return false;
    }
    return true;
}

std::vector<PotLine> pot_lines(const Scene& scene, const World& world, const Box& cloth,
                               BallId struck, Vec2 from, std::span<const BallId> objects) {
    Proposer proposer(scene, world, cloth, struck, from);
    for (const BallId object : objects)
        proposer.propose(object);
    return proposer.take();
}

std::vector<Vec2> hit_directions(const Scene& scene, const World& world, const Box& cloth,
                                 BallId struck, Vec2 from, BallId object) {
    const Ball cue = ball_of(world, struck);
    const Ball other = ball_of(world, object);
    const Vec2 apart = other.place - from;
    const double reach = cue.radius + other.radius;
    std::vector<Vec2> directions;
    for (const double offset : {0.0, 0.5, -0.5, 0.85, -0.85}) {
        const Vec2 ghost = other.place + perpendicular(unit(apart)) * (offset * reach) -
                           unit(apart) * (reach * std::sqrt(1.0 - offset * offset));
        if (length(ghost - from) > 0.0 && is_clear(world, from, ghost, cue.radius, struck, object))
            directions.push_back(unit(ghost - from));
    }
    if (!directions.empty()) return directions;
    for (const Cushion& cushion : cushions(cloth, cue.radius)) {
        const Vec2 image = mirrored(other.place, cushion);
        const auto at = meeting(from, image, cushion);
        if (!at || is_near_pocket(scene, cloth, *at)) continue;
        if (!is_clear(world, from, *at, cue.radius, struck, struck)) continue;
        if (!is_clear(world, *at, other.place, cue.radius, struck, object)) continue;
        directions.push_back(unit(image - from));
    }
    return directions;
}

}  // namespace carom
