#include "carom/cli/run.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "carom/cli/interrupt.h"
#include "carom/cli/progress.h"
#include "carom/cli/run_input.h"
#include "carom/cli/run_outputs.h"
#include "carom/files/output_clash.h"
#include "carom/files/print.h"
#include "carom/files/recording.h"
#include "carom/options/option_values.h"
#include "carom/text/version.h"
#include "game/replay/replayer.h"
#include "lab/run/invariants.h"
#include "lab/run/report.h"
#include "lab/run/rule_log.h"
#include "physics/version.h"
#include "physics/world/fingerprint.h"

namespace carom {
namespace {

/// A level or a recording as it runs, and all that is noted of it.
class Run {
  public:
    Run(const RunOptions& options, const RunInput& input, const SolverSettings& settings,
        RunOutputs& outputs)
        : input_(input),
          outputs_(outputs),
          world_(input.scene.world),
          game_(begin_game(input.scene)),
          solver_(settings),
          record_(begin_record(input.scene, settings)),
          runner_(input.script.commands),
          follows_recording_(input.recording && !options.solver) {
        if (options.check) check_.emplace(input.scene, settings.kind);
        replay_ = begin_replay(
            input.scene, settings,
            input.recording ? input.recording->level : name_in_recording(input.scene.file),
            input.recording ? input.recording->overrides : options.overrides);
        replay_.program = version();
    }

    /// Runs until the end, a signal, a failing output, a closed pipe, or a command that is refused.
    void simulate();
    /// Writes the outputs, and says what was left over.
    void finish(const std::string& level);

    const std::optional<ScriptRunner::Refused>& refused() const { return refused_; }
    const RunRecord& record() const { return record_; }
    /// Why the run ended early under --check.
    std::optional<std::string> broken() const {
        if (!breach_) return std::nullopt;
        return carom::text(*breach_, world_.rate());
    }
    std::string text() const {
        const Observer* observer = record_.watch.observer();
        return summary(input_.scene, world_, record_, seconds_) +
               (observer ? observed_text(*observer, world_) : std::string()) +
               verdicts(input_.scene, record_, Verdict::holds) +
               verdicts(input_.scene, record_, Verdict::not_judged);
    }

  private:
    void mark() { replay_.marks.push_back({world_.tick(), fingerprint(world_, game_)}); }
    void execute_due() {
        refused_ = runner_.execute_due(input_.scene, world_, game_, solver_);
        compare_with_recording();
    }
    void compare_with_recording();

    const RunInput& input_;
    RunOutputs& outputs_;
    World world_;
    GameState game_;
    Solver solver_;
    RunRecord record_;
    RuleLog log_;
    Replay replay_;
    ScriptRunner runner_;
    bool follows_recording_ = false;  ///< as far as seen
    std::size_t next_mark_ = 0;       ///< of the recording
    std::optional<ScriptRunner::Refused> refused_;
    std::optional<InvariantCheck> check_;
    std::optional<Breach> breach_;
    double seconds_ = 0.0;  ///< spent in the solver
};

// Says once if the run departs from the recording, as under other physics.
void Run::compare_with_recording() {
    if (!follows_recording_) return;
    const Replay& recording = *input_.recording;
    while (next_mark_ < recording.marks.size() && recording.marks[next_mark_].tick < world_.tick())
        ++next_mark_;
    if (next_mark_ == recording.marks.size() || recording.marks[next_mark_].tick != world_.tick() ||
        recording.marks[next_mark_].fingerprint ==
            fingerprint(world_, game_, recording.fingerprint_version))
        return;
    follows_recording_ = false;
    const std::string why = recording.physics_version == physics_version
                                ? ""
                                : fmt::format(": it is of physics {}, and this is physics {}",
                                              recording.physics_version, physics_version);
    print_note(fmt::format("note: at tick {} the run is no longer what was recorded{}\n",
                           world_.tick(), why));
}

void Run::simulate() {
    using Clock = std::chrono::steady_clock;
    Clock::duration cost{};
    log_.line(input_.scene, world_, game_);
    execute_due();
    mark();
    outputs_.write_start(world_);
    Progress progress(input_.ticks);
    while (world_.tick() < input_.ticks && !refused_ && InterruptGuard::signal() == 0) {
        if (check_) {
            check_->change_solver(solver_.settings().kind, world_);
            check_->note_start(world_);
        }
        const Clock::time_point before = Clock::now();
        const TickOutcome outcome =
            solver_.tick(world_, [] { return InterruptGuard::signal() == 0; });
        cost += Clock::now() - before;
        if (outcome == TickOutcome::cancelled) break;
        if (check_)
            breach_ =
                check_->note_tick(world_, outcome == TickOutcome::stood_still, solver_.contacts());
        update_game(input_.scene, world_, game_, solver_.contacts());
        note_tick(record_, input_.scene, world_, solver_, rule_state(game_));
        outputs_.write_tick(world_, solver_);
        if (outputs_.wants_log()) outputs_.write_log(log_.line(input_.scene, world_, game_));
        if (breach_) break;
        execute_due();
        if (world_.tick() % mark_interval(world_.rate()) == 0) mark();
        if (!outputs_.error().empty() || outputs_.is_pointless()) break;
        progress.update(world_.tick());
    }
    seconds_ = std::chrono::duration<double>(cost).count();
}

void Run::finish(const std::string& level) {
    record_.tallies = tallies(game_);
    record_.variables = variables(input_.scene, game_);
    if (world_.tick() == input_.ticks) note_end(record_, input_.scene, world_);
    if (runner_.remaining() > 0 && world_.tick() == input_.ticks && !input_.recording)
        print_note(fmt::format("note: {} of the commands were not due by the last tick, {}\n",
                               runner_.remaining(), input_.ticks));
    print_note(notes_text(record_.notes, world_.rate()));
    outputs_.write_report(report_json(level, input_.scene, world_, record_, seconds_));
    if (const Observer* observer = record_.watch.observer())
        outputs_.write_curves(curves_csv(*observer));
    if (replay_.marks.back().tick < world_.tick()) mark();
    replay_.commands = runner_.executed();
    replay_.end = replay_.position = world_.tick();
    outputs_.write_recording(replay_);
    outputs_.commit();
}

// False: it could not be printed.
bool explain(const RunOptions& options, const Scene& scene) {
    if (!to_standard_output(options)) return print_out(explanation(scene));
    print_note(explanation(scene));
    return true;
}

// A recording holds the texts of its level, whose files it does not read.
std::vector<std::string> files_read(const RunOptions& options, const RunInput& input) {
    if (input.recording) return {options.level};
    std::vector<std::string> files = input.scene.files;
    files.push_back(options.commands);
    return files;
}

int run_input(const RunOptions& options, const RunInput& input) {
    const SolverSettings settings = solver_for(input.scene);
    if (const std::optional<std::string> why = unavailable(settings.kind)) {
        print_error(*why);
        return 2;
    }
    if (const auto why = clash_of_outputs(paths_of_outputs(options), files_read(options, input))) {
        print_error(*why);
        return 2;
    }
    RunOutputs outputs(options);
    if (!outputs.error().empty()) {
        print_error(outputs.error());
        return 2;
    }
    if (options.explain && !explain(options, input.scene)) return 2;
    const InterruptGuard guard;
    Run run(options, input, settings, outputs);
    run.simulate();
    if (run.refused()) {
        print_note(told_refusal(options, input, *run.refused()));
        return 2;
    }
    run.finish(options.level);
    if (!outputs.error().empty()) {
        print_error(outputs.error());
        return 2;
    }
    if (!outputs.any() && !options.explain && !print_out(run.text())) return 2;
    print_note(verdicts(input.scene, run.record(), Verdict::fails));
    const std::optional<std::string> broken = run.broken();
    if (broken) print_error(*broken);
    return broken || has_failure(run.record()) ? 1 : 0;
}

}  // namespace

int run(const RunOptions& options) {
    const std::optional<RunInput> input = open_run_input(options);
    if (!input) return 2;
    const int code = run_input(options, *input);
    if (const int signal = InterruptGuard::signal()) die_of(signal);
    return code;
}

}  // namespace carom
