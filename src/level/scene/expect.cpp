#include <array>
#include <cmath>
#include <cstddef>

#include "level/scene/scene.h"

namespace carom {

std::string_view sign(Expect::Relation relation) {
    constexpr std::array<std::string_view, 5> signs{"within", "<", "<=", ">", ">="};
    return signs[static_cast<std::size_t>(relation)];
}

bool holds(const Expect& expect, double measured) {
    switch (expect.relation) {
        case Expect::Relation::less:
            return measured < expect.value;
        case Expect::Relation::at_most:
            return measured <= expect.value;
        case Expect::Relation::more:
            return measured > expect.value;
        case Expect::Relation::at_least:
            return measured >= expect.value;
        case Expect::Relation::within:
            break;
    }
    return std::abs(measured - expect.value) <= expect.tolerance;
}

double shortfall(const Expect& expect, double measured) {
    switch (expect.relation) {
        case Expect::Relation::less:
        case Expect::Relation::at_most:
            return measured - expect.value;
        case Expect::Relation::more:
        case Expect::Relation::at_least:
            return expect.value - measured;
        case Expect::Relation::within:
            break;
    }
    return std::abs(measured - expect.value) - expect.tolerance;
}

}  // namespace carom
