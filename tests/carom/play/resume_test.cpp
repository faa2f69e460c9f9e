#include "carom/play/resume.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace carom;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("carom-resume-" + std::to_string(::getpid()));
    ~Folder() { fs::remove_all(path); }
    std::string text() const { return path.string(); }
};

Replay replay_of(const std::string& level, std::uint64_t end = 5) {
    Replay replay;
    replay.level = level;
    replay.texts = {"carom 1 \"A\"\n"};
    replay.end = end;
    replay.position = end;
    return replay;
}

/// Runs it in a process of its own, which has ended without cleaning up when this returns.
template <typename Work>
void in_a_process_that_dies(Work work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::_exit(0);
    }
    REQUIRE(child > 0);
    ::waitpid(child, nullptr, 0);
}

}  // namespace

TEST_CASE("an interrupted game is found by its level") {
    const Folder folder;
    CHECK(interrupted_games(folder.text()).empty());
    in_a_process_that_dies([&] {
        ResumeFile a(folder.text(), "/levels/gas.level");
        a.save(replay_of("/levels/gas.level", 7));
        a.save(replay_of("/levels/gas.level", 9));
        ResumeFile(folder.text(), "/other/gas.level").save(replay_of("/other/gas.level"));
    });
    CHECK(interrupted_games(folder.text()).size() == 2);
    const auto games = interrupted_games(folder.text(), "/levels/gas.level");
    REQUIRE(games.size() == 1);
    CHECK(games[0].replay.position == 9);
    forget(games[0]);
    CHECK(interrupted_games(folder.text()).size() == 1);
}

TEST_CASE("a game of a level with the longest name is kept, and is not that of another") {
    const Folder folder;
    const std::string name(246, 'x');
    in_a_process_that_dies([&] {
        const std::string level = "/levels/" + name + "y.level";
        ResumeFile left(folder.text(), level);
        left.save(replay_of(level, 7));
        left.put_aside();
        ResumeFile cut_off(folder.text(), level);
        cut_off.save(replay_of(level, 9));
        ResumeFile b(folder.text(), "/levels/" + name + "z.level");
        b.save(replay_of("/levels/" + name + "z.level"));
    });
    CHECK(interrupted_games(folder.text(), "/levels/" + name + "y.level").size() == 2);
    CHECK(interrupted_games(folder.text(), "/levels/" + name + "z.level").size() == 1);
}

TEST_CASE("a running game, or one that ended normally, is not an interrupted game") {
    const Folder folder;
    ResumeFile running(folder.text(), "a.level");
    CHECK(running.save(replay_of("a.level")) == std::nullopt);
    in_a_process_that_dies([&] {
        ResumeFile ended(folder.text(), "a.level");
        ended.save(replay_of("a.level"));
        ended.remove();
    });
    CHECK(interrupted_games(folder.text()).empty());
}

TEST_CASE("a game whose process has died, but is not yet waited for, can be resumed") {
    const Folder folder;
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ResumeFile cut_off(folder.text(), "a.level");
        cut_off.save(replay_of("a.level"));
        ::_exit(0);
    }
    siginfo_t info{};
    REQUIRE(::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT) == 0);
    CHECK(interrupted_games(folder.text()).size() == 1);
    // A new game takes another file, so this one is not overwritten.
    ResumeFile next(folder.text(), "a.level");
    CHECK(next.save(replay_of("a.level", 9)) == std::nullopt);
    REQUIRE(interrupted_games(folder.text()).size() == 1);
    CHECK(interrupted_games(folder.text())[0].replay.end == 5);
    ::waitpid(child, nullptr, 0);
}

TEST_CASE("games that are left are kept, each on its own, even if their process runs on") {
    const Folder folder;
    ResumeFile file(folder.text(), "a.level");
    CHECK_FALSE(file.put_aside());
    file.save(replay_of("a.level", 3));
    CHECK(file.put_aside());
    file.save(replay_of("a.level", 4));
    CHECK(interrupted_games(folder.text()).size() == 1);
    CHECK(file.put_aside());
    file.save(replay_of("a.level", 5));
    file.remove();
    const auto games = interrupted_games(folder.text(), "a.level");
    REQUIRE(games.size() == 2);
    CHECK(games[0].was_left);
    CHECK(games[0].replay.end + games[1].replay.end == 7);
    forget(games[0]);
    forget(games[1]);
    CHECK(interrupted_games(folder.text()).empty());
}

TEST_CASE("a truncated file is skipped and named, a foreign one is skipped") {
    const Folder folder;
    in_a_process_that_dies([&] {
        ResumeFile(folder.text(), "a.level").save(replay_of("a.level"));
        const auto file = fs::directory_iterator(folder.path)->path();
        fs::resize_file(file, fs::file_size(file) - 5);
    });
    std::ofstream(folder.path / "notes.txt") << "hello";
    CHECK(interrupted_games(folder.text()).empty());
    const std::vector<std::string> unreadable = unreadable_games(folder.text(), "a.level");
    REQUIRE(unreadable.size() == 1);
    CHECK(unreadable[0].find(".resume, line ") != std::string::npos);
    CHECK(unreadable_games(folder.text()) == unreadable);
    CHECK(unreadable_games(folder.text(), "b.level").empty());
}

TEST_CASE("at most twenty games are kept") {
    const Folder folder;
    for (int i = 0; i < 23; ++i)
        in_a_process_that_dies(
            [&] { ResumeFile(folder.text(), "a.level").save(replay_of("a.level")); });
    CHECK(interrupted_games(folder.text()).size() == 20);
}

TEST_CASE("without a folder to write to nothing happens") {
    ResumeFile nowhere;
    CHECK(nowhere.save(replay_of("a.level")) == std::nullopt);
    nowhere.remove();
    ResumeFile forbidden("/proc/carom", "a.level");
    CHECK(forbidden.save(replay_of("a.level")));
}
