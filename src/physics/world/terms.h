#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "physics/world/world.h"

/// The terms of the model that inner loops depend on, as compile-time flags. The inner loops of
/// `discrete`, `substep`, `swept` and of the classification in `contact` are compiled once for each
/// of the 16 sets, and the set is chosen above the loops. `event` does not use them: its predictor
/// and its impact of two balls are compiled for gases and for everything else
/// (event/schedule/foreseen_collision.h).
namespace carom {

struct Terms {
    unsigned flags = 0;

    static constexpr unsigned inelastic_flag = 1;  ///< some restitution is below 1
    /// Scatter, one-way edges, edges that kick, curves, collision filters, or kinematic bodies. The
    /// loop then asks the world which of these there are.
    static constexpr unsigned special_flag = 2;
    static constexpr unsigned wrap_flag = 4;  ///< a torus
    static constexpr unsigned spin_flag = 8;  ///< friction, and balls turn

    constexpr bool inelastic() const { return (flags & inelastic_flag) != 0; }
    constexpr bool special() const { return (flags & special_flag) != 0; }
    constexpr bool wrap() const { return (flags & wrap_flag) != 0; }
    constexpr bool spin() const { return (flags & spin_flag) != 0; }
};

inline Terms terms_of(const World& world) {
    const Model& model = world.model();
    const bool special = model.scatter || model.one_way || model.kicks || model.curved ||
                         model.filtered || !world.held_balls().empty() ||
                         !world.held_capsules().empty();
    return {(model.inelastic ? Terms::inelastic_flag : 0) | (special ? Terms::special_flag : 0) |
            (model.wrap ? Terms::wrap_flag : 0) | (model.spin ? Terms::spin_flag : 0)};
}

/// Calls `body.template operator()<Terms>()` compiled for `terms`.
template <typename Body>
void with_terms(Terms terms, Body&& body) {
    [&]<std::size_t... set>(std::index_sequence<set...>) {
        using Call = void (*)(Body&);
        static constexpr std::array<Call, sizeof...(set)> calls{
            +[](Body& b) { b.template operator()<Terms{static_cast<unsigned>(set)}>(); }...};
        calls[terms.flags](body);
    }
    (std::make_index_sequence<16>{});
}

}  // namespace carom
