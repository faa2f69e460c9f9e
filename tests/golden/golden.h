#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Fingerprints that must be equal with every compiler, every option and on every machine. Needs
/// nothing above src/game, so that it can be built for machines without a terminal.
namespace carom::test {

struct GoldenRun {
    std::string line;
    bool has_failed = false;  ///< `line` gives the reason, and stands in no golden file
    std::uint64_t ticks = 0;
    std::vector<std::string> trace;  ///< see trace.h
};

/// "LEVEL SOLVER TICKS FINGERPRINT" for every level of the folder under every solver, in order.
/// `names`: only these levels; empty: all. A level that does not load has failed: "LEVEL: " and its
/// error.
std::vector<GoldenRun> golden_levels(const std::string& folder,
                                     const std::vector<std::string>& names = {});

/// "FILE TICKS FINGERPRINT" for every recording (*.replay) of the folder, played to its end, since
/// commands must give equal bits too. A recording that cannot be read, or does not give its own
/// fingerprints, has failed: "FILE: " and the reason.
std::vector<GoldenRun> golden_replays(const std::string& folder);

}  // namespace carom::test
