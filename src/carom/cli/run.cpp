#include "carom/cli/run.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "carom/cli/interrupt.h"
#include "carom/cli/progress.h"
#include "carom/files/files.h"
#include "carom/files/level_files.h"
#include "carom/files/print.h"
#include "carom/options/option_values.h"
#include "carom/play/recording.h"
#include "carom/text/version.h"
#include "game/replay/replayer.h"
#include "lab/run/report.h"
#include "lab/run/streams.h"
#include "physics/world/fingerprint.h"

namespace carom {
namespace {

constexpr double default_seconds = 10.0;

std::uint64_t ticks_to_run(const RunOptions& options, double rate) {
    if (options.ticks) return *options.ticks;
    return static_cast<std::uint64_t>(std::round(options.time.value_or(default_seconds) * rate));
}

// The outputs of a run. At most one of them is standard output.
class RunOutputs {
  public:
    explicit RunOutputs(const RunOptions& options) {
        open(report_, options.report);
        open(events_, options.events);
        open(trace_, options.trace);
        open(record_, options.record);
    }

    bool any() const { return report_ || events_ || trace_ || record_; }

    void write_start(const World& world) {
        if (trace_) trace_->write(trace_header(world) + trace_rows(world));
    }
    void write_tick(const World& world, const Solver& solver) {
        if (events_) events_->write(event_lines(solver.contacts(), world.tick()));
        if (trace_) trace_->write(trace_rows(world));
    }
    void write_report(std::string_view json) {
        if (report_) report_->write(json);
    }
    void write_recording(const Replay& replay) {
        if (record_) record_->write(replay_text(replay));
    }
    void commit() {
        for (std::optional<OutputFile>* file : all()) {
            if (*file) (*file)->commit();
        }
    }

    /// Every output is a pipe that its reader has closed, so there is nobody to run for.
    bool is_pointless() {
        bool pointless = any();
        for (const std::optional<OutputFile>* file : all()) {
            if (*file && !((*file)->is_closed() && (*file)->error().empty())) pointless = false;
        }
        return pointless;
    }
    std::string error() {
        for (const std::optional<OutputFile>* file : all()) {
            if (*file && !(*file)->error().empty()) return (*file)->error();
        }
        return {};
    }

  private:
    static void open(std::optional<OutputFile>& file, const std::string& path) {
        if (!path.empty()) file.emplace(path);
    }
    std::array<std::optional<OutputFile>*, 4> all() {
        return {&report_, &events_, &trace_, &record_};
    }

    std::optional<OutputFile> report_;
    std::optional<OutputFile> events_;
    std::optional<OutputFile> trace_;
    std::optional<OutputFile> record_;
};

bool to_standard_output(const RunOptions& options) {
    return options.report == "-" || options.events == "-" || options.trace == "-" ||
           options.record == "-";
}

// Two outputs with one name would overwrite each other.
std::optional<std::string> clash(const RunOptions& options) {
    const std::array<const std::string*, 4> paths{&options.report, &options.events, &options.trace,
                                                  &options.record};
    for (std::size_t i = 0; i < paths.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (paths[i]->empty() || *paths[i] != *paths[j]) continue;
            return fmt::format("two outputs cannot both go to {}",
                               *paths[i] == "-" ? "standard output" : "'" + *paths[i] + "'");
        }
    }
    return std::nullopt;
}

void mark(Replay& replay, const World& world, const GameState& game) {
    replay.marks.push_back({world.tick(), fingerprint(world, game)});
}

void tell_too_dense(const World& world) {
    print_note(
        fmt::format("note: too dense for events: time stood still in tick {} ({:.6g} s), and "
                    "maybe in later ones\n",
                    world.tick(), world.time()));
}

// Runs until the end, a signal, a failing output, or a closed pipe. Returns the time spent in the
// solver, in seconds.
double simulate(const Scene& scene, World& world, GameState& game, RunRecord& record,
                Solver& solver, RunOutputs& outputs, Replay& replay, std::uint64_t ticks) {
    using Clock = std::chrono::steady_clock;
    Clock::duration cost{};
    bool is_told = false;
    Progress progress(ticks);
    while (world.tick() < ticks && InterruptGuard::signal() == 0) {
        const Clock::time_point before = Clock::now();
        const TickOutcome outcome =
            solver.tick(world, [] { return InterruptGuard::signal() == 0; });
        cost += Clock::now() - before;
        if (outcome == TickOutcome::cancelled) break;
        if (outcome == TickOutcome::too_dense && !std::exchange(is_told, true))
            tell_too_dense(world);
        update_game(scene, world, game, solver.contacts());
        note_tick(record, scene, world);
        if (world.tick() % mark_interval(world.rate()) == 0) mark(replay, world, game);
        outputs.write_tick(world, solver);
        if (!outputs.error().empty() || outputs.is_pointless()) break;
        progress.update(world.tick());
    }
    return std::chrono::duration<double>(cost).count();
}

int run_scene(const RunOptions& options, const Scene& scene) {
    const SolverSettings settings = solver_for(scene);
    if (const std::optional<std::string> why = unavailable(settings.kind)) {
        print_error(*why);
        return 2;
    }
    RunOutputs outputs(options);
    if (!outputs.error().empty()) {
        print_error(outputs.error());
        return 2;
    }
    if (options.explain) {
        if (to_standard_output(options)) {
            print_note(explanation(scene));
        } else if (!print_out(explanation(scene))) {
            return 2;
        }
    }

    const InterruptGuard guard;
    World world = scene.world;
    GameState game = begin_game(scene);
    Solver solver(settings);
    RunRecord record = begin_record(scene, settings);
    Replay replay = begin_replay(scene, settings, name_in_recording(scene.file), options.overrides);
    replay.program = version();
    mark(replay, world, game);
    outputs.write_start(world);
    const std::uint64_t ticks = ticks_to_run(options, world.rate());
    const double seconds = simulate(scene, world, game, record, solver, outputs, replay, ticks);
    record.tallies = tallies(game);
    if (world.tick() == ticks) note_end(record, scene, world);
    outputs.write_report(report_json(options.level, scene, world, record, seconds));
    if (replay.marks.back().tick < world.tick()) mark(replay, world, game);
    replay.end = replay.position = world.tick();
    outputs.write_recording(replay);
    outputs.commit();
    if (!outputs.error().empty()) {
        print_error(outputs.error());
        return 2;
    }
    if (!outputs.any() && !options.explain) {
        const std::string text = summary(scene, world, record, seconds) +
                                 verdicts(scene, record, Verdict::holds) +
                                 verdicts(scene, record, Verdict::not_judged);
        if (!print_out(text)) return 2;
    }
    print_note(verdicts(scene, record, Verdict::fails));
    return has_failure(record) ? 1 : 0;
}

}  // namespace

int run(const RunOptions& options) {
    if (const std::optional<std::string> why = clash(options)) {
        print_error(*why);
        return 2;
    }
    const LoadedLevel level = load_level_file(options.level, {.overrides = options.overrides,
                                                              .seed = options.seed,
                                                              .rate = options.rate,
                                                              .solver = options.solver});
    if (!level.error.empty()) print_error(level.error);
    print_diagnostics(level.result.diagnostics);
    if (!level.result.scene) return 2;
    const int code = run_scene(options, *level.result.scene);
    if (const int signal = InterruptGuard::signal()) die_of(signal);
    return code;
}

}  // namespace carom
