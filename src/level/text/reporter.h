#pragma once

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "level/text/text.h"

/// Collects what is wrong with a level: one message a place, whatever the order of finding.
namespace carom {

inline constexpr std::size_t max_diagnostics = 20;

/// Invariant: at most one error and one warning stand at the same line and column, so a statement
/// that is unrolled a thousand times complains once.
class Reporter {
  public:
    void error(FaultCode code, const Span& at, std::string message, std::string remedy = {});
    void warning(FaultCode code, const Span& at, std::string message, std::string remedy = {});

    bool has_errors() const { return errors_ > 0; }
    /// Errors so far: a caller that sees it grow knows that something it called has complained.
    std::size_t errors() const { return errors_; }

    /// The first max_diagnostics in order of source, line and column; warnings give way to errors.
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

}  // namespace carom
