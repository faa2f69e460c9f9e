#pragma once

#include <string>
#include <vector>

/// The fingerprints that must be the same with every compiler, with every option and on every
/// machine. Needs nothing above src/level, so that it can be built for machines without a terminal.
namespace carom::test {

/// "LEVEL SOLVER TICKS FINGERPRINT" for every level of the folder under every solver, in order.
/// `names`: of some levels only; empty: of all. A level that does not load gives the line
/// "LEVEL: " and what is wrong with it, which is in no file of golden lines.
std::vector<std::string> fingerprint_lines(const std::string& folder,
                                           const std::vector<std::string>& names = {});

}  // namespace carom::test
