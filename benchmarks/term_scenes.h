#pragma once

#include <optional>
#include <string>
#include <vector>

#include "counted.h"

/// A gas with each term of the model in turn, so small that the balls move as without it: what is
/// counted is the term, not what it does to the gas.
namespace carom::bench {

struct TermScene {
    std::string term;  ///< as docs/physics.md calls it
    CountedScene with;
    /// The same statements with values that amount to nothing. None where there is no such thing.
    std::optional<CountedScene> without;
};

/// The gas with no term at all. `gas`: the text of gas.level.
CountedScene bare_scene(const std::string& gas);

std::vector<TermScene> term_scenes(const std::string& gas);

}  // namespace carom::bench
