#pragma once

#include "carom/options/options.h"

namespace carom {

/// `carom verify`: plays a recording without a screen and compares its fingerprints. Returns the
/// exit code: 0 when all agree; 1 when one differs or a command is refused, and says where; 2 when
/// the file is not a complete recording. INT, TERM and HUP end it.
int verify(const VerifyOptions& options);

}  // namespace carom
