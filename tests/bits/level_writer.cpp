#include "bits/level_writer.h"

#include "bits/level_draft.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace carom::bits {
namespace {

class LevelWriter : Draft {
  public:
    LevelWriter(Random& chance, double least_decade)
        : Draft{chance, {}, 1.0, 1.0, {}, {}, {}}, least_decade_(least_decade) {}

    Level write() {
        scales();
        const int profile = random.integer(0, 99);
        level.has_cloth = profile < 14;
        is_pile_ = profile >= 14 && profile < 32;
        level.has_buttons = profile >= 32 && profile < 46;
        has_gravity_ = is_pile_ || (!level.has_cloth && random.chance(0.4));
        terms();
        classes();
        solver();
        walls();
        some_edges();
        if (level.has_buttons) add_pinball_parts(*this);
        if (level.has_cloth && random.chance(0.6)) add_pockets(*this);
        if (random.chance(0.15)) add_sinks(*this);
        if (random.chance(0.12)) add_grid_of_pegs(*this);
        balls();
        many_balls();
        return level;
    }

  private:
    // A time and a length set all other scales, so that something happens in every scene.
    void scales() {
        length = random.chance(0.75) ? 1.0 : random.decades(-3.0, 4.0);
        level.width = length * random.between(8.0, 40.0);
        level.height = length * random.between(8.0, 30.0);
        constexpr double rates[] = {30, 60, 120, 120, 120, 240, 1000};
        level.rate = random.chance(0.85) ? random.one_of(rates) : random.decades(0.0, 4.0);
        level.ticks = random.integer(20, 120);
        level.time = level.ticks / level.rate;
        speed = length * random.decades(0.5, 2.0) / level.time;
        const bool is_far = random.chance(0.08);
        origin = is_far ? Point{length * random.decades(2.0, 6.0), -length * 1e5} : Point{};
        line("carom 1 \"fuzzed\"");
        line("seed " + std::to_string(random.integer(0, 1 << 30)));
        line("rate " + text_of(level.rate));
    }

    void terms() {
        if (has_gravity_) {
            const double g = length * random.decades(0.0, 2.3) / (level.time * level.time);
            const double sideways = random.chance(0.2) ? random.between(-g, g) : 0.0;
            line("use gravity " + text_of(Point{sideways, -g}));
        }
        if (!level.has_cloth) {
            if (random.chance(0.15))
                line(Line() << "use drag " << random.decades(-1.0, 1.0) / level.time);
            if (random.chance(0.35)) line("use spin" + inertia());
        }
        if (random.chance(0.12)) line("use stop " + text_of(speed * random.decades(-2.0, -0.3)));
        if (random.chance(0.12)) line("use limit " + text_of(speed * random.between(0.5, 2.0)));
        if (random.chance(0.12)) line("use scatter " + text_of(random.between(1.0, 40.0)));
        if (random.chance(0.12)) overlap_ = true, line("use overlap");
        if (level.has_cloth) {
            const double most = speed * speed / length;
            line(Line() << "use cloth slide=" << random.decades(-2.5, 0.0)
                        << " roll=" << random.decades(-3.5, -1.5)
                        << " spin=" << random.decades(-1.0, 2.0) * speed / length / level.time
                        << " g=" << most * random.decades(-1.0, 0.5));
        }
        if (!has_gravity_ && random.chance(0.25))
            line("use modulus " +
                 text_of(random.decades(2.0, 10.0) * speed * speed / (length * length * length)));
        const bool wraps = random.chance(0.12);
        line("world " + text_of(at(0, 0)) + ' ' + text_of(at(level.width, level.height)));
        if (wraps) line("use wrap"), is_open_ = random.chance(0.7);
        spins_ = level.text.find("use spin") != std::string::npos || level.has_cloth;
    }

    std::string inertia() {
        if (random.chance(0.5)) return {};
        constexpr double values[] = {0.4, 0.5, 1.0, 0.1};
        return " inertia=" + text_of(random.one_of(values));
    }

    std::string share() {
        constexpr double common[] = {0.0, 0.5, 0.9, 1.0};
        return text_of(random.chance(0.5) ? random.one_of(common) : random.between(0.0, 1.0));
    }

    void classes() {
        const bool rubs = spins_ && random.chance(0.8);
        for (const std::string_view kind : {"ka", "kb", "kc"}) {
            std::string text = "kind " + std::string(kind) + " r=" + text_of(radius());
            if (random.chance(0.6)) text += " e=" + share();
            if (random.chance(0.4)) text += " m=" + text_of(mass());
            if (rubs && random.chance(0.7)) text += " mu=" + text_of(random.decades(-2.0, 0.3));
            line(text);
        }
        for (const std::string_view material : {"ma", "mb", "mc"}) {
            std::string text = "material " + std::string(material) + " e=" + share();
            if (random.chance(0.2)) text += " soften=" + text_of(random.decades(-1.5, 0.5) / speed);
            if (rubs && random.chance(0.7)) text += " mu=" + text_of(random.decades(-2.0, 0.3));
            if (level.has_buttons && material == "mc") text += " layer=1";
            line(text);
        }
        if (random.chance(0.15)) {
            constexpr std::string_view kinds[] = {"ka", "kb", "kc", "ball"};
            constexpr std::string_view all[] = {"ka", "kb", "kc", "ball", "ma", "mb", "edge"};
            for (int i = random.integer(1, 4); i > 0; --i)
                line(Line() << "collide " << random.one_of(kinds) << ' ' << random.one_of(all));
            if (random.chance(0.8)) line("collide ball edge");
        }
    }

    double radius() {
        const double usual = length * (is_pile_ ? 0.5 : 0.7);
        return random.chance(0.85) ? usual * random.between(0.5, 1.2)
                                   : usual * random.decades(least_decade_, 0.7);
    }
    double mass() {
        return random.chance(0.8) ? random.decades(-1.0, 1.0) : random.decades(-6.0, 6.0);
    }

    void solver() {
        const int which = random.integer(0, 99);
        const std::string substeps = " substeps=" + std::to_string(random.integer(1, 5));
        if (which < 36) return line("solver event");
        if (which < 60 && !level.has_cloth)
            return line("solver contact" + (random.chance(0.6) ? substeps : ""));
        if (which < 80) return line("solver swept" + (random.chance(0.6) ? substeps : ""));
        if (which < 90)
            return line(Line() << "solver substep updates=" << random.integer(1, 4)
                               << " steps=" << random.integer(1, 8));
        if (which < 97) line("solver discrete");
    }

    void walls() {
        thickness_ = random.chance(0.3) ? 0.0 : length * random.between(0.0, 0.8);
        if (is_open_ || random.chance(0.1)) return;
        line(Line() << "box " << material() << at(0, 0) << ' ' << at(level.width, level.height)
                    << " r=" << thickness_
                    << (random.chance(0.1) ? " fillet=" + text_of(length * 2.0) : ""));
        const Point corners[] = {at(0, 0), at(level.width, 0), at(level.width, level.height),
                                 at(0, level.height)};
        for (int i = 0; i < 4; ++i)
            add_edge(corners[i], corners[(i + 1) % 4], thickness_);
    }

    void some_edges() {
        constexpr std::string_view sides[] = {"", "", "", " side=left", " side=right"};
        for (int i = random.integer(0, is_pile_ ? 3 : 6); i > 0; --i) {
            const Point a = place(), b = random.chance(0.3) ? Point{a.x, place().y} : place();
            const double r = random.chance(0.4) ? 0.0 : length * random.decades(-3.0, 0.0);
            const int shape = random.integer(0, 9);
            if (shape == 0) {
                line(Line() << "peg " << material() << "at=" << a << " r=" << r + length * 0.1);
                add_edge(a, a, r + length * 0.1);
            } else if (shape == 1) {
                const double turn = random.between(0.0, 360.0);
                const double reach = length * random.between(1.0, 4.0);
                line(Line() << "arc " << material() << "at=" << a << " radius=" << reach << " from="
                            << turn << " to=" << turn + random.between(30.0, 300.0) << " r=" << r);
                add_edge(a, a, reach + r);
            } else {
                line(Line() << "edge " << material() << a << ' ' << b << " r=" << r
                            << random.one_of(sides));
                add_edge(a, b, r);
            }
        }
    }

    void balls() {
        const int most = is_pile_ ? 24 : 12;
        for (int i = random.integer(random.chance(0.7) ? 2 : 0, most); i > 0; --i) {
            const double r = radius();
            Point p = place();
            bool is_free = overlap_;
            for (int tries = 0; tries < 20 && !is_free; ++tries) {
                p = place();
                // Some touch the previous ball, exactly in one coordinate.
                if (!discs.empty() && random.chance(0.3)) {
                    const Disc& other = discs.back();
                    p = random.chance(0.5) ? Point{other.at.x + (other.r + r), other.at.y}
                                           : Point{other.at.x, other.at.y + (other.r + r)};
                }
                is_free = is_inside(p) && fits(p, r);
            }
            if (is_free) ball(p, r);
        }
    }

    void ball(Point p, double r) {
        constexpr std::string_view kinds[] = {"", " kind=ka", " kind=kb", " kind=kc"};
        std::string text =
            "ball at=" + text_of(p) + " r=" + text_of(r) + std::string(random.one_of(kinds));
        const double fast = random.chance(0.2) ? 0.0 : speed * random.decades(-1.0, 0.5);
        if (random.chance(is_pile_ ? 0.4 : 0.9))
            text += " v=" + text_of(Point{fast * random.between(-1.0, 1.0),
                                          fast * random.between(-1.0, 1.0)});
        if (random.chance(0.4)) text += " m=" + text_of(mass());
        if (random.chance(0.2)) text += " e=" + share();
        if (spins_ && random.chance(0.4))
            text += " w=" + text_of(fast / length * random.between(-3.0, 3.0));
        if (level.has_cloth && random.chance(0.3))
            text += " roll=" + text_of(Point{fast * random.between(-1.0, 1.0), 0.0});
        line(text);
        discs.push_back({p, r});
        ++level.balls;
    }

    void many_balls() {
        if (level.has_cloth && random.chance(0.3))
            line("rack nine kind=ka at=" + text_of(at(level.width / 2, level.height / 2)) +
                 (random.chance(0.5) ? " gap=" + text_of(length * 1e-3) + " seed=4" : "")),
                level.balls += 9;
        if (random.chance(is_pile_ ? 0.5 : 0.15)) {
            const int count = random.integer(2, is_pile_ ? 60 : 20);
            line(Line() << "fill ka count=" << count
                        << " box=" << at(level.width * 0.1, level.height * 0.1) << ','
                        << at(level.width * 0.9, level.height * 0.9) << " r=" << length * 0.3
                        << ".." << length * 0.6
                        << (random.chance(0.6) ? " speed=" + text_of(speed) : ""));
            level.balls += count;
        }
        if (const Point p = place(); random.chance(0.2) && fits(p, length)) {
            line("spawn kb at=" + text_of(p) +
                 " every=" + text_of(level.time / random.between(2.0, 20.0)) + " count=10 v=" +
                 text_of(Point{0.0, -speed * 0.3}) + " jitter=" + text_of(Point{length, 0.0}) +
                 " vjitter=" + text_of(Point{speed * 0.1, 0.0}));
            level.balls += 5;
        }
        if (random.chance(0.05))
            line("cradle at=" + text_of(at(level.width / 2, level.height / 2)) +
                 " count=4 in=1 v=" + text_of(speed) + " r=" + text_of(length * 0.4) +
                 " swing=" + text_of(length * 3.0)),
                level.balls += 4;
    }

    double least_decade_;
    double thickness_ = 0.0;
    bool is_pile_ = false;
    bool has_gravity_ = false;
    bool overlap_ = false;
    bool is_open_ = false;
    bool spins_ = false;
};

}  // namespace

Level write_level(Random& random, double least_decade) {
    return LevelWriter(random, least_decade).write();
}

}  // namespace carom::bits
