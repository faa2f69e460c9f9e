#include "scene_list.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace carom::bench {

std::string scene_list_text(const SceneList& scene) {
    std::string text;
    const auto line = [&text](const char* format, const auto&... arguments) {
        fmt::format_to(std::back_inserter(text), fmt::runtime(format), arguments...);
    };
    line("rate {}\ngravity {} {}\n", scene.rate, scene.gravity_x, scene.gravity_y);
    line("restitution {}\nfriction {}\n", scene.restitution, scene.friction);
    line("run {} {} {}\n", scene.plan.ticks, scene.plan.measured_from, scene.plan.sample_every);
    if (scene.plan.landed) line("landed {}\n", *scene.plan.landed);
    for (const ListedCapsule& c : scene.capsules)
        line("capsule {} {} {} {} {}\n", c.start_x, c.start_y, c.end_x, c.end_y, c.radius);
    for (const ListedBall& b : scene.balls)
        line("ball {} {} {} {} {} {} {}\n", b.tick, b.x, b.y, b.vx, b.vy, b.radius, b.mass);
    return text;
}

std::optional<SceneList> parse_scene_list(const std::string& text) {
    SceneList scene;
    std::istringstream in(text);
    std::string word;
    while (in >> word) {
        if (word == "rate") {
            in >> scene.rate;
        } else if (word == "gravity") {
            in >> scene.gravity_x >> scene.gravity_y;
        } else if (word == "restitution") {
            in >> scene.restitution;
        } else if (word == "friction") {
            in >> scene.friction;
        } else if (word == "run") {
            in >> scene.plan.ticks >> scene.plan.measured_from >> scene.plan.sample_every;
        } else if (word == "landed") {
            in >> scene.plan.landed.emplace();
        } else if (word == "capsule") {
            ListedCapsule& c = scene.capsules.emplace_back();
            in >> c.start_x >> c.start_y >> c.end_x >> c.end_y >> c.radius;
        } else if (word == "ball") {
            ListedBall& b = scene.balls.emplace_back();
            in >> b.tick >> b.x >> b.y >> b.vx >> b.vy >> b.radius >> b.mass;
        } else {
            return std::nullopt;
        }
        if (!in) return std::nullopt;
    }
    return scene;
}

SceneList read_scene_list(const std::string& path) {
    std::ifstream file(path);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    std::optional<SceneList> scene = parse_scene_list(text);
    if (!scene || text.empty()) {
        fmt::print(stderr, "error: {} is not a list of a scene\n", path);
        std::exit(2);
    }
    return *scene;
}

}  // namespace carom::bench
