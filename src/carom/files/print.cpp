#include "carom/files/print.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "carom/files/files.h"

namespace carom {
namespace {

std::string counted(std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

bool print_out(std::string_view text) {
    OutputFile out("-");
    out.write(text);
    out.commit();
    if (out.error().empty()) return true;
    print_error(out.error());
    return false;
}

void print_error(std::string_view sentence) {
    print_note(fmt::format("carom: error: {}\n", sentence));
}

void print_problems(std::span<const std::string> lines) {
    if (lines.empty()) return;
    const std::string& first = lines.front();
    const bool names_place =
        first.find(": error: ") != first.npos || first.find(": warning: ") != first.npos;
    if (names_place)
        print_note(first + '\n');
    else
        print_error(first);
    for (const std::string& line : lines.subspan(1))
        print_note(line + '\n');
}

void print_note(std::string_view note) {
    const std::string lines = printable_lines(note);
    std::string_view text = lines;
    while (!text.empty()) {
        const ssize_t put = ::write(STDERR_FILENO, text.data(), text.size());
        if (put > 0) text.remove_prefix(static_cast<std::size_t>(put));
        // Standard error failed too: there is nowhere to report it.
        if (put < 0 && errno != EINTR) return;
    }
}

void print_diagnostics(const std::vector<Diagnostic>& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics)
        print_note(render(diagnostic));
    if (diagnostics.size() < 2) return;
    const auto errors = static_cast<std::size_t>(
        std::ranges::count(diagnostics, Severity::error, &Diagnostic::severity));
    const std::size_t warnings = diagnostics.size() - errors;
    if (warnings == 0) return print_note(counted(errors, "error") + '\n');
    if (errors == 0) return print_note(counted(warnings, "warning") + '\n');
    print_note(fmt::format("{}, {}\n", counted(errors, "error"), counted(warnings, "warning")));
}

}  // namespace carom
