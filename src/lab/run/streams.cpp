#include "lab/run/streams.h"

#include <fmt/format.h>

#include "lab/json.h"

namespace carom {

std::string event_lines(std::span<const Contact> contacts, std::uint64_t tick) {
    std::string lines;
    for (const Contact& contact : contacts) {
        lines += fmt::format(
            R"({{"t": {}, "tick": {}, "kind": "{}", "a": {}, "b": {}, "x": {}, "y": {}, )"
            R"("nx": {}, "ny": {}, "approach": {}, "impulse": {}}})"
            "\n",
            json_number(contact.time), tick,
            contact.kind == ContactKind::ball_ball ? "ball_ball" : "ball_edge", contact.a,
            contact.b, json_number(contact.point.x), json_number(contact.point.y),
            json_number(contact.normal.x), json_number(contact.normal.y),
            json_number(contact.approach), json_number(contact.impulse));
    }
    return lines;
}

std::string trace_header(const World& world) {
    return world.model().spin ? "tick,time,id,x,y,vx,vy,w\n" : "tick,time,id,x,y,vx,vy\n";
}

std::string trace_rows(const World& world) {
    std::string rows;
    for (std::size_t i = 0; i < world.balls().size(); ++i) {
        const Vec2 position = world.balls().position[i];
        const Vec2 velocity = world.balls().velocity[i];
        rows += fmt::format("{},{},{},{},{},{},{}", world.tick(), world.time(),
                            number(world.balls().id[i]), position.x, position.y, velocity.x,
                            velocity.y);
        if (world.model().spin) rows += fmt::format(",{}", world.balls().spin[i]);
        rows += '\n';
    }
    return rows;
}

}  // namespace carom
