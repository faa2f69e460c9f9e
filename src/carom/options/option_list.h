#pragma once

#include "carom/options/options.h"

namespace CLI {
class App;
}

/// Which commands and options there are, as `--help` lists them: one row an option, with the place
/// that its value goes to.
namespace carom {

/// What each command is asked for. Only that of the command that was typed is filled in.
struct CommandOptions {
    PlayOptions play;  ///< also of `replay`, and without a command
    RunOptions run;
    MeasureOptions measure;
    CompareOptions compare;
    VerifyOptions verify;
    CheckOptions check;
};

/// `options` must outlive the parsing, which throws BadValue for a value that does not fit.
void add_commands(CLI::App& app, CommandOptions& options);

}  // namespace carom
