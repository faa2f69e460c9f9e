#include "carom/support/process.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace carom::test {
namespace {

struct Pipe {
    int read = -1;
    int write = -1;
};

Pipe make_pipe() {
    std::array<int, 2> ends{};
    REQUIRE(::pipe2(ends.data(), O_CLOEXEC) == 0);
    return {.read = ends[0], .write = ends[1]};
}

[[noreturn]] void become_carom(const std::vector<std::string>& arguments, const std::string& levels,
                               const Pipe& out, const Pipe& err) {
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(out.write, STDOUT_FILENO);
    ::dup2(err.write, STDERR_FILENO);
    if (levels.empty()) {
        ::unsetenv("CAROM_LEVELS");
    } else {
        ::setenv("CAROM_LEVELS", levels.c_str(), 1);
    }
    std::signal(SIGINT, SIG_DFL);
    std::string binary = CAROM_BINARY_DIR "/carom";
    std::vector<char*> pointers{binary.data()};
    std::vector<std::string> copies = arguments;
    for (std::string& copy : copies)
        pointers.push_back(copy.data());
    pointers.push_back(nullptr);
    ::execv(binary.c_str(), pointers.data());
    ::_exit(127);
}

// Reads the available bytes; false at the end.
bool drain(int descriptor, std::string& into) {
    std::array<char, 65536> chunk;
    const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
    if (got > 0) into.append(chunk.data(), static_cast<std::size_t>(got));
    return got > 0;
}

Finished run(const std::vector<std::string>& arguments, const std::string& levels,
             std::size_t interrupt_after, std::size_t close_after) {
    Pipe out = make_pipe();
    Pipe err = make_pipe();
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) become_carom(arguments, levels, out, err);
    ::close(out.write);
    ::close(err.write);

    Finished finished;
    std::array<pollfd, 2> sources{{{out.read, POLLIN, 0}, {err.read, POLLIN, 0}}};
    while (sources[0].fd >= 0 || sources[1].fd >= 0) {
        ::poll(sources.data(), sources.size(), -1);
        for (std::size_t i = 0; i < 2; ++i) {
            if (sources[i].fd < 0 || sources[i].revents == 0) continue;
            std::string& text = i == 0 ? finished.out : finished.err;
            const bool is_over = !drain(sources[i].fd, text);
            if (is_over || (i == 0 && text.size() >= close_after)) {
                ::close(sources[i].fd);
                sources[i].fd = -1;
            }
        }
        if (interrupt_after > 0 && finished.out.size() >= interrupt_after) {
            ::kill(child, SIGINT);
            interrupt_after = 0;
        }
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return finished;
}

}  // namespace

Finished run_carom(const std::vector<std::string>& arguments, const std::string& levels,
                   std::size_t interrupt_after) {
    return run(arguments, levels, interrupt_after, std::numeric_limits<std::size_t>::max());
}

Finished run_carom_into_closed_pipe(const std::vector<std::string>& arguments, std::size_t bytes) {
    return run(arguments, {}, 0, bytes);
}

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "carom-test-XXXXXX").string();
    REQUIRE(::mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
}

std::string TemporaryFolder::file(const std::string& name, const std::string& text) const {
    const std::filesystem::path whole = path(name);
    std::filesystem::create_directories(whole.parent_path());
    std::ofstream(whole, std::ios::binary) << text;
    return whole.string();
}

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
        names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    REQUIRE(file.good());
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace carom::test
