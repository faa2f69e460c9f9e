#pragma once

#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "level/text/text.h"

/// Collects the diagnostics of a load, at most one of each severity for each position.
namespace carom {

inline constexpr std::size_t max_diagnostics = 20;

/// Loading stops at this many errors: finding and describing more would take unbounded time.
inline constexpr std::size_t max_errors = 200;

/// Thrown to stop loading after a report, and caught by load_level.
struct LoadStopped {};

/// Invariant: there is at most one error and one warning for a line and column, so an error in a
/// statement that is repeated a thousand times is reported once.
class Reporter {
  public:
    /// Throws LoadStopped at the last of max_errors.
    void error(FaultCode code, const Span& at, std::string message, std::string remedy = {});
    /// Reports an error at a limit of the loader, and throws LoadStopped.
    [[noreturn]] void stop(FaultCode code, const Span& at, std::string message,
                           std::string remedy = {});
    void warning(FaultCode code, const Span& at, std::string message, std::string remedy = {});

    bool has_errors() const { return errors_ > 0; }
    /// The number of calls of error() so far. If it grew, a called function has reported an error.
    std::size_t errors() const { return errors_; }

    /// The first max_diagnostics, ordered by source, line and column, without the warnings at the
    /// places of errors. If there are more, errors come before warnings.
    std::vector<Diagnostic> diagnostics() const;

  private:
    void add(Severity severity, FaultCode code, const Span& at, std::string message,
             std::string remedy);

    struct Entry {
        int order = 0;
        Diagnostic diagnostic;
    };
    std::vector<Entry> entries_;
    std::set<std::tuple<Severity, int, int, int>> places_;
    std::size_t errors_ = 0;
};

/// "the name 'reds' is taken by the rack in line 7": for an error at `at`. `holder` is the keyword
/// of what has the name, at `holder_at`; its file is named if it is another.
std::string taken_message(const Span& at, std::string_view name, std::string_view holder,
                          const Span& holder_at);

}  // namespace carom
