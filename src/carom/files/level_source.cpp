#include "carom/files/level_source.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace carom {
namespace {

void add_lines(std::vector<std::string>& lines, std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

// Relative to the current folder, if it lies there, else the name of the file.
std::string shown_path(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path relative = fs::proximate(path, error);
    if (error || relative.empty() || *relative.begin() == "..")
        return fs::path(path).filename().string();
    return relative.string();
}

Problems problems_of(const LoadedLevel& loaded) {
    Problems problems;
    if (!loaded.error.empty()) problems.push_back(loaded.error);
    for (const Diagnostic& diagnostic : loaded.result.diagnostics)
        add_lines(problems, render(diagnostic));
    // In a window of 80 columns a long path leaves no room for the message.
    const std::string shown = shown_path(loaded.path);
    for (std::string& line : problems)
        if (!loaded.path.empty() && line.starts_with(loaded.path + ":"))
            line.replace(0, loaded.path.size(), shown);
    return problems;
}

}  // namespace

Problems lines_of(std::string_view text) {
    Problems lines;
    add_lines(lines, text);
    return lines;
}

LevelSource source_of(const PlayOptions& options, const std::string& argument) {
    return {argument,     options.solver,    options.rate,
            options.seed, options.overrides, options.rewind_bytes};
}

LevelSource source_of(const Replay& replay, std::size_t rewind_bytes) {
    return {replay.level, std::nullopt, replay.rate, replay.seed, replay.overrides, rewind_bytes};
}

LoadedLevel load(const LevelSource& source) {
    LoadOptions options;
    options.overrides = source.overrides;
    options.seed = source.seed;
    options.rate = source.rate;
    options.solver = source.solver;
    return load_level_file(source.path, std::move(options));
}

LoadedLevel load(const Replay& replay, std::size_t rewind_bytes) {
    LoadedLevel loaded = load(source_of(replay, rewind_bytes));
    const auto& now = loaded.result.scene;
    if (now && now->text_hash == replay.level_hash) return loaded;
    auto recorded = scene_of(replay);
    if (auto* const scene = std::get_if<Scene>(&recorded)) {
        loaded.error.clear();
        loaded.result.diagnostics.clear();
        loaded.result.scene = std::move(*scene);
    }
    return loaded;
}

SolverSettings solver_of(const Scene& scene) {
    return scene.solver ? *scene.solver : pick_solver(scene.world).settings;
}

std::variant<OpenedGame, Problems> open_game(const LevelSource& source) {
    LoadedLevel loaded = load(source);
    if (!loaded.result.scene) return problems_of(loaded);
    std::vector<std::string> warnings;
    for (const Diagnostic& diagnostic : loaded.result.diagnostics) {
        std::vector<std::string> lines;
        add_lines(lines, render(diagnostic));
        if (!lines.empty()) warnings.push_back(lines.front());
    }
    Scene& scene = *loaded.result.scene;
    const bool is_picked = !scene.solver;
    const SolverSettings solver = solver_of(scene);
    return OpenedGame{Session(std::move(scene), solver, source.rewind_bytes), is_picked,
                      std::move(warnings)};
}

std::variant<Replayer, Problems> reopen_game(const Replay& replay, std::size_t rewind_bytes) {
    LoadedLevel loaded = load(replay, rewind_bytes);
    if (!loaded.result.scene) return problems_of(loaded);
    const auto is_available = [](SolverKind kind) {
        return std::ranges::count(solvers_available(), kind) > 0;
    };
    if (!is_available(replay.solver.kind))
        return Problems{"The game was played with a solver that this carom does not have."};
    return Replayer(replay, std::move(*loaded.result.scene), rewind_bytes);
}

}  // namespace carom
