#include "runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

#include "level_scene.h"

namespace carom::bench {
namespace {

constexpr std::int64_t tenth_of_a_second = 6;  // ticks

std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word)
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

// The command that starts the program; empty where it is absent.
std::string call_of(const Places& places, const std::string& program) {
    const bool is_script = program.ends_with(".mjs");
    const std::string path = (is_script ? places.scripts : places.programs) + "/" + program;
    if (!std::filesystem::exists(path)) return {};
    return (is_script ? "node " : "") + quoted(path);
}

// Derived from the duration of the first run, unmeasured ticks included; none where that run
// failed.
int runs_for(const Result& result, int rounds) {
    if (result.seconds.empty()) return 0;
    const double seconds = result.seconds.front() * result.ticks / result.measured;
    if (seconds >= 30.0) return 1;
    return seconds >= 10.0 ? std::min(rounds, 2) : rounds;
}

std::optional<Frame> frame_at(const std::vector<Frame>& frames, std::int64_t tick) {
    const auto found = std::ranges::find(frames, tick, &Frame::tick);
    if (found == frames.end()) return std::nullopt;
    return *found;
}

// carom's arguments, after the list and the frames.
std::vector<std::string> carom_arguments(const std::string& level, std::vector<std::string> scene,
                                         const std::vector<std::string>& own) {
    scene.insert(scene.begin(), level);
    scene.insert(scene.end(), own.begin(), own.end());
    return scene;
}

// A scene that is ready to be run.
struct Stage {
    const Places* places = nullptr;
    std::string level;
    std::vector<std::string> settings;
    World world;
    SceneList list;
    std::string list_path;
    std::string frames_path;
    std::optional<Frame> reference;
};

// All balls after 0.1 s, under the solver `event`.
std::optional<Frame> reference_of(const Stage& stage, const BenchScene& scene) {
    if (scene.sort != SceneSort::gas) return std::nullopt;
    SceneList head = stage.list;
    head.plan = {.ticks = tenth_of_a_second, .measured_from = 0, .sample_every = tenth_of_a_second};
    const std::string path = stage.places->scratch + "/reference.list";
    std::ofstream(path) << scene_list_text(head);
    const auto arguments = carom_arguments(stage.level, stage.settings, {"solver event"});
    if (!run_engine(*stage.places, "bench_carom", path, stage.frames_path, arguments))
        return std::nullopt;
    return frame_at(read_frames(stage.frames_path), tenth_of_a_second);
}

// Prepares the scene for one of its runs. None where that fails: `error` says why.
std::optional<Stage> stage_of(const Places& places, const BenchScene& scene, int run,
                              std::string& error) {
    std::vector<std::string> settings = scene.settings;
    std::ranges::copy(arrangement(scene, run), std::back_inserter(settings));
    const std::string level = places.scenes + "/" + scene.level;
    LoadedScene loaded = load_scene(level, settings);
    if (!loaded.scene) {
        error = loaded.error;
        return std::nullopt;
    }
    ListedScene listed = list_of(loaded.scene->world, scene.plan);
    if (!listed.list) {
        error = listed.error;
        return std::nullopt;
    }
    Stage stage{.places = &places,
                .level = level,
                .settings = std::move(settings),
                .world = std::move(loaded.scene->world),
                .list = std::move(*listed.list),
                .list_path = places.scratch + "/scene.list",
                .frames_path = places.scratch + "/run.frames",
                .reference = {}};
    std::ofstream(stage.list_path) << scene_list_text(stage.list);
    stage.reference = reference_of(stage, scene);
    return stage;
}

// Runs a contestant once. Where all runs are alike, only the first is judged.
void run_contestant(const Stage& stage, bool is_judged, Result& result) {
    std::vector<std::string> arguments;
    if (result.contestant.program == "bench_carom")
        arguments = carom_arguments(stage.level, stage.settings, result.contestant.settings);
    std::filesystem::remove(stage.frames_path);
    auto run = run_engine(*stage.places, result.contestant.program, stage.list_path,
                          is_judged ? stage.frames_path : "-", arguments);
    if (!run) return;
    result.engine = run->engine;
    result.ticks = run->figures["ticks"];
    result.measured = run->figures["measured"];
    result.seconds.push_back(run->figures["seconds"]);
    if (is_judged)
        result.judged.push_back(
            judge(stage.world, stage.list, read_frames(stage.frames_path), stage.reference));
}

// The median of the values that exist.
template <typename Figure>
std::optional<double> median_of(const std::vector<Accuracy>& judged, Figure figure) {
    std::vector<double> values;
    for (const Accuracy& accuracy : judged)
        if (const std::optional<double> value = figure(accuracy)) values.push_back(*value);
    if (values.empty()) return std::nullopt;
    return median(std::move(values));
}

}  // namespace

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

double Result::median_seconds() const {
    return median(seconds);
}

Accuracy Result::accuracy() const {
    const auto of = [&](auto member) {
        return median_of(judged, [&](const Accuracy& accuracy) {
            return std::optional<double>(accuracy.*member);
        });
    };
    return {.energy_drift = of(&Accuracy::energy_drift),
            .deepest_overlap = of(&Accuracy::deepest_overlap).value_or(0.0),
            .residual_speed = of(&Accuracy::residual_speed).value_or(0.0),
            .error = of(&Accuracy::error)};
}

std::optional<RunFigures> run_engine(const Places& places, const std::string& program,
                                     const std::string& list, const std::string& frames,
                                     const std::vector<std::string>& arguments) {
    const std::string call = call_of(places, program);
    if (call.empty()) return std::nullopt;
    std::string line = fmt::format("timeout 1800 {} {} {}", call, quoted(list), quoted(frames));
    for (const std::string& argument : arguments)
        line += " " + quoted(argument);
    line += " 2>" + quoted(places.scratch + "/errors");
    std::FILE* pipe = popen(line.c_str(), "r");
    if (!pipe) return std::nullopt;
    std::string output;
    std::array<char, 4096> part{};
    while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe))
        output.append(part.data(), size);
    if (pclose(pipe) != 0) return std::nullopt;
    RunFigures run;
    std::istringstream in(output);
    for (std::string word; in >> word;) {
        if (word == "engine") {
            std::getline(in >> std::ws, run.engine);
        } else {
            in >> run.figures[word];
        }
    }
    return run;
}

SceneResults run_scene(const Places& places, const BenchScene& scene, int rounds,
                       const std::function<void(const std::string&)>& say) {
    SceneResults all{.scene = scene};
    std::optional<Stage> stage = stage_of(places, scene, 0, all.error);
    if (!stage) return all;
    all.balls = stage->list.balls.size();

    std::vector<Result> results;
    for (const Contestant& contestant : scene.contestants)
        results.push_back({.contestant = contestant});
    for (int round = 0; round < rounds; ++round) {
        const bool differs = !arrangement(scene, round).empty();
        if (differs && !(stage = stage_of(places, scene, round, all.error))) break;
        for (Result& result : results) {
            if (round > 0 && round >= runs_for(result, rounds)) continue;
            say(fmt::format("{}: {}, run {}", scene.name, result.contestant.name, round + 1));
            run_contestant(*stage, round == 0 || differs, result);
        }
    }
    for (Result& result : results) {
        if (result.seconds.empty()) {
            all.absent.push_back(result.contestant.name);
        } else {
            all.results.push_back(std::move(result));
        }
    }
    return all;
}

}  // namespace carom::bench
