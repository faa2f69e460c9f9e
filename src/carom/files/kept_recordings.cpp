#include "carom/files/kept_recordings.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "carom/files/files.h"
#include "carom/files/recording.h"
#include "carom/files/user_folders.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view recording_extension = ".replay";
/// A longer file is listed without its level and length: reading it would delay the menu. Bytes.
constexpr std::size_t most_looked_at = std::size_t{4} << 20;

KeptRecording kept(const std::string& path) {
    KeptRecording recording{fs::path(path).stem().string(), path, ""};
    const FileText file = read_file(path, most_looked_at);
    if (!file.text || file.text->size() > most_looked_at) return recording;
    const auto read = read_replay(*file.text);
    const auto* const replay = std::get_if<Replay>(&read);
    if (!replay || !(replay->rate > 0.0)) return recording;
    recording.level = fs::path(replay->level).stem().string();
    recording.seconds = static_cast<double>(replay->end) / replay->rate;
    return recording;
}

}  // namespace

std::optional<std::string> recordings_folder() {
    const auto data = data_folder();
    if (!data) return std::nullopt;
    return *data + "/recordings";
}

std::string recording_path(const std::string& name) {
    return recordings_folder().value_or(".") + "/" + name + std::string(recording_extension);
}

std::vector<KeptRecording> kept_recordings() {
    const auto folder = recordings_folder();
    std::vector<std::pair<fs::file_time_type, std::string>> files;
    std::error_code error;
    if (folder)
        for (const auto& entry : fs::directory_iterator(*folder, error))
            if (entry.path().extension() == recording_extension &&
                is_recording(entry.path().string()))
                files.emplace_back(entry.last_write_time(error), entry.path().string());
    std::ranges::sort(files, std::greater{});
    std::vector<KeptRecording> recordings;
    for (const auto& [time, path] : files)
        recordings.push_back(kept(path));
    return recordings;
}

std::string free_recording_name(const std::string& level) {
    const std::string stem = fs::path(level).stem().string();
    std::error_code error;
    for (int n = 1;; ++n) {
        std::string name = fmt::format("{}-{}", stem, n);
        if (!fs::exists(recording_path(name), error)) return name;
    }
}

}  // namespace carom
