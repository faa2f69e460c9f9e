#include "carom/files/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "carom/files/files.h"
#include "carom/options/option_values.h"
#include "carom/text/version.h"
#include "game/replay/replayer.h"
#include "level/text/diagnostic.h"
#include "level/text/text.h"
#include "level/text/utf8.h"

namespace carom {
namespace {

/// About a day of dragging; a longer file is not a recording.
constexpr std::size_t most_bytes = std::size_t{256} << 20;

std::string_view line_of(std::string_view text, int line) {
    for (; line > 1 && !text.empty(); --line)
        text.remove_prefix(text.substr(0, text.find('\n')).size() + (text.find('\n') != text.npos));
    return text.substr(0, text.find('\n'));
}

}  // namespace

std::string rendered(const std::string& path, std::string_view text, const ReplayError& error) {
    const std::string_view line = line_of(text, error.line);
    Diagnostic diagnostic;
    diagnostic.file = path;
    diagnostic.line = error.line;
    diagnostic.length = std::max(1, characters(line));
    diagnostic.message = error.message;
    diagnostic.remedy = error.remedy;
    diagnostic.source = line;
    return render(diagnostic);
}

bool is_recording(const std::string& path) {
    constexpr std::string_view first_words = "carom replay ";
    const FileText file = read_file(path, first_words.size());
    return file.text && file.text->starts_with(first_words);
}

std::variant<OpenedReplay, std::string> open_replay(const std::string& path) {
    const FileText file = read_file(path, most_bytes);
    const auto error = [](const std::string& sentence) {
        return fmt::format("carom: error: {}\n", sentence);
    };
    if (!file.text) return error(file.error);
    if (file.text->size() > most_bytes)
        return error(fmt::format("'{}' has more than 256 MiB: it is no recording of carom", path));
    auto read = read_replay(*file.text);
    if (const auto* fault = std::get_if<ReplayError>(&read))
        return rendered(path, *file.text, *fault);
    Replay& replay = std::get<Replay>(read);
    auto scene = scene_of(replay);
    if (const auto* fault = std::get_if<ReplayError>(&scene))
        return rendered(path, *file.text, *fault);
    if (const auto why_not = unavailable(replay.solver.kind)) return error(*why_not);
    return OpenedReplay{std::move(replay), std::move(std::get<Scene>(scene))};
}

std::string name_in_recording(const std::string& level) {
    return std::filesystem::path(level).filename().string();
}

std::optional<std::string> Recording::obstacle() const {
    if (path_ == "-") return "a recording is a file: standard output is the screen's";
    const OutputFile probe(path_);
    if (probe.error().empty()) return std::nullopt;
    return probe.error();
}

std::optional<std::string> Recording::write(const Session& session, const std::string& level,
                                            std::span<const std::string> overrides,
                                            int opponent) const {
    Replay replay = record(session, name_in_recording(level), overrides);
    replay.program = version();
    replay.opponent = opponent;
    return write_file_atomically(path_, replay_text(replay), Access::everybody, existing_);
}

}  // namespace carom
