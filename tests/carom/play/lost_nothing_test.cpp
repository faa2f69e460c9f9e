#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "carom/cli/run.h"
#include "carom/files/high_scores.h"
#include "carom/files/recording.h"
#include "carom/play/preferences.h"
#include "carom/play/resume.h"
#include "carom/support/file_faults.h"
#include "carom/support/home.h"
#include "carom/support/process.h"

// Whatever call of the file system fails, and wherever the process dies, nothing that was kept
// before is lost, and what was said to be kept is there.

using namespace carom;
using carom::test::content;
using carom::test::file_calls;
using carom::test::FileFault;
using carom::test::set_file_fault;
using carom::test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

/// What is kept in a folder: something older, which must not be lost, and something newer.
struct Kept {
    bool older = false;
    bool newer = false;
};

struct Keeping {
    const char* name;
    std::function<void()> keep_older;
    std::function<bool()> keep_newer;  ///< whether it says that the newer is kept
    std::function<Kept()> kept;        ///< as another process finds it
};

Replay replay_until(std::uint64_t end) {
    Replay replay;
    replay.level = "gas.level";
    replay.texts = {"carom 1 \"A\"\n"};
    replay.end = end;
    replay.position = end;
    return replay;
}

const std::string level = CAROM_SOURCE_DIR "/levels/cradle.level";

bool run_and_record(std::uint64_t ticks) {
    RunOptions options;
    options.level = level;
    options.ticks = ticks;
    options.record = "out.replay";
    return run(options) == 0;
}

std::vector<Keeping> all_that_is_kept() {
    return {
        {"high scores",
         [] {
             keep_high_score("a", 5, {"AAA", 100});
         },
         [] {
             return !keep_high_score("a", 5, {"BBB", 50}).problem;
         },
         [] {
             const auto lines = load_high_scores("a", 5).scores.lines;
             return Kept{std::ranges::count(lines, HighScore{"AAA", 100}) == 1,
                         std::ranges::count(lines, HighScore{"BBB", 50}) == 1};
         }},
        {"preferences", [] { write_preference("trails", "on"); },
         [] { return !write_preference("bell", "on"); },
         [] {
             const auto read = read_preferences(content(*preferences_path()), "");
             return Kept{read.preferences.trails && read.problems.empty(), read.preferences.bell};
         }},
        {"an unfinished game",
         [] { ResumeFile(*resume_folder(), "gas.level").save(replay_until(1)); },
         // Resumed, saved under its new name, and only then forgotten under the old one.
         [] {
             const auto games = interrupted_games(*resume_folder());
             ResumeFile file(*resume_folder(), "gas.level");
             if (file.save(replay_until(2))) return false;
             forget(games.front());
             return !file.save(replay_until(3));
         },
         [] {
             Kept kept;
             for (const InterruptedGame& game : interrupted_games(*resume_folder())) {
                 kept.older = true;
                 kept.newer = kept.newer || game.replay.end == 3;
             }
             return kept;
         }},
        {"a match that is left",
         [] { ResumeFile(*resume_folder(), "gas.level").save(replay_until(1)); },
         [] {
             ResumeFile file(*resume_folder(), "gas.level");
             return !file.save(replay_until(2)) && file.put_aside();
         },
         [] {
             Kept kept;
             for (const InterruptedGame& game : interrupted_games(*resume_folder())) {
                 kept.older = kept.older || game.replay.end == 1;
                 kept.newer = kept.newer || game.replay.end == 2;
             }
             return kept;
         }},
        {"run --record", [] { run_and_record(7); }, [] { return run_and_record(9); },
         [] {
             auto opened = open_replay("out.replay");
             const auto* found = std::get_if<OpenedReplay>(&opened);
             const std::uint64_t end = found ? found->replay.end : 0;
             return Kept{end == 7 || end == 9, end == 9};
         }},
    };
}

// A home whose working folder is empty.
struct Place {
    carom::test::Home home;
    Place() { ::setenv("XDG_DATA_HOME", (home.path / "data").c_str(), 1); }
    Place(const Place&) = delete;
    ~Place() { ::unsetenv("XDG_DATA_HOME"); }
};

// How often it calls the file system if nothing fails.
int calls_of(const Keeping& keeping) {
    const Place place;
    keeping.keep_older();
    set_file_fault(FileFault::none, 0);
    REQUIRE(keeping.keep_newer());
    const int calls = file_calls();
    REQUIRE(keeping.kept().newer);
    return calls;
}

}  // namespace

TEST_CASE("whatever fails while something is kept, nothing older is lost") {
    for (const Keeping& keeping : all_that_is_kept()) {
        CAPTURE(std::string(keeping.name));
        const int calls = calls_of(keeping);
        REQUIRE(calls >= 4);
        for (int number = 1; number <= calls; ++number) {
            CAPTURE(number);
            const Place place;
            keeping.keep_older();
            REQUIRE(keeping.kept().older);
            set_file_fault(FileFault::full_disk, number);
            const bool is_said = keeping.keep_newer();
            set_file_fault(FileFault::none, 0);
            const Kept kept = keeping.kept();
            CHECK(kept.older);
            if (is_said) CHECK(kept.newer);
        }
    }
}

TEST_CASE("wherever the process dies while something is kept, nothing older is lost") {
    for (const Keeping& keeping : all_that_is_kept()) {
        CAPTURE(std::string(keeping.name));
        bool has_died = true;
        for (int number = 1; has_died; ++number) {
            CAPTURE(number);
            const Place place;
            keeping.keep_older();
            const pid_t child = ::fork();
            REQUIRE(child >= 0);
            if (child == 0) {
                set_file_fault(FileFault::death, number);
                ::_exit(keeping.keep_newer() ? 0 : 1);
            }
            int status = 0;
            REQUIRE(::waitpid(child, &status, 0) == child);
            has_died = WEXITSTATUS(status) == 9;
            const Kept kept = keeping.kept();
            CHECK(kept.older);
            if (!has_died) CHECK(kept.newer);
        }
    }
}

TEST_CASE("a resumed game that cannot be saved again stays under its old name") {
    for (int number = 1; number <= 6; ++number) {
        CAPTURE(number);
        const Place place;
        PlayOptions options;
        options.level = level;
        {
            carom::test::Running first(options);
            REQUIRE_FALSE(first.program.start());
            first.pass(1.0);
            first.program.interrupt();
        }
        REQUIRE(interrupted_games(*resume_folder()).size() == 1);
        {
            options.resume = true;
            carom::test::Running second(options);
            REQUIRE_FALSE(second.program.start());
            set_file_fault(FileFault::full_disk, number);
            for (int i = 0; i < 100 && !second.program.is_playing(); ++i)
                second.pass(0.1);
            CHECK(second.program.is_playing());
            set_file_fault(FileFault::none, 0);
        }
        CHECK(interrupted_games(*resume_folder()).size() == 1);
    }
}
