#pragma once

#include <optional>
#include <string>
#include <vector>

#include "counted.h"

/// A gas with each term of the model in turn. Each term is so weak that the balls move as without
/// it, so its own cost is counted, not its effect on the gas.
namespace carom::bench {

struct TermScene {
    std::string term;  ///< as docs/physics.md calls it
    CountedScene with;
    /// The same statements with values that have no effect. None where no such value exists.
    std::optional<CountedScene> without;
};

/// The gas without any term. `gas`: the text of gas.level.
CountedScene bare_scene(const std::string& gas);

std::vector<TermScene> term_scenes(const std::string& gas);

}  // namespace carom::bench
