#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "terminal/draw/draw_parts.h"

/// Draws the balls of many copies of a world as a density.
namespace carom {

namespace {

/// The coverage of one sample. Its ink is that of the majority, if there is one (Boyer and Moore's
/// majority vote).
struct Sample {
    std::uint32_t count = 0;
    std::uint32_t votes = 0;
    Ink ink;
};

class Cloud {
  public:
    explicit Cloud(const Raster& raster)
        : across_(raster.samples_across()),
          down_(raster.samples_down()),
          per_column_(static_cast<double>(across_) / raster.columns()),
          per_height_(static_cast<double>(down_) / (raster.rows() * raster.aspect())),
          samples_(static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_)) {}

    int across() const { return across_; }
    int down() const { return down_; }
    const Sample& at(int across, int down) const { return samples_[index(across, down)]; }

    /// Adds the samples whose centres the disc covers; for a smaller disc, the sample that contains
    /// its centre.
    void add(RasterPoint center, double radius, const Ink& ink) {
        const double x = center.x * per_column_;
        const double y = center.y * per_height_;
        const double half_width = radius * per_column_;
        const double half_height = radius * per_height_;
        // NaN compares false, so a disc that is not finite is not seen.
        const bool is_seen = x + half_width >= 0.0 && x - half_width <= across_ &&
                             y + half_height >= 0.0 && y - half_height <= down_;
        if (!is_seen) return;
        bool is_drawn = false;
        const int last = row_before(y + half_height, down_);
        for (int down = row_from(y - half_height); down <= last; ++down) {
            const double rise = (down + 0.5 - y) / half_height;
            if (rise * rise > 1.0) continue;
            const double half = half_width * std::sqrt(1.0 - rise * rise);
            const int end = row_before(x + half, across_);
            for (int across = row_from(x - half); across <= end; ++across) {
                vote(across, down, ink);
                is_drawn = true;
            }
        }
        if (!is_drawn && x >= 0.0 && x < across_ && y >= 0.0 && y < down_)
            vote(static_cast<int>(x), static_cast<int>(y), ink);
    }

  private:
    // The first row whose centre is not before `place`.
    static int row_from(double place) {
        return static_cast<int>(std::ceil(std::max(place, 0.0) - 0.5));
    }
    static int row_before(double place, int count) {
        return static_cast<int>(std::floor(std::min(place, count + 0.0) - 0.5));
    }
    std::size_t index(int across, int down) const {
        return static_cast<std::size_t>(down) * static_cast<std::size_t>(across_) +
               static_cast<std::size_t>(across);
    }
    void vote(int across, int down, const Ink& ink) {
        Sample& sample = samples_[index(across, down)];
        ++sample.count;
        if (sample.votes == 0) sample.ink = ink;
        if (sample.ink == ink)
            ++sample.votes;
        else
            --sample.votes;
    }

    int across_;
    int down_;
    double per_column_;
    double per_height_;
    std::vector<Sample> samples_;
};

void add_copy(Cloud& cloud, const View& view, const World& copy) {
    const Balls& balls = copy.balls();
    std::size_t own = 0;  // the ball with this id in the world that has the inks
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const std::vector<BallId>& ids = view.world.balls().id;
        while (own < ids.size() && ids[own] < balls.id[i])
            ++own;
        const bool is_known = own < ids.size() && ids[own] == balls.id[i];
        const Ink ink = is_known ? view.inks[own] : ink_of_class(balls.kind[i], view.options.look);
        const Vec2 reach{balls.radius[i], balls.radius[i]};
        const Vec2 place = balls.position[i];
        for (const Vec2 offset :
             images_of(copy.model(), {place - reach, place + reach}, view.camera))
            cloud.add(to_raster(view.camera, place + offset),
                      balls.radius[i] * view.camera.columns_per_length, ink);
    }
}

// Where pixels have no shades, some of them are lit: thresholds of 1 to 16, spread evenly.
bool is_lit(int across, int down, double share) {
    constexpr std::array<int, 16> thresholds = {1, 9,  3, 11, 13, 5, 15, 7,
                                                4, 12, 2, 10, 16, 8, 14, 6};
    const auto place = static_cast<std::size_t>((down % 4) * 4 + across % 4);
    return share * 16.0 >= thresholds[place] - 0.5;
}

// The eye perceives a quarter of the light as half as bright.
double brightness(double density) {
    return std::sqrt(std::min(1.0, density));
}

// Pixels are as bright, or as densely lit, as they are covered.
void show_samples(Raster& raster, const Cloud& cloud, const View& view) {
    const Look& look = view.options.look;
    const auto copies = static_cast<double>(view.annotations.copies.size());
    const bool is_shaded = raster.renderer().has_pixels() && look.has_shades();
    for (int down = 0; down < cloud.down(); ++down) {
        for (int across = 0; across < cloud.across(); ++across) {
            const Sample& sample = cloud.at(across, down);
            if (sample.count == 0) continue;
            // Faint, but never invisible.
            const double share = 0.15 + 0.85 * brightness(sample.count / copies);
            Ink ink = sample.ink;
            if (is_shaded)
                ink.color = dimmed(ink.color, share, look);
            else if (!is_lit(across, down, share))
                continue;
            raster.sample(across, down, 255, ink);
        }
    }
}

// The character of a cell is chosen by the covered share of the whole cell.
void show_characters(Raster& raster, const Cloud& cloud, const View& view) {
    constexpr std::string_view ramp = ".:-=+*#%@";
    const int wide = cloud.across() / raster.columns();
    const int high = cloud.down() / raster.rows();
    const double all = static_cast<double>(view.annotations.copies.size()) * wide * high;
    for (int row = 0; row < raster.rows(); ++row) {
        for (int column = 0; column < raster.columns(); ++column) {
            double count = 0.0;
            const Sample* most = nullptr;
            for (int i = 0; i < wide * high; ++i) {
                const Sample& sample = cloud.at(column * wide + i % wide, row * high + i / wide);
                count += sample.count;
                if (!most || sample.count > most->count) most = &sample;
            }
            if (count == 0.0) continue;
            const auto place = static_cast<std::size_t>(brightness(count / all) *
                                                        static_cast<double>(ramp.size()));
            raster.stamp({column + 0.5, (row + 0.5) * raster.aspect()},
                         ramp.substr(std::min(place, ramp.size() - 1), 1), most->ink);
        }
    }
}

}  // namespace

void paint_cloud(Raster& raster, const View& view) {
    Cloud cloud(raster);
    for (const World& copy : view.annotations.copies)
        add_copy(cloud, view, copy);
    if (raster.renderer().has_regions())
        show_characters(raster, cloud, view);
    else
        show_samples(raster, cloud, view);
}

}  // namespace carom
