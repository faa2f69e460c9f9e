#pragma once

#include "carom/support/process.h"
#include "support/terminal_program.h"

namespace carom::test {

/// For a program whose user's home is the folder: preferences and games are kept there.
inline ProgramOptions at_home(const TemporaryFolder& folder) {
    ProgramOptions options;
    options.columns = 120;
    options.environment = {{"XDG_CONFIG_HOME", folder.path("config")},
                           {"XDG_STATE_HOME", folder.path("state")},
                           {"XDG_DATA_HOME", folder.path("data")}};
    return options;
}

}  // namespace carom::test
