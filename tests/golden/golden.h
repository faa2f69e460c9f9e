#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// The fingerprints that must be the same with every compiler, with every option and on every
/// machine. Needs nothing above src/game, so that it can be built for machines without a terminal.
namespace carom::test {

struct GoldenRun {
    std::string line;
    std::uint64_t ticks = 0;
    std::vector<std::string> trace;  ///< see trace.h
};

/// "LEVEL SOLVER TICKS FINGERPRINT" for every level of the folder under every solver, in order.
/// `names`: of some levels only; empty: of all. A level that does not load gives the line
/// "LEVEL: " and what is wrong with it, which is in no file of golden lines.
std::vector<GoldenRun> golden_levels(const std::string& folder,
                                     const std::vector<std::string>& names = {});

/// "FILE TICKS FINGERPRINT" for every recording (*.replay) of the folder, played to its end: what
/// players do gives the same bits too. One that cannot be read or played gives "FILE: " and why.
std::vector<GoldenRun> golden_replays(const std::string& folder);

}  // namespace carom::test
