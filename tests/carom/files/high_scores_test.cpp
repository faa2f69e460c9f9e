#include "carom/files/high_scores.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "carom/files/files.h"
#include "carom/support/process.h"

using namespace carom;
using carom::test::TemporaryFolder;

TEST_CASE("a score is accepted if it is among the best") {
    HighScores scores{{}, 2};
    CHECK_FALSE(scores.takes(0));
    scores.add({"AAA", 100});
    scores.add({"BBB", 300});
    CHECK(scores.takes(101));
    CHECK_FALSE(scores.takes(100));
    scores.add({"CCC", 300});
    CHECK(scores.lines == std::vector<HighScore>{{"BBB", 300}, {"CCC", 300}});
    CHECK_FALSE(HighScores{{}, 0}.takes(5));
}

TEST_CASE("lines of one table are read and written, all others stay") {
    const std::string text =
        "carom high scores 1\nother 5 XYZ\ntable 10 ABC\ntable 30 D-1\nother 4 XYY\n";
    const HighScoresText read = read_high_scores(text, "table", 5, "scores");
    CHECK_FALSE(read.problem);
    CHECK(read.scores.lines == std::vector<HighScore>{{"D-1", 30}, {"ABC", 10}});
    HighScores changed = read.scores;
    changed.add({"NEW", 20});
    const std::string after = with_high_scores(text, "table", changed);
    CHECK(after ==
          "carom high scores 1\nother 5 XYZ\nother 4 XYY\ntable 30 D-1\ntable 20 NEW\ntable 10 "
          "ABC\n");
    CHECK(with_high_scores("", "table", {{{"ABC", 1}}, 5}) == "carom high scores 1\ntable 1 ABC\n");
}

TEST_CASE("high scores that an older carom wrote are read, and stay") {
    const std::string file = CAROM_SOURCE_DIR "/tests/carom/files/samples/high-scores";
    const auto text = read_file(file).text;
    REQUIRE(text);
    const HighScoresText read = read_high_scores(*text, "three-bumpers", 5, file);
    CHECK_FALSE(read.problem);
    CHECK(read.scores.lines ==
          std::vector<HighScore>{{"NEW", 310'000}, {"ABC", 125'400}, {"D-1", 98'250}});
    CHECK(with_high_scores(*text, "three-bumpers", read.scores) == *text);
}

TEST_CASE("a file in another format is reported, with its line") {
    CHECK(read_high_scores("hello\n", "t", 5, "f").problem->find("no file of high scores") !=
          std::string::npos);
    for (const char* line : {"t 5", "t five ABC", "t -5 ABC", "t 5 AB", "t 5 abc", "t 5 ABC x", "",
                             "t 99999999999999999999 ABC"}) {
        CAPTURE(line);
        const std::string text = std::string("carom high scores 1\nt 1 ABC\n") + line + "\n";
        const HighScoresText read = read_high_scores(text, "t", 5, "f");
        REQUIRE(read.problem);
        CHECK(read.problem->starts_with("f:3: "));
    }
}

TEST_CASE("scores are kept in the user's data folder, and a broken file stays untouched") {
    const auto folder = std::filesystem::temp_directory_path() / "carom-high-scores-test";
    std::filesystem::remove_all(folder);
    const char* before = std::getenv("XDG_DATA_HOME");
    const std::string saved = before ? before : "";
    ::setenv("XDG_DATA_HOME", folder.c_str(), 1);
    CHECK(load_high_scores("t", 5).scores.lines.empty());
    CHECK_FALSE(keep_high_score("t", 5, {"ABC", 100}).problem);
    const HighScoresText kept = keep_high_score("t", 5, {"DEF", 200});
    CHECK_FALSE(kept.problem);
    CHECK(kept.scores.lines.size() == 2);
    CHECK(load_high_scores("t", 5).scores.lines == kept.scores.lines);
    const std::string path = (folder / "carom/high-scores").string();
    CHECK_FALSE(write_file_atomically(path, "something else\n"));
    CHECK(keep_high_score("t", 5, {"GHI", 300}).problem);
    CHECK(*read_file(path).text == "something else\n");
    if (before)
        ::setenv("XDG_DATA_HOME", saved.c_str(), 1);
    else
        ::unsetenv("XDG_DATA_HOME");
    std::filesystem::remove_all(folder);
}

TEST_CASE("two processes that keep scores at once lose none") {
    const TemporaryFolder folder;
    const std::string before = std::getenv("XDG_DATA_HOME") ? std::getenv("XDG_DATA_HOME") : "";
    ::setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
    constexpr int each = 50;
    std::array<pid_t, 2> writers{};
    for (std::size_t w = 0; w < writers.size(); ++w) {
        writers[w] = ::fork();
        REQUIRE(writers[w] >= 0);
        if (writers[w] != 0) continue;
        for (int i = 0; i < each; ++i)
            if (keep_high_score("t" + std::to_string(w), each, {"AAA", i + 1}).problem) ::_exit(1);
        ::_exit(0);
    }
    for (const pid_t writer : writers) {
        int status = -1;
        ::waitpid(writer, &status, 0);
        CHECK(status == 0);
    }
    CHECK(load_high_scores("t0", each).scores.lines.size() == each);
    CHECK(load_high_scores("t1", each).scores.lines.size() == each);
    if (before.empty())
        ::unsetenv("XDG_DATA_HOME");
    else
        ::setenv("XDG_DATA_HOME", before.c_str(), 1);
}

TEST_CASE("a level is identified by its file name") {
    CHECK(high_scores_name("/a/b/three-bumpers.level") == "three-bumpers");
    CHECK(high_scores_name("my table.level") == "my_table");
}
