#include "level/fill/fill.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/closest.h"
#include "geometry/elementary.h"
#include "level/fill/hierarchical_grid.h"
#include "level/fill/lattice.h"
#include "level/ir/numbers.h"
#include "physics/world/random.h"

namespace carom {
namespace {

constexpr std::uint32_t attempts = 300;

// Operations of a LoadBudget.
constexpr std::uint64_t cost_of_a_ball = 20;       // its random sizes and velocity
constexpr std::uint64_t cost_of_a_try = 3;         // of a random place
constexpr std::uint64_t cost_of_a_site = 3;        // of a lattice
constexpr std::uint64_t cost_of_a_look = 3;        // at a node of the obstacles: far in memory
constexpr std::uint64_t cost_of_an_obstacle = 20;  // near the box
constexpr std::uint64_t far_obstacles_for_one = 8;

// The purpose of a random number; each purpose has a stream of its own.
enum class Purpose : std::uint64_t { mass = 1, radius, place, shift, direction, speed, gaussian };

class FillRandom {
  public:
    FillRandom(std::uint64_t seed, int fill)
        : seed_(seed), fill_(static_cast<std::uint64_t>(fill)) {}

    /// Uniform in [0, 1): number `draw` of this purpose for a ball.
    double unit(Purpose purpose, std::uint64_t ball, std::uint64_t draw = 0) const {
        return random_unit(seed_, RandomStream::fill,
                           fill_ << 8 | static_cast<std::uint64_t>(purpose), ball << 24 | draw);
    }
    double between(double low, double high, Purpose purpose, std::uint64_t ball,
                   std::uint64_t draw = 0) const {
        return low + (high - low) * unit(purpose, ball, draw);
    }

  private:
    std::uint64_t seed_;
    std::uint64_t fill_;
};

// A random unit vector: a point of the disc, by rejection sampling, normalised.
Vec2 random_direction(const FillRandom& chance, std::uint64_t ball) {
    for (std::uint64_t draw = 0;; draw += 2) {
        const Vec2 v{2.0 * chance.unit(Purpose::direction, ball, draw) - 1.0,
                     2.0 * chance.unit(Purpose::direction, ball, draw + 1) - 1.0};
        const double square = length_squared(v);
        if (square <= 1.0 && square > 0.01) return v / std::sqrt(square);
    }
}

// A standard Gaussian truncated at -8 and 8, by rejection sampling.
double gaussian(const FillRandom& chance, std::uint64_t ball, std::uint64_t component) {
    for (std::uint64_t draw = component;; draw += 4) {
        const double x = 16.0 * chance.unit(Purpose::gaussian, ball, draw) - 8.0;
        const double y = chance.unit(Purpose::gaussian, ball, draw + 2);
        if (y < exponential(-0.5 * x * x)) return x;
    }
}

bool draw_sizes(const FillIr& fill, const FillDefaults& defaults, const FillRandom& chance,
                std::vector<FilledBall>& balls, Context& context) {
    Scope scope = fill.scope;
    for (std::uint32_t i = 0; i < fill.count; ++i) {
        FilledBall& ball = balls[i];
        const double mass = chance.between(fill.least_mass, fill.most_mass, Purpose::mass, i);
        if (fill.radius_of_mass) {
            scope.names["m"].value = Value{mass, {}};
            const auto range = read_range(*fill.radius_of_mass, {"r"}, Measure::length,
                                          Bound::positive, scope, context);
            if (!range) return false;
            ball.radius = chance.between(range->first, range->second, Purpose::radius, i);
        } else if (fill.least_radius > 0.0) {
            ball.radius = chance.between(fill.least_radius, fill.most_radius, Purpose::radius, i);
        } else {
            ball.radius = defaults.radius;
        }
        const double area = pi * ball.radius * ball.radius;
        if (fill.most_mass > 0.0) {
            ball.mass = mass;
        } else if (fill.density) {
            ball.mass = *fill.density * area;
        } else {
            ball.mass = defaults.mass.value_or(defaults.density * area);
        }
    }
    return true;
}

void draw_velocities(const FillIr& fill, const FillRandom& chance, std::vector<FilledBall>& balls) {
    if (fill.rms_speed > 0.0) {
        double squares = 0.0;
        for (std::uint32_t i = 0; i < fill.count; ++i) {
            balls[i].velocity = {gaussian(chance, i, 0), gaussian(chance, i, 1)};
            squares += length_squared(balls[i].velocity);
        }
        const double factor = fill.rms_speed / std::sqrt(squares / fill.count);
        for (FilledBall& ball : balls)
            ball.velocity *= factor;
        return;
    }
    for (std::uint32_t i = 0; i < fill.count; ++i) {
        balls[i].velocity = fill.velocity;
        if (fill.most_speed <= 0.0) continue;
        const double speed = chance.between(fill.least_speed, fill.most_speed, Purpose::speed, i);
        balls[i].velocity += random_direction(chance, i) * speed;
    }
}

class FillPlacer {
  public:
    FillPlacer(const FillIr& fill, const Obstacles& obstacles, const FillRandom& chance,
               std::vector<FilledBall>& balls, LoadBudget& work)
        : fill_(fill),
          random_(chance),
          balls_(balls),
          work_(work),
          keeps_apart_(obstacles.each_other),
          tree_(boxes_near(obstacles, fill.box)) {
        // The tree holds the obstacles that overlap the box: first the discs, then the capsules.
        for (const Disc& disc : obstacles.discs) {
            if (overlaps(bounds(disc), fill.box)) near_discs_.push_back(disc);
        }
        for (const Capsule& capsule : obstacles.capsules) {
            if (overlaps(bounds(capsule), fill.box)) near_capsules_.push_back(capsule);
        }
        work_.spend((obstacles.discs.size() + obstacles.capsules.size()) / far_obstacles_for_one +
                    cost_of_an_obstacle * (near_discs_.size() + near_capsules_.size()));
    }

    /// Places all balls at random, else on a lattice. Returns how many were placed.
    std::uint32_t place() {
        const std::uint32_t placed = at_random();
        return placed == fill_.count ? placed : std::max(placed, on_lattice());
    }

  private:
    /// Returns the number of balls placed before one found no room.
    std::uint32_t at_random() {
        std::vector<std::uint32_t> order(balls_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::stable_sort(order, std::ranges::greater{},
                                 [&](std::uint32_t i) { return balls_[i].radius; });
        std::vector<double> radii;
        for (const std::uint32_t i : order)
            radii.push_back(balls_[i].radius);
        HierarchicalGrid grid(fill_.box, radii);
        const std::uint64_t least_left = work_.left() / 2;
        std::uint32_t placed = 0;
        for (const std::uint32_t i : order) {
            if (!find_place(i, grid, least_left)) return placed;
            if (keeps_apart_) grid.add({balls_[i].position, balls_[i].radius});
            ++placed;
        }
        return placed;
    }

    /// Places all balls on a lattice, or returns the number of sites of the densest lattice.
    std::uint32_t on_lattice() {
        double largest = 0.0;
        for (const FilledBall& ball : balls_)
            largest = std::max(largest, ball.radius);
        const auto is_open = [&](Vec2 site) {
            work_.spend(cost_of_a_site);
            return is_free({site, largest});
        };
        const Lattice lattice = widest_lattice(fill_.box, largest, fill_.count, is_open);
        if (lattice.sites.size() < fill_.count) {
            return static_cast<std::uint32_t>(lattice.sites.size());
        }
        std::vector<Vec2> sites = lattice.sites;
        for (std::uint32_t i = 0; i < fill_.count; ++i) {
            const double share = random_.unit(Purpose::place, i, attempts * 2);
            const auto k =
                i + static_cast<std::size_t>(share * static_cast<double>(sites.size() - i));
            std::swap(sites[i], sites[k]);
            balls_[i].position = shifted(sites[i], balls_[i].radius, lattice.pitch, i);
        }
        return fill_.count;
    }

    static std::vector<Box> boxes_near(const Obstacles& obstacles, const Box& box) {
        std::vector<Box> boxes;
        for (const Disc& disc : obstacles.discs) {
            if (overlaps(bounds(disc), box)) boxes.push_back(bounds(disc));
        }
        for (const Capsule& capsule : obstacles.capsules) {
            if (overlaps(bounds(capsule), box)) boxes.push_back(bounds(capsule));
        }
        return boxes;
    }

    bool is_free(const Disc& disc) {
        bool is_free = true;
        std::uint64_t looks = 0;
        looks += tree_.query(bounds(disc), [&](std::uint32_t i) {
            ++looks;
            is_free = i < near_discs_.size()
                          ? separation(disc, near_discs_[i]) >= 0.0
                          : separation(disc, near_capsules_[i - near_discs_.size()]) >= 0.0;
            return is_free;
        });
        work_.spend(cost_of_a_look * looks);
        return is_free;
    }

    bool find_place(std::uint32_t i, const HierarchicalGrid& grid, std::uint64_t least_left) {
        FilledBall& ball = balls_[i];
        const Box room = grow(fill_.box, -ball.radius);
        if (room.low.x > room.high.x || room.low.y > room.high.y) return false;
        for (std::uint32_t attempt = 0; attempt < attempts; ++attempt) {
            ball.position = {
                random_.between(room.low.x, room.high.x, Purpose::place, i, 2 * attempt),
                random_.between(room.low.y, room.high.y, Purpose::place, i, 2 * attempt + 1)};
            const Disc disc{ball.position, ball.radius};
            std::uint64_t looks = 0;
            const bool is_place = !grid.touches(disc, looks) && is_free(disc);
            work_.spend(cost_of_a_try + looks);
            if (is_place) return true;
            if (work_.left() < least_left) return false;
        }
        return false;
    }

    // A random position around the site, within its cell and the box; the site itself if that
    // position is not free.
    Vec2 shifted(Vec2 site, double radius, double pitch, std::uint32_t i) {
        const double room =
            (0.5 * pitch - radius) * 0.7;  // a square inside the circle of that radius
        if (room <= 0.0) return site;
        const Vec2 place = site + Vec2{random_.between(-room, room, Purpose::shift, i, 0),
                                       random_.between(-room, room, Purpose::shift, i, 1)};
        const Box inside = grow(fill_.box, -radius);
        return contains(inside, place) && is_free({place, radius}) ? place : site;
    }

    const FillIr& fill_;
    const FillRandom& random_;
    std::vector<FilledBall>& balls_;
    LoadBudget& work_;
    bool keeps_apart_;
    BoxTree tree_;
    std::vector<Disc> near_discs_;
    std::vector<Capsule> near_capsules_;
};

}  // namespace

std::optional<std::vector<FilledBall>> place_fill(const FillIr& fill, const FillDefaults& defaults,
                                                  const FillObstacles& obstacles,
                                                  Context& context) {
    context.work.begin(fill.origin.span());
    context.work.earn(fill.count);
    context.work.spend(fill.count * cost_of_a_ball);
    const FillRandom chance(context.seed, fill.number);
    std::vector<FilledBall> balls(fill.count);
    if (!draw_sizes(fill, defaults, chance, balls, context)) return std::nullopt;
    draw_velocities(fill, chance, balls);
    const auto place_among = [&](const Obstacles& among) {
        return FillPlacer(fill, among, chance, balls, context.work).place();
    };
    std::uint32_t placed = place_among(obstacles.all);
    if (placed < fill.count && obstacles.solid) {
        placed = place_among(obstacles.solid());
    }
    if (placed == fill.count) return balls;
    context.reporter.error(
        "fill-does-not-fit", fill.origin.span(),
        fmt::format("the box has room for only {} of {} balls", placed, fill.count),
        "make the box larger, or the balls smaller or fewer");
    return std::nullopt;
}

}  // namespace carom
