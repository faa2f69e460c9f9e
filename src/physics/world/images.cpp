#include "physics/world/images.h"

namespace carom {

bool has_all_images(const Model& model, const Capsule& edge) {
    if (!model.wrap) return true;
    const Vec2 out = size(*model.wrap) * 0.75;
    const Box most{model.wrap->low - out, model.wrap->high + out};
    const Box box = bounds(edge);
    return contains(most, box.low) && contains(most, box.high);
}

}  // namespace carom
