#include "carom/pool/shot_picture.h"

#include "game/commands/aiming.h"

namespace carom {

PoolAnnotations::Line stick_behind(const Disc& ball, Vec2 velocity) {
    const Vec2 way = velocity / length(velocity);
    const Vec2 tip = ball.center - way * (1.5 * ball.radius + 0.03 * length(velocity));
    return {tip, tip - way * (16.0 * ball.radius)};
}

void show_shot(const Session& session, const CandidateShot& shot, PoolAnnotations& annotations) {
    const World& world = session.world();
    const auto index = index_of(world, shot.strike.ball);
    if (!index || !(length(shot.strike.velocity) > 0.0)) return;
    Disc ball{world.balls().position[*index], world.balls().radius[*index]};
    if (shot.place) {
        ball.center = *shot.place;
        annotations.ghost = ball;
    } else if (const auto line = aim_line(world, shot.strike.ball, shot.strike.velocity)) {
        annotations.aim = PoolAnnotations::Line{line->from, line->to};
        if (line->object) annotations.ghost = Disc{line->to, ball.radius};
    }
    annotations.stick = stick_behind(ball, shot.strike.velocity);
    if (shot.kind == CandidateShot::Kind::break_off || shot.kind == CandidateShot::Kind::safety ||
        shot.kind == CandidateShot::Kind::push_out)
        return;
    const auto pocket = static_cast<std::size_t>(shot.pocket);
    annotations.called = world.zones()[session.scene().pool.pockets[pocket]].shape.start;
}

}  // namespace carom
