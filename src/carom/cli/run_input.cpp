#include "carom/cli/run_input.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "carom/cli/load_and_report.h"
#include "carom/cli/open_recording.h"
#include "carom/files/files.h"
#include "carom/files/print.h"
#include "carom/files/recording.h"
#include "lab/run/run_record.h"

namespace carom {
namespace {

constexpr double default_seconds = 10.0;
/// The commands of about an hour of dragging; a longer file is no script.
constexpr std::size_t most_script_bytes = std::size_t{64} << 20;

std::uint64_t ticks_to_run(const RunOptions& options, double rate,
                           std::optional<std::uint64_t> end) {
    if (options.ticks) return *options.ticks;
    if (end && !options.time) return *end;
    return static_cast<std::uint64_t>(std::round(options.time.value_or(default_seconds) * rate));
}

std::optional<RunInput> open_recorded(const RunOptions& options) {
    std::optional<OpenedReplay> opened =
        open_recording(options.level, {{"--commands", !options.commands.empty()},
                                       {"--rate", options.rate.has_value()},
                                       {"--seed", options.seed.has_value()},
                                       {"--set", !options.overrides.empty()}});
    if (!opened) return std::nullopt;
    auto& [replay, scene] = *opened;
    RunInput input;
    input.scene = std::move(scene);
    const SolverSettings own = solver_for(input.scene);
    input.scene.solver = options.solver ? *options.solver : replay.solver;
    input.scene.overridden |= *input.scene.solver != own || !replay.commands.empty();
    input.script.commands = as_script(replay.commands);
    input.ticks = ticks_to_run(options, input.scene.world.rate(), replay.end);
    input.recording = std::move(replay);
    return input;
}

// False: an error, which has been printed.
bool read_commands(const RunOptions& options, RunInput& input) {
    FileText file = read_file(options.commands, most_script_bytes);
    if (!file.text || file.text->size() > most_script_bytes) {
        print_error(file.text
                        ? fmt::format("'{}' has more than 64 MiB: it is no script of commands",
                                      options.commands)
                        : file.error);
        return false;
    }
    auto read = read_script(*file.text);
    if (const auto* fault = std::get_if<ReplayError>(&read)) {
        print_note(rendered(options.commands, *file.text, *fault));
        return false;
    }
    input.script = std::move(std::get<CommandScript>(read));
    input.script_text = std::move(*file.text);
    return true;
}

}  // namespace

std::optional<RunInput> open_run_input(const RunOptions& options) {
    if (is_recording(options.level)) return open_recorded(options);
    LoadedLevel level = load_and_report(options.level, {.overrides = options.overrides,
                                                        .seed = options.seed,
                                                        .rate = options.rate,
                                                        .solver = options.solver});
    if (!level.result.scene) return std::nullopt;
    RunInput input;
    input.scene = std::move(*level.result.scene);
    if (!options.commands.empty() && !read_commands(options, input)) return std::nullopt;
    input.ticks = ticks_to_run(options, input.scene.world.rate(), std::nullopt);
    return input;
}

std::string told_refusal(const RunOptions& options, const RunInput& input,
                         const ScriptRunner::Refused& refused) {
    const std::uint64_t tick = refused.tick;
    const std::string why = fmt::format("at tick {}: {}", tick, refused.reason);
    if (input.recording) return fmt::format("carom: error: '{}': {}\n", options.level, why);
    return rendered(options.commands, input.script_text,
                    {input.script.lines[refused.index], why,
                     "nothing has been written; at rest strike cue 2,0 waits for the balls"});
}

}  // namespace carom
