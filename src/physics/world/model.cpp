#include "physics/world/model.h"

#include <fmt/format.h>

#include "geometry/elementary.h"

namespace carom {

bool loses_energy(const Model& model) {
    return model.inelastic || (model.spin && model.rough) || model.drag || model.stop_speed;
}

std::vector<std::string> terms_in_force(const Model& model) {
    std::vector<std::string> terms;
    if (model.gravity)
        terms.push_back(fmt::format("gravity {},{}", model.gravity->x, model.gravity->y));
    if (model.drag) terms.push_back(fmt::format("drag {}", *model.drag));
    if (model.stop_speed) terms.push_back(fmt::format("stop {}", *model.stop_speed));
    if (model.speed_limit) terms.push_back(fmt::format("limit {}", *model.speed_limit));
    if (model.inelastic) terms.push_back("restitution");
    if (model.scatter)
        terms.push_back(fmt::format("scatter {:.6g}deg", *model.scatter * (180.0 / pi)));
    if (model.spin) terms.push_back(fmt::format("spin {}", *model.spin));
    if (model.cloth)
        terms.push_back(fmt::format("cloth {} {} {}", model.cloth->slide, model.cloth->roll,
                                    model.cloth->spin));
    if (model.modulus) terms.push_back(fmt::format("modulus {:.6g}", *model.modulus));
    if (model.wrap) terms.push_back("wrap");
    if (model.one_way) terms.push_back("one-way");
    if (model.kicks) terms.push_back("kicks");
    if (model.curved) terms.push_back("curves");
    if (model.hinged) terms.push_back("hinges");
    if (model.filtered) terms.push_back("collide");
    if (!model.ball_ball) terms.push_back("no ball-ball");
    if (!model.ball_edge) terms.push_back("no ball-edge");
    return terms;
}

}  // namespace carom
