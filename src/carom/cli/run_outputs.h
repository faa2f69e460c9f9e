#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/files/files.h"
#include "carom/options/options.h"
#include "game/replay/replay_text.h"
#include "physics/solver.h"
#include "physics/world/world.h"

namespace carom {

/// The outputs of a run. At most one of them is standard output.
class RunOutputs {
  public:
    /// Opens those that are asked for; see `error`.
    explicit RunOutputs(const RunOptions& options);

    bool any() const { return report_ || events_ || log_ || trace_ || curves_ || record_; }

    void write_start(const World& world);
    void write_tick(const World& world, const Solver& solver);
    /// What the rules did. `wants_log` says whether anybody reads it.
    bool wants_log() const { return log_.has_value(); }
    void write_log(std::string_view line);
    void write_report(std::string_view json);
    void write_curves(std::string_view csv);
    void write_recording(const Replay& replay);
    void commit();

    /// Whether every output is a pipe that its reader has closed, so that the run may end.
    bool is_pointless();
    /// The first error; empty: none.
    std::string error();

  private:
    std::array<std::optional<OutputFile>*, 6> all() {
        return {&report_, &events_, &log_, &trace_, &curves_, &record_};
    }

    std::optional<OutputFile> report_;
    std::optional<OutputFile> events_;
    std::optional<OutputFile> log_;
    std::optional<OutputFile> trace_;
    std::optional<OutputFile> curves_;
    std::optional<OutputFile> record_;
};

/// Whether one of the outputs is standard output.
bool to_standard_output(const RunOptions& options);

/// The paths of the outputs; empty: not written.
std::vector<std::string> paths_of_outputs(const RunOptions& options);

}  // namespace carom
