#include "carom/cli/measure.h"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <functional>
#include <optional>
#include <utility>

#include "carom/cli/interrupt.h"
#include "carom/cli/load_and_report.h"
#include "carom/cli/open_recording.h"
#include "carom/cli/progress.h"
#include "carom/files/files.h"
#include "carom/files/output_clash.h"
#include "carom/files/print.h"
#include "carom/files/recording.h"
#include "lab/measure/measure.h"
#include "lab/measure/measure_data.h"
#include "lab/measure/measure_text.h"

namespace carom {
namespace {

// Of the processor, so that other programs on the machine do not count.
double clock_seconds() {
    std::timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

MeasureSettings settings_of(const MeasureOptions& options) {
    MeasureSettings settings{
        .rates = options.rates, .solvers = options.solvers, .horizon = options.horizon};
    if (options.time) settings.time = *options.time;
    if (options.repeats) settings.repeats = *options.repeats;
    if (options.tolerance) settings.tolerance = *options.tolerance;
    return settings;
}

std::optional<Measurement> measure_with_bar(const Scene& scene, const MeasureSettings& settings) {
    ProgressOrSignal go_on;
    return measure(scene, settings, {.clock = clock_seconds, .go_on = std::ref(go_on)});
}

std::string text_of(const MeasureOptions& options, const Scene& scene,
                    const Measurement& measurement) {
    std::string text = measure_text(scene.title.empty() ? options.level : scene.title, measurement);
    text += '\n' + own_answer(measurement);
    if (options.budget) text += budget_answer(measurement, *options.budget);
    // Without any question, the one that most people have.
    if (options.tolerance || !options.budget)
        text += tolerance_answer(measurement, measurement.tolerance);
    return text;
}

// The output files. They are opened before the work begins, so that one that cannot be written is
// reported at once.
class Outputs {
  public:
    explicit Outputs(const MeasureOptions& options) {
        if (!options.csv.empty()) csv_.emplace(options.csv);
        if (!options.json.empty()) json_.emplace(options.json);
    }

    std::string error() const {
        for (const std::optional<OutputFile>* file : {&csv_, &json_}) {
            if (*file && !(*file)->error().empty()) return (*file)->error();
        }
        return {};
    }

    void write(const MeasureOptions& options, const Measurement& measurement) {
        if (csv_) {
            csv_->write(measure_csv(measurement));
            csv_->commit();
        }
        if (json_) {
            json_->write(
                measure_json(options.level, measurement, options.budget, options.tolerance));
            json_->commit();
        }
    }

  private:
    std::optional<OutputFile> csv_;
    std::optional<OutputFile> json_;
};

// A level, or a recording with its commands.
struct Measurable {
    Scene scene;
    std::vector<TimedCommand> commands;
    std::optional<double> time;      ///< s: the length of a recording
    std::vector<std::string> files;  ///< from which it was read
};

std::optional<Measurable> open_recorded(const MeasureOptions& options) {
    std::optional<OpenedReplay> opened =
        open_recording(options.level, {{"--rate", options.rate.has_value()},
                                       {"--seed", options.seed.has_value()},
                                       {"--set", !options.overrides.empty()}});
    if (!opened) return std::nullopt;
    auto& [replay, scene] = *opened;
    scene.solver = replay.solver;
    const double time = static_cast<double>(replay.end) / scene.world.rate();
    return Measurable{std::move(scene), std::move(replay.commands), time, {options.level}};
}

// None: an error, which has been printed.
std::optional<Measurable> open(const MeasureOptions& options) {
    if (is_recording(options.level)) return open_recorded(options);
    LoadedLevel level = load_and_report(
        options.level,
        {.overrides = options.overrides, .seed = options.seed, .rate = options.rate});
    if (!level.result.scene) return std::nullopt;
    Scene& scene = *level.result.scene;
    std::vector<std::string> files = scene.files;
    return Measurable{std::move(scene), {}, std::nullopt, std::move(files)};
}

int measure_scene(const MeasureOptions& options, const Measurable& measurable) {
    const Scene& scene = measurable.scene;
    for (const SolverKind kind : options.solvers) {
        if (supports(kind, scene.world.model())) continue;
        print_error(fmt::format("solver {} does not know {}", name(kind),
                                scene.world.model().hinged ? "seesaws" : "cloth"));
        return 2;
    }
    const std::array<std::string, 2> paths{options.csv, options.json};
    if (const auto why = clash_of_outputs(paths, measurable.files)) {
        print_error(*why);
        return 2;
    }
    Outputs outputs(options);
    if (!outputs.error().empty()) {
        print_error(outputs.error());
        return 2;
    }
    const InterruptGuard guard;
    MeasureSettings settings = settings_of(options);
    settings.commands = measurable.commands;
    if (!options.time && measurable.time && *measurable.time > 0.0)
        settings.time = *measurable.time;
    const std::optional<Measurement> measurement = measure_with_bar(scene, settings);
    if (!measurement) return 0;
    outputs.write(options, *measurement);
    if (!outputs.error().empty()) {
        print_error(outputs.error());
        return 2;
    }
    const bool has_standard_output = options.csv == "-" || options.json == "-";
    if (!has_standard_output && !print_out(text_of(options, scene, *measurement))) return 2;
    if (InterruptGuard::signal() != 0)
        print_note("carom: interrupted: choices that were not complete are left out\n");
    return 0;
}

}  // namespace

int measure(const MeasureOptions& options) {
    const std::optional<Measurable> measurable = open(options);
    if (!measurable) return 2;
    const int code = measure_scene(options, *measurable);
    if (const int signal = InterruptGuard::signal()) die_of(signal);
    return code;
}

}  // namespace carom
