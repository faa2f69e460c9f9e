#include "level/text/reporter.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

constexpr std::size_t most_kept = 1000;  // bounds the memory that a file full of warnings can take

std::tuple<int, int, int, Severity> rank(int order, const Diagnostic& d) {
    return {order, d.line, d.column, d.severity};
}

}  // namespace

void Reporter::error(FaultCode code, const Span& at, std::string message, std::string remedy) {
    add(Severity::error, code, at, std::move(message), std::move(remedy));
    if (++errors_ >= max_errors) throw LoadStopped{};
}

void Reporter::stop(FaultCode code, const Span& at, std::string message, std::string remedy) {
    ++errors_;
    add(Severity::error, code, at, std::move(message), std::move(remedy));
    throw LoadStopped{};
}

void Reporter::warning(FaultCode code, const Span& at, std::string message, std::string remedy) {
    add(Severity::warning, code, at, std::move(message), std::move(remedy));
}

void Reporter::add(Severity severity, FaultCode code, const Span& at, std::string message,
                   std::string remedy) {
    const int order = at.source ? at.source->order : 0;
    if (severity == Severity::warning && entries_.size() >= most_kept) return;
    if (!places_.insert({severity, order, at.line, at.column}).second) return;
    Diagnostic d;
    d.severity = severity;
    d.code = code;
    d.line = at.line;
    d.column = at.column;
    d.length = std::max(1, at.length);
    d.message = std::move(message);
    d.remedy = std::move(remedy);
    if (at.source) {
        d.file = at.source->name;
        d.included_from = at.source->included_from;
        const auto index = static_cast<std::size_t>(at.line - 1);
        if (index < at.source->lines.size()) d.source = legible(at.source->lines[index]);
    }
    entries_.push_back({order, std::move(d)});
}

std::vector<Diagnostic> Reporter::diagnostics() const {
    std::vector<Entry> sorted;
    // A warning at the place of an error is likely to follow from it.
    for (const Entry& e : entries_) {
        const Diagnostic& d = e.diagnostic;
        if (d.severity == Severity::error ||
            !places_.contains({Severity::error, e.order, d.line, d.column}))
            sorted.push_back(e);
    }
    const auto by_severity = [](const Entry& e) { return e.diagnostic.severity; };
    const auto by_place = [](const Entry& e) { return rank(e.order, e.diagnostic); };
    std::ranges::sort(sorted, {}, by_place);
    if (sorted.size() > max_diagnostics) {
        std::ranges::stable_sort(sorted, {}, by_severity);
        sorted.resize(max_diagnostics);
        std::ranges::sort(sorted, {}, by_place);
    }
    std::vector<Diagnostic> result;
    for (Entry& e : sorted)
        result.push_back(std::move(e.diagnostic));
    return result;
}

std::string taken_message(const Span& at, std::string_view name, std::string_view holder,
                          const Span& holder_at) {
    const bool is_elsewhere = holder_at.source && holder_at.source != at.source;
    return fmt::format("the name '{}' is taken by the {} in line {}{}", name, holder,
                       holder_at.line,
                       is_elsewhere ? fmt::format(" of {}", holder_at.source->name) : "");
}

}  // namespace carom
