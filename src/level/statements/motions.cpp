#include <fmt/format.h>

#include "geometry/elementary.h"
#include "level/ir/arguments.h"
#include "level/ir/context.h"
#include "level/statements/families.h"

/// `motion`: edges that move by themselves.
namespace carom {
namespace {

MotionIr motion_of(const Arguments& arguments) {
    MotionIr motion;
    motion.names = arguments.plain;
    motion.at = arguments.node->keyword().span();
    motion.every_at = arguments.span_of("every");
    motion.time_at = arguments.span_of("time");
    Mover& mover = motion.mover;
    mover.period = arguments.number_or("every", 1.0);
    mover.is_steady = arguments.flag("steady");
    mover.stops = arguments.count("stops");
    motion.waits = arguments.flag("waits");
    mover.runs = !motion.waits;
    mover.clock = arguments.number_or("time", 0.0);
    return motion;
}

double radians(double degrees) {
    return degrees * pi / 180.0;
}

void refuse_still(const Span& at, std::string_view remedy, Context& context) {
    context.reporter.error("motion-without-way", at, "this motion moves nothing",
                           std::string(remedy));
}

void build_turn(const Arguments& arguments, const Frame&, Context& context) {
    MotionIr motion = motion_of(arguments);
    motion.mover.pivot = arguments.pair_or("about", {});
    motion.mover.angle = radians(arguments.flag("clockwise") ? -360.0 : 360.0);
    context.ir.motions.push_back(std::move(motion));
}

void build_swing(const Arguments& arguments, const Frame&, Context& context) {
    MotionIr motion = motion_of(arguments);
    motion.mover.is_round = false;
    motion.mover.pivot = arguments.pair_or("about", {});
    motion.mover.angle = radians(arguments.number_or("by", 0.0));
    if (motion.mover.angle == 0.0)
        refuse_still(arguments.span_of("by"), "write how far it turns, such as by=90deg", context);
    context.ir.motions.push_back(std::move(motion));
}

void build_slide(const Arguments& arguments, const Frame&, Context& context) {
    MotionIr motion = motion_of(arguments);
    motion.mover.is_round = false;
    motion.mover.path = {{}, arguments.pair_or("by", {})};
    if (motion.mover.path.back() == Vec2{})
        refuse_still(arguments.span_of("by"), "write how far it goes, such as by=0,2", context);
    context.ir.motions.push_back(std::move(motion));
}

void build_path(const Arguments& arguments, const Frame&, Context& context) {
    MotionIr motion = motion_of(arguments);
    motion.mover.is_round = arguments.flag("close");
    double whole = 0.0;
    for (const Vec2 point : arguments.points) {
        motion.mover.path.push_back(point - arguments.points.front());
        whole += length(motion.mover.path.back());
    }
    if (motion.mover.is_round) motion.mover.path.push_back({});
    if (whole == 0.0)
        refuse_still(arguments.point_words.front().span(),
                     "write different points, such as 0,0 0,2", context);
    context.ir.motions.push_back(std::move(motion));
}

Statement motion(Statement row) {
    row.place = Place::top;
    row.plain_least = 1;
    row.plain_most = many;
    row.keys.push_back({"every", KeyShape::scalar, Measure::time, Bound::positive, true});
    row.keys.push_back({"stops", KeyShape::scalar, Measure::whole, Bound::up_to_thousand});
    row.keys.push_back({"time", KeyShape::scalar, Measure::time, Bound::not_negative});
    row.flags.push_back("waits");
    row.binds_names = true;
    return row;
}

}  // namespace

std::vector<Statement> motion_statements() {
    using enum KeyShape;
    const KeyRule about{"about", pair, Measure::length, Bound::any, true};
    return {
        motion({.name = "motion turn",
                .usage = "motion turn NAME ... about=X,Y every=TIME [clockwise] [stops=N] "
                         "[time=TIME] [waits]",
                .action = build_turn,
                .keys = {about},
                .flags = {"clockwise"}}),
        motion({.name = "motion swing",
                .usage = "motion swing NAME ... about=X,Y by=ANGLE every=TIME [steady] [stops=N] "
                         "[time=TIME] [waits]",
                .action = build_swing,
                .keys = {about, {"by", scalar, Measure::angle, Bound::any, true}},
                .flags = {"steady"}}),
        motion({.name = "motion slide",
                .usage = "motion slide NAME ... by=X,Y every=TIME [steady] [stops=N] [time=TIME] "
                         "[waits]",
                .action = build_slide,
                .keys = {{"by", pair, Measure::length, Bound::any, true}},
                .flags = {"steady"}}),
        motion({.name = "motion path",
                .usage = "motion path NAME ... X,Y X,Y ... every=TIME [close] [steady] [stops=N] "
                         "[time=TIME] [waits]",
                .action = build_path,
                .points_least = 2,
                .points_most = many,
                .flags = {"close", "steady"}}),
    };
}

}  // namespace carom
