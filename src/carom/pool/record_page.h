#pragma once

#include <string>
#include <vector>

#include "carom/files/pool_record.h"
#include "terminal/canvas/palette.h"

namespace carom {

/// A person's record at pool as a page of text: pots, safeties, runs and pace, frames against carom
/// at each skill, and the ladder.
std::vector<std::string> record_lines(const PoolRecord& record, const Look& look);

/// "2:1", matches against the opponent of a rung; "-": none played.
std::string results_text(const PoolRecord::Results& results);

}  // namespace carom
