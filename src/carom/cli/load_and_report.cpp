#include "carom/cli/load_and_report.h"

#include "carom/files/print.h"

namespace carom {

LoadedLevel load_and_report(const std::string& level, const LoadOptions& options) {
    LoadedLevel loaded = load_level_file(level, options);
    if (!loaded.error.empty()) print_error(loaded.error);
    print_diagnostics(loaded.result.diagnostics);
    return loaded;
}

}  // namespace carom
