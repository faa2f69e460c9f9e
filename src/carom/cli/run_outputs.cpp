#include "carom/cli/run_outputs.h"

#include <fmt/format.h>

#include "lab/run/streams.h"

namespace carom {
namespace {

void open(std::optional<OutputFile>& file, const std::string& path) {
    if (!path.empty()) file.emplace(path);
}

}  // namespace

RunOutputs::RunOutputs(const RunOptions& options) {
    open(report_, options.report);
    open(events_, options.events);
    open(log_, options.log);
    open(trace_, options.trace);
    open(curves_, options.curves);
    open(record_, options.record);
}

void RunOutputs::write_start(const World& world) {
    if (trace_) trace_->write(trace_header(world) + trace_rows(world));
}

void RunOutputs::write_tick(const World& world, const Solver& solver) {
    if (events_) events_->write(event_lines(solver.contacts(), world.tick()));
    if (trace_) trace_->write(trace_rows(world));
}

void RunOutputs::write_log(std::string_view line) {
    if (log_ && !line.empty()) log_->write(line);
}

void RunOutputs::write_report(std::string_view json) {
    if (report_) report_->write(json);
}

void RunOutputs::write_curves(std::string_view csv) {
    if (curves_) curves_->write(csv);
}

void RunOutputs::write_recording(const Replay& replay) {
    if (record_) record_->write(replay_text(replay));
}

void RunOutputs::commit() {
    for (std::optional<OutputFile>* file : all())
        if (*file) (*file)->commit();
}

bool RunOutputs::is_pointless() {
    bool pointless = any();
    for (const std::optional<OutputFile>* file : all())
        if (*file && !((*file)->is_closed() && (*file)->error().empty())) pointless = false;
    return pointless;
}

std::string RunOutputs::error() {
    for (const std::optional<OutputFile>* file : all())
        if (*file && !(*file)->error().empty()) return (*file)->error();
    return {};
}

bool to_standard_output(const RunOptions& options) {
    return options.report == "-" || options.events == "-" || options.log == "-" ||
           options.trace == "-" || options.curves == "-" || options.record == "-";
}

std::vector<std::string> paths_of_outputs(const RunOptions& options) {
    return {options.report, options.events, options.log,
            options.trace,  options.curves, options.record};
}

}  // namespace carom
