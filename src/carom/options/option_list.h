#pragma once

#include "carom/options/options.h"

namespace CLI {
class App;
}

/// The commands and options, in the order of `--help`: one row an option, with the variable that
/// receives its value.
namespace carom {

/// The options of each command. Only those of the typed command are filled in.
struct CommandOptions {
    GuestOptions guest;  ///< without a command
    PlayOptions play;    ///< also for `replay`, and without a command
    RunOptions run;
    MeasureOptions measure;
    CompareOptions compare;
    VerifyOptions verify;
    CheckOptions check;
    PictureOptions picture;
    ExplainOptions explain;
    NewOptions fresh;  ///< of `new`
};

/// `options` must outlive parsing. Parsing throws BadValue for an invalid value.
void add_commands(CLI::App& app, CommandOptions& options);

}  // namespace carom
