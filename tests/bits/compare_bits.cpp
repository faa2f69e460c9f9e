// Compares the bits that two programs compute: runs both on random scenes and recordings, and
// compares all their output except cost and fingerprint. See scripts/compare-bits.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "bits/kept_outputs.h"
#include "bits/level_writer.h"
#include "bits/recording_writer.h"
#include "bits/scene_random.h"

namespace fs = std::filesystem;

namespace carom::bits {
namespace {

constexpr rlim_t most_seconds = 20;  ///< of processor time, for one run of one program
constexpr int most_refusals = 12;    ///< commands removed from a recording before it is abandoned

/// The result of one run of one program: the name of an output, and its text.
struct Output {
    std::string name;
    std::string text;
};
using Outputs = std::vector<Output>;

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

// Lines of a report that differ between any two programs.
std::string without_cost(const std::string& report) {
    std::string kept;
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);)
        if (line.find("\"cost\":") == std::string::npos &&
            line.find("\"fingerprint\":") == std::string::npos)
            kept += line + '\n';
    return kept;
}

/// Runs a program in `folder`, with standard output and error in the files `out` and `err` there;
/// returns how it ended.
std::string run(const std::vector<std::string>& words, const fs::path& folder) {
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const std::string where = folder.string();
    const pid_t child = fork();
    if (child == 0) {
        const rlimit limit{most_seconds, most_seconds};
        setrlimit(RLIMIT_CPU, &limit);
        if (chdir(where.c_str()) != 0) _exit(99);
        dup2(open("out", O_WRONLY | O_CREAT | O_TRUNC, 0600), 1);
        dup2(open("err", O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
        execv(arguments[0], arguments.data());
        _exit(98);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
    return "signal " + std::to_string(WTERMSIG(status));
}

/// One random scene of a seed: a level to run, or a recording to verify.
struct Case {
    std::string file;
    std::string text;
    std::vector<std::string> arguments;  ///< of carom
    std::vector<TimedLine> commands;     ///< of a recording
    Level level;
    std::string solver;
};

Case case_of(std::uint64_t seed) {
    Random random(seed);
    Case made;
    const bool is_recording = random.chance(0.35);
    made.level = write_level(random);
    made.level.radius = std::min(made.level.width, made.level.height) / 20.0;
    if (is_recording) {
        made.file = "fuzzed.replay";
        made.arguments = {"verify", "../fuzzed.replay"};
        made.commands = write_commands(random, made.level);
        made.solver = write_solver(random, made.level.has_cloth);
        made.text = write_recording(made.level, made.solver, made.commands);
    } else {
        made.file = "fuzzed.level";
        made.text = made.level.text;
        made.arguments = {
            "run",      "../fuzzed.level", "--ticks",  std::to_string(made.level.ticks),
            "--trace",  "trace",           "--events", "events",
            "--report", "report"};
    }
    return made;
}

Outputs outputs(const std::string& carom, const Case& made, const fs::path& folder) {
    for (const char* name : {"trace", "events", "report"})
        fs::remove(folder / name);
    std::vector<std::string> words = {carom};
    words.insert(words.end(), made.arguments.begin(), made.arguments.end());
    const std::string ended = run(words, folder);
    // The output so far depends on the clock.
    if (ended.starts_with("signal")) return {{"its end", ended}};
    Outputs all = {{"its end", ended},
                   {"standard error", read(folder / "err")},
                   {"standard output", read(folder / "out")}};
    if (made.commands.empty() && made.file == "fuzzed.level") {
        all.push_back({"the trace", read(folder / "trace")});
        all.push_back({"the events", read(folder / "events")});
        all.push_back({"the report", without_cost(read(folder / "report"))});
    }
    return all;
}

// The tick of the command that the game refused, in a recording that was rejected for it.
std::optional<int> refused_at(const Outputs& outputs) {
    constexpr std::string_view words = "it differs at tick ";
    if (outputs.size() < 3) return std::nullopt;
    const std::string& text = outputs[2].text;
    const std::size_t place = text.find(words);
    if (place == std::string::npos) return std::nullopt;
    return std::atoi(text.c_str() + place + words.size());
}

/// Describes the first difference, if there is one.
std::optional<std::string> difference(const Outputs& old_outputs, const Outputs& new_outputs) {
    for (std::size_t i = 0; i < std::min(old_outputs.size(), new_outputs.size()); ++i) {
        if (old_outputs[i].text == new_outputs[i].text) continue;
        std::istringstream old_lines(old_outputs[i].text), new_lines(new_outputs[i].text);
        std::string old_line, new_line;
        for (int line = 1;; ++line) {
            const bool more_old = static_cast<bool>(std::getline(old_lines, old_line));
            const bool more_new = static_cast<bool>(std::getline(new_lines, new_line));
            if (more_old && more_new && old_line == new_line) continue;
            return old_outputs[i].name + ", line " + std::to_string(line) +
                   "\n  old: " + (more_old ? old_line : "(ends)") +
                   "\n  new: " + (more_new ? new_line : "(ends)");
        }
    }
    return std::nullopt;
}

std::uint64_t digest(const Outputs& outputs) {
    std::string all;
    for (const Output& output : outputs)
        all += output.text + '\0';
    return level_hash(all);
}

class Comparison {
  public:
    Comparison(std::string old_carom, std::string new_carom, fs::path folder, fs::path kept)
        : old_(std::move(old_carom)),
          new_(std::move(new_carom)),
          folder_(std::move(folder)),
          kept_(std::move(kept)),
          memory_(kept_ / "old-outputs") {}

    /// Compares seeds first, first + 1, ... with as many threads as there are cores.
    void run(std::uint64_t first, std::uint64_t count) {
        next_ = first;
        end_ = first + count;
        std::vector<std::thread> threads;
        for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
            threads.emplace_back([this, i] { work(folder_ / std::to_string(i)); });
        for (std::thread& thread : threads)
            thread.join();
    }

    int summary() const {
        std::cout << equal_ + differ_ << " scenes compared (" << recordings_
                  << " of them recordings), " << unloadable_ << " that do not load; " << differ_
                  << " differ\n";
        return differ_ == 0 ? 0 : 1;
    }

  private:
    void work(const fs::path& folder) {
        fs::create_directories(folder / "old");
        fs::create_directories(folder / "new");
        for (std::uint64_t seed = next_++; seed < end_; seed = next_++)
            compare(seed, folder);
    }

    void compare(std::uint64_t seed, const fs::path& folder) {
        Case made = case_of(seed);
        const auto remembered = memory_.find(seed);
        Outputs before;
        std::vector<int> refused;
        if (remembered) {
            for (const int tick : remembered->refused)
                leave_out(made, tick);
            write(folder / made.file, made.text);
        } else {
            before = old_outputs(made, folder, refused);
            memory_.add(seed, {digest(before), refused});
        }
        const Outputs after = outputs(new_, made, folder / "new");
        const std::uint64_t expected = remembered ? remembered->digest : digest(before);
        if (after[0].text == "exit code 2") ++unloadable_;
        if (made.file == "fuzzed.replay") ++recordings_;
        if (digest(after) == expected) {
            ++equal_;
            return;
        }
        if (remembered) before = outputs(old_, made, folder / "old");
        if (const auto found = difference(before, after)) {
            ++differ_;
            tell(seed, made, *found);
        } else {
            ++equal_;
        }
    }

    // Without the commands of that tick.
    static void leave_out(Case& made, int tick) {
        std::erase_if(made.commands, [&](const TimedLine& line) { return line.tick == tick; });
        made.text = write_recording(made.level, made.solver, made.commands);
    }

    // A refused command ends a recording: try again without the commands of that tick.
    Outputs old_outputs(Case& made, const fs::path& folder, std::vector<int>& refused) {
        write(folder / made.file, made.text);
        Outputs before = outputs(old_, made, folder / "old");
        while (static_cast<int>(refused.size()) < most_refusals) {
            const auto tick = refused_at(before);
            if (!tick || made.commands.empty()) break;
            refused.push_back(*tick);
            leave_out(made, *tick);
            write(folder / made.file, made.text);
            before = outputs(old_, made, folder / "old");
        }
        return before;
    }

    void tell(std::uint64_t seed, const Case& made, const std::string& found) {
        const std::lock_guard guard(telling_);
        const fs::path kept = std::to_string(seed) + "-" + made.file;
        const fs::path path = kept_ / kept;
        write(path, made.text);
        std::cout << "seed " << seed << ": " << path.string() << " (" << made.level.ticks
                  << " ticks): " << found << '\n'
                  << std::flush;
    }

    std::string old_, new_;
    fs::path folder_;  ///< for files of one run, preferably in memory
    fs::path kept_;    ///< for differing outputs, and results of the old program
    KeptOutputs memory_;
    std::atomic<std::uint64_t> next_ = 0;
    std::uint64_t end_ = 0;
    std::atomic<std::uint64_t> equal_ = 0, differ_ = 0, recordings_ = 0, unloadable_ = 0;
    std::mutex telling_;
};

}  // namespace
}  // namespace carom::bits

int main(int argc, char** argv) {
    if (argc == 2) {
        std::cout << carom::bits::case_of(std::strtoull(argv[1], nullptr, 10)).text;
        return 0;
    }
    if (argc != 7) {
        std::cerr << "usage: compare_bits OLD_CAROM NEW_CAROM COUNT FIRST_SEED SCRATCH KEPT\n"
                     "       compare_bits SEED    prints that seed's level or recording\n";
        return 2;
    }
    carom::bits::Comparison comparison(fs::canonical(argv[1]), fs::canonical(argv[2]), argv[5],
                                       argv[6]);
    comparison.run(std::strtoull(argv[4], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
    return comparison.summary();
}
