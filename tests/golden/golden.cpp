#include "golden/golden.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "game/replay/replayer.h"
#include "golden/trace.h"
#include "level/load.h"
#include "physics/solver.h"
#include "physics/world/fingerprint.h"

namespace carom::test {
namespace {

namespace fs = std::filesystem;

// A tick of ten balls takes no time; one of thousands would take minutes in a debug build, and so
// would the bounces of a heap, all of which `event` computes.
std::uint64_t ticks_for(const World& world, SolverKind kind) {
    const bool may_heap = world.model().inelastic && world.model().gravity;
    if (may_heap && world.balls().size() > 200) return kind == SolverKind::event ? 15 : 30;
    if (kind == SolverKind::event && may_heap) return 120;
    return world.balls().size() > 200 ? 120 : 600;
}

std::optional<std::string> content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

LoadResult load(const fs::path& path) {
    LoadOptions options;
    options.resolve_include = [](std::string_view from,
                                 std::string_view what) -> std::optional<IncludedFile> {
        const fs::path file = fs::path(from).parent_path() / what;
        auto text = content(file);
        if (!text) return std::nullopt;
        return IncludedFile{file.string(), std::move(*text)};
    };
    return load_level(content(path).value_or(""), path.string(), options);
}

GoldenRun failed_run(std::string_view name, std::string_view reason) {
    return {.line = fmt::format("{}: {}", name, reason), .has_failed = true};
}

GoldenRun run_of(const std::string& level, const Scene& scene, SolverKind kind) {
    // A level's settings apply to its own solver.
    SolverSettings settings{.kind = kind};
    if (scene.solver && scene.solver->kind == kind) settings = *scene.solver;
    World world = scene.world;
    // A table at rest shows nothing, so break it, slightly off the straight line.
    if (scene.pool.cue)
        world.edit_balls().velocity[*index_of(world, scene.pool.cue->ball)] =
            Vec2{0.9, 0.02} * scene.pool.cue->most_power;
    Solver solver(settings);
    const std::uint64_t ticks = ticks_for(world, kind);
    TraceRecorder trace(world, ticks);
    while (world.tick() < ticks) {
        solver.tick(world);
        trace.note(world);
    }
    return {.line = fmt::format("{} {} {} {}", level, name(kind), ticks,
                                hexadecimal(fingerprint(world))),
            .ticks = ticks,
            .trace = trace.lines()};
}

GoldenRun run_of(const fs::path& path) {
    const std::string file = path.filename().string();
    auto read = read_replay(content(path).value_or(""));
    if (const auto* error = std::get_if<ReplayError>(&read))
        return failed_run(file, error->message);
    const Replay& replay = std::get<Replay>(read);
    auto scene = scene_of(replay);
    if (const auto* error = std::get_if<ReplayError>(&scene))
        return failed_run(file, error->message);
    Replayer replayer(replay, std::move(std::get<Scene>(scene)), 0);
    TraceRecorder trace(replayer.session().world(), replay.end);
    bool goes_on = true;
    while (goes_on) {
        goes_on = replayer.advance(1);
        trace.note(replayer.session().world());
    }
    if (replayer.failure()) return failed_run(file, *replayer.failure());
    const World& world = replayer.session().world();
    return {.line = fmt::format("{} {} {}", file, world.tick(), hexadecimal(fingerprint(world))),
            .ticks = replay.end,
            .trace = trace.lines()};
}

std::vector<fs::path> files_in(const std::string& folder, std::string_view extension) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == extension) paths.push_back(entry.path());
    std::ranges::sort(paths, {}, [](const fs::path& path) { return path.stem().string(); });
    return paths;
}

}  // namespace

std::vector<GoldenRun> golden_levels(const std::string& folder,
                                     const std::vector<std::string>& names) {
    std::vector<GoldenRun> runs;
    for (const fs::path& path : files_in(folder, ".level")) {
        const std::string level = path.stem().string();
        if (!names.empty() && std::ranges::count(names, level) == 0) continue;
        const LoadResult loaded = load(path);
        if (!loaded.scene) {
            runs.push_back(failed_run(level, render(loaded.diagnostics.front())));
            continue;
        }
        for (const SolverKind kind : solvers_available())
            if (supports(kind, loaded.scene->world.model()))
                runs.push_back(run_of(level, *loaded.scene, kind));
    }
    return runs;
}

std::vector<GoldenRun> golden_replays(const std::string& folder) {
    std::vector<GoldenRun> runs;
    for (const fs::path& path : files_in(folder, ".replay"))
        runs.push_back(run_of(path));
    return runs;
}

}  // namespace carom::test
