#include "geometry/elementary.h"
#include "level/ir/arguments.h"
#include "level/ir/context.h"
#include "level/statements/families.h"

/// `seesaw`: edges that turn on hinges, and that balls push.
namespace carom {
namespace {

double in_radians(double degrees) {
    return degrees * pi / 180.0;
}

void build_seesaw(const Arguments& arguments, const Frame&, Context& context) {
    SeesawIr made;
    made.name = arguments.plain.front();
    made.mass = arguments.number_or("m", 1.0);
    made.stops_at = arguments.span_of(arguments.has("to") ? "to" : "from");
    made.tilt_at = arguments.span_of("tilt");
    Seesaw& seesaw = made.seesaw;
    seesaw.pivot = arguments.pair_or("about", {});
    if (const auto least = arguments.number("from")) seesaw.least = in_radians(*least);
    if (const auto most = arguments.number("to")) seesaw.most = in_radians(*most);
    seesaw.stop_restitution = arguments.number_or("e", 0.0);
    seesaw.angle = in_radians(arguments.number_or("tilt", 0.0));
    seesaw.rate = arguments.number_or("turning", 0.0);
    context.ir.seesaws.push_back(std::move(made));
}

}  // namespace

std::vector<Statement> seesaw_statements() {
    using enum KeyShape;
    return {
        {.name = "seesaw",
         .usage = "seesaw NAME about=X,Y m=MASS [from=ANGLE] [to=ANGLE] [e=] [tilt=ANGLE] "
                  "[turning=]",
         .action = build_seesaw,
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {{"about", pair, Measure::length, Bound::any, true},
                  {"m", scalar, Measure::mass, Bound::positive, true},
                  {"from", scalar, Measure::angle},
                  {"to", scalar, Measure::angle},
                  {"e", scalar, Measure::number, Bound::unit_interval},
                  {"tilt", scalar, Measure::angle},
                  {"turning", scalar, Measure::angular_speed}},
         .binds_names = true},
    };
}

}  // namespace carom
