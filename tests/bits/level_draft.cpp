#include "bits/level_draft.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace carom::bits {
namespace {

// Not std::hypot, whose last bit is the library's.
double length_of(double x, double y) {
    return std::sqrt(x * x + y * y);
}

double distance(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
    const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
    const double t = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
    return length_of(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

}  // namespace

std::string text_of(double value) {
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string text_of(Point p) {
    return text_of(p.x) + ',' + text_of(p.y);
}

void Draft::add_edge(Point a, Point b, double r) {
    edges.push_back({a, b, r});
    ++level.edges;
}

Point Draft::place() {
    const double x = random.between(0.05, 0.95) * level.width;
    return at(x, random.between(0.05, 0.95) * level.height);
}

std::string Draft::material() {
    constexpr std::string_view names[] = {"", "ma ", "mb ", "mc "};
    return std::string(random.one_of(names));
}

bool Draft::is_inside(Point p) const {
    return p.x > origin.x && p.x < origin.x + level.width && p.y > origin.y &&
           p.y < origin.y + level.height;
}

bool Draft::fits(Point p, double r) const {
    for (const Disc& disc : discs)
        if (length_of(disc.at.x - p.x, disc.at.y - p.y) < disc.r + r) return false;
    for (const Edge& edge : edges)
        if (distance(p, edge.a, edge.b) < edge.r + r) return false;
    return true;
}

void add_pinball_parts(Draft& draft) {
    Random& random = draft.random;
    const std::string kick = " kick=" + text_of(draft.speed * random.decades(-0.5, 0.5));
    const std::string from = " from=" + text_of(draft.speed * random.decades(-1.5, 0.0));
    for (int i = random.integer(1, 3); i > 0; --i) {
        const Point a = draft.place();
        const double reach = draft.length * random.between(1.5, 5.0);
        const double r = draft.length * random.between(0.1, 0.5);
        const double rest = random.between(-60.0, 240.0);
        draft.line(Line() << "flipper " << draft.material() << "at=" << a << " length=" << reach
                          << " r=" << r << " rest=" << rest
                          << " up=" << rest + random.between(20.0, 80.0)
                          << " rise=" << draft.level.time * random.between(0.01, 0.2)
                          << " fall=" << draft.level.time * random.between(0.02, 0.4)
                          << (random.chance(0.5) ? " key=left" : " key=right"));
        draft.add_edge(a, a, reach + r);
    }
    const auto line_of = [&](std::string_view what, const Line& more) {
        const Point a = draft.place(), b = draft.place();
        draft.line(Line() << what << ' ' << a << ' ' << b << more.text());
        draft.add_edge(a, b, draft.length * 0.2);
    };
    if (random.chance(0.5)) {
        const Point a = draft.place();
        draft.line(Line() << "bumper at=" << a << " r=" << draft.length << kick << from);
        draft.add_edge(a, a, draft.length);
    }
    if (random.chance(0.4))
        line_of("slingshot", Line() << kick << from << " r=" << draft.length * 0.1);
    if (random.chance(0.4)) line_of("droptarget", {});
    if (random.chance(0.3)) line_of("target", {});
    if (random.chance(0.3))
        line_of("gate", Line() << (random.chance(0.5) ? " pass=up" : " pass=left"));
    if (random.chance(0.3)) {
        draft.line(Line() << "edge mc " << draft.place() << ' ' << draft.place());
        draft.line(Line() << "ramp " << draft.place() << ' ' << draft.place()
                          << " pass=up layer=1");
        ++draft.level.edges;
    }
    const std::string reach = " r=" + text_of(draft.length * random.between(0.5, 2.0));
    if (random.chance(0.3)) draft.line(Line() << "rollover at=" << draft.place() << reach);
    if (random.chance(0.3)) draft.line(Line() << "spinner at=" << draft.place() << reach);
    if (random.chance(0.3))
        draft.line(Line() << "kickback at=" << draft.place() << " dir=up speed=" << draft.speed
                          << reach);
    if (random.chance(0.3))
        draft.line(Line() << "hole at=" << draft.place() << " toward=" << draft.place() << " speed="
                          << draft.speed << " hold=" << draft.level.time * 0.2 << reach);
    if (random.chance(0.4)) {
        const Point a = draft.place();
        draft.line(Line() << "plunger at=" << a << " dir=up speed=" << draft.speed * 0.1 << ".."
                          << draft.speed * 2.0 << " width=" << draft.length * 2.0);
        draft.add_edge(a, a, draft.length * 3.0);
    }
}

void add_pockets(Draft& draft) {
    Random& random = draft.random;
    for (int i = random.integer(1, 4); i > 0; --i)
        draft.line(Line() << "pocket at=" << draft.place()
                          << " r=" << draft.length * random.between(0.9, 2.0));
}

void add_sinks(Draft& draft) {
    Random& random = draft.random;
    draft.line(Line() << "zone " << draft.place() << ' ' << draft.place()
                      << " r=" << draft.length * random.between(0.0, 2.0)
                      << (random.chance(0.7) ? " sink" : ""));
    if (random.chance(0.4))
        draft.line(Line() << "bins at=" << draft.at(draft.level.width / 2, draft.level.height / 3)
                          << " count=5 width=" << draft.level.width / 6 << " depth="
                          << draft.level.height / 4 << (random.chance(0.5) ? " sink" : " open"));
}

void add_grid_of_pegs(Draft& draft) {
    Random& random = draft.random;
    const double pitch = draft.length * random.between(2.0, 4.0);
    const Point top = draft.at(draft.level.width / 2, draft.level.height * 0.7);
    draft.add_edge(top, Point{top.x, top.y - 2.0 * pitch}, pitch * 2.5);
    draft.line(Line() << "pegs grid at=" << top << " rows=3 columns=4 pitch=" << pitch
                      << " r=" << draft.length * random.decades(-2.0, -0.3)
                      << (random.chance(0.5) ? " stagger material=ma" : " material=mb"));
    draft.level.edges += 12;
}

}  // namespace carom::bits
