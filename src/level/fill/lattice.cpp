#include "level/fill/lattice.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr double half_sqrt_3 = 0.86602540378443865;

// The number of sites along a length, the first and the last `radius` from its ends. Rounding must
// not cost a site: 10 discs of radius 1 fit on a length of 20.
double sites_along(double length, double radius, double pitch) {
    const double room = length - 2.0 * radius;
    return room < 0.0 ? 0.0 : std::floor(room / pitch * (1.0 + 1e-12)) + 1.0;
}

double row_pitch(bool is_hexagonal, double pitch) {
    return is_hexagonal ? half_sqrt_3 * pitch : pitch;
}

double site_count(const Box& box, double radius, double pitch, bool is_hexagonal) {
    const double rows = sites_along(size(box).y, radius, row_pitch(is_hexagonal, pitch));
    const double even = sites_along(size(box).x, radius, pitch);
    if (!is_hexagonal) return rows * even;
    const double odd = sites_along(size(box).x - 0.5 * pitch, radius, pitch);
    return std::ceil(0.5 * rows) * even + std::floor(0.5 * rows) * odd;
}

std::vector<Vec2> make_sites(const Box& box, double radius, double pitch, bool is_hexagonal,
                             const std::function<bool(Vec2)>& is_open) {
    std::vector<Vec2> sites;
    const double rows = sites_along(size(box).y, radius, row_pitch(is_hexagonal, pitch));
    for (double r = 0.0; r < rows; r += 1.0) {
        const bool is_shifted = is_hexagonal && std::floor(0.5 * r) != 0.5 * r;
        const double shift = is_shifted ? 0.5 * pitch : 0.0;
        const double columns = sites_along(size(box).x - shift, radius, pitch);
        for (double c = 0.0; c < columns; c += 1.0) {
            const Vec2 site{std::min(box.low.x + radius + shift + c * pitch, box.high.x - radius),
                            std::min(box.low.y + radius + r * row_pitch(is_hexagonal, pitch),
                                     box.high.y - radius)};
            if (is_open(site)) sites.push_back(site);
        }
    }
    return sites;
}

}  // namespace

Lattice widest_lattice(const Box& box, double radius, std::size_t count,
                       const std::function<bool(Vec2)>& is_open) {
    constexpr double step = 1.02;
    const double closest = 2.0 * radius;
    const auto wanted = static_cast<double>(count);
    const double widest = size(box).x + size(box).y;
    const double most = 4.0 * wanted + 1000.0;  // bounds the work
    Lattice best;
    for (const bool is_hexagonal : {true, false}) {
        if (site_count(box, radius, closest, is_hexagonal) < wanted) continue;
        double pitch = closest;
        while (pitch < widest && site_count(box, radius, pitch * step, is_hexagonal) >= wanted) {
            pitch *= step;
        }
        // Obstacles may block sites, so a closer pitch than the count suggests may be needed.
        while (true) {
            std::vector<Vec2> sites = make_sites(box, radius, pitch, is_hexagonal, is_open);
            if (sites.size() >= count) {
                if (pitch > best.pitch) best = {std::move(sites), pitch};
                break;
            }
            if (pitch <= closest || site_count(box, radius, pitch, is_hexagonal) > most) break;
            pitch = std::max(closest, pitch / step);
        }
    }
    if (!best.sites.empty()) return best;
    for (const bool is_hexagonal : {true, false}) {
        if (site_count(box, radius, closest, is_hexagonal) > most) continue;
        std::vector<Vec2> sites = make_sites(box, radius, closest, is_hexagonal, is_open);
        if (sites.size() > best.sites.size()) best = {std::move(sites), closest};
    }
    return best;
}

}  // namespace carom
