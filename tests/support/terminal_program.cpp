#include "support/terminal_program.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utmp.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace carom::test {
namespace {

double now() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since).count();
}

constexpr int log_handle = 3;

[[noreturn]] void run(const std::vector<std::string>& arguments, const ProgramOptions& options,
                      int log) {
    if (log != log_handle) {
        dup2(log, log_handle);
        close(log);
    }
    for (int handle = log_handle + 1; handle < 64; ++handle) {
        close(handle);
    }
    for (const char* const name :
         {"NO_COLOR", "COLORFGBG", "SSH_CONNECTION", "SSH_TTY", "LINES", "COLUMNS", "TMUX"}) {
        unsetenv(name);
    }
    setenv("TERM", "xterm-256color", 1);
    setenv("LC_ALL", "C.UTF-8", 1);
    for (const auto& [name, value] : options.environment) {
        value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
    }
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) {
        pointers.push_back(const_cast<char*>(argument.c_str()));
    }
    pointers.push_back(nullptr);
    execvp(pointers[0], pointers.data());
    std::perror(pointers[0]);
    _exit(127);
}

}  // namespace

TerminalProgram::TerminalProgram(const std::vector<std::string>& arguments,
                                 const ProgramOptions& options)
    : emulator_(options.columns > 0 ? options.columns : 80, options.columns > 0 ? options.rows : 24,
                options.emulator, [this](std::string_view bytes) { to_send_ += bytes; }) {
    std::array<int, 2> pipe_ends{};
    if (pipe(pipe_ends.data()) != 0) std::abort();
    winsize size{};
    size.ws_col = static_cast<unsigned short>(options.columns);
    size.ws_row = static_cast<unsigned short>(options.rows);
    size.ws_xpixel = static_cast<unsigned short>(options.pixels_wide);
    size.ws_ypixel = static_cast<unsigned short>(options.pixels_high);
    int slave = -1;
    if (openpty(&terminal_, &slave, nullptr, nullptr, &size) != 0) std::abort();
    tcgetattr(terminal_, &modes_at_start_);
    process_ = fork();
    if (process_ == 0) {
        close(terminal_);
        login_tty(slave);
        run(arguments, options, pipe_ends[1]);
    }
    close(slave);
    close(pipe_ends[1]);
    log_pipe_ = pipe_ends[0];
    fcntl(terminal_, F_SETFL, O_NONBLOCK);
    fcntl(terminal_, F_SETFD, FD_CLOEXEC);
    fcntl(log_pipe_, F_SETFD, FD_CLOEXEC);
}

TerminalProgram::~TerminalProgram() {
    if (!end_) {
        kill(process_, SIGCONT);
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    if (terminal_ >= 0) close(terminal_);
    close(log_pipe_);
}

void TerminalProgram::send(std::string_view bytes) {
    to_send_ += bytes;
    flush_input();
}

void TerminalProgram::flush_input() {
    while (!to_send_.empty() && terminal_ >= 0) {
        const ssize_t written = write(terminal_, to_send_.data(), to_send_.size());
        if (written <= 0) return;
        to_send_.erase(0, static_cast<std::size_t>(written));
    }
}

void TerminalProgram::resize(int columns, int rows) {
    emulator_.resize(columns, rows);
    claim_size(columns, rows);
}

void TerminalProgram::claim_size(int columns, int rows) {
    winsize size{};
    ioctl(terminal_, TIOCGWINSZ, &size);
    size.ws_col = static_cast<unsigned short>(columns);
    size.ws_row = static_cast<unsigned short>(rows);
    ioctl(terminal_, TIOCSWINSZ, &size);
}

void TerminalProgram::signal(int number) const {
    kill(process_, number);
}

void TerminalProgram::hang_up() {
    close(terminal_);
    terminal_ = -1;
}

// One exchange between program and terminal; false if nothing came in that time.
bool TerminalProgram::pump(double seconds) {
    std::array<pollfd, 2> sources{{{terminal_, POLLIN, 0}, {log_pipe_, POLLIN, 0}}};
    if (!to_send_.empty()) sources[0].events |= POLLOUT;
    if (poll(sources.data(), sources.size(), static_cast<int>(seconds * 1000.0)) <= 0) return false;
    bool has_come = false;
    std::array<char, 65536> bytes;
    if ((sources[0].revents & POLLIN) != 0) {
        const ssize_t count = read(terminal_, bytes.data(), bytes.size());
        if (count > 0) {
            const std::string_view part(bytes.data(), static_cast<std::size_t>(count));
            output_ += part;
            emulator_.write(part);
            has_come = true;
        }
    }
    if ((sources[1].revents & POLLIN) != 0) {
        const ssize_t count = read(log_pipe_, bytes.data(), bytes.size());
        if (count > 0) {
            log_.append(bytes.data(), static_cast<std::size_t>(count));
            has_come = true;
        }
    }
    flush_input();
    const bool is_over = !has_come && ((sources[0].revents | sources[1].revents) & POLLHUP) != 0;
    if (is_over) usleep(1000);
    return has_come;
}

bool TerminalProgram::wait_until(const std::function<bool()>& is_so, double seconds) {
    const double end = now() + seconds;
    while (!is_so()) {
        if (now() > end) return false;
        pump(0.02);
    }
    return true;
}

bool TerminalProgram::wait_for_text(std::string_view text, double seconds) {
    return wait_until([&] { return emulator_.text().find(text) != std::string::npos; }, seconds);
}

bool TerminalProgram::wait_for_log(std::string_view text, double seconds) {
    return wait_until([&] { return log_.find(text) != std::string::npos; }, seconds);
}

void TerminalProgram::settle(double seconds) {
    for (double end = now() + seconds; now() < end;) {
        if (pump(0.01)) end = now() + seconds;
    }
}

bool TerminalProgram::has_ended() {
    int status = 0;
    if (!end_ && waitpid(process_, &status, WNOHANG) == process_) end_ = status;
    return end_.has_value();
}

std::optional<int> TerminalProgram::wait_for_end_unread(double seconds) {
    for (const double end = now() + seconds; !has_ended() && now() < end;) {
        usleep(10'000);
    }
    return end_;
}

std::optional<int> TerminalProgram::wait_for_end(double seconds) {
    wait_until([&] { return has_ended(); }, seconds);
    if (end_) settle(0.02);
    return end_;
}

std::optional<int> TerminalProgram::exit_status() {
    const auto status = wait_for_end();
    if (!status || !WIFEXITED(*status)) return std::nullopt;
    return WEXITSTATUS(*status);
}

termios TerminalProgram::modes() const {
    termios modes{};
    tcgetattr(terminal_, &modes);
    return modes;
}

std::string TerminalProgram::what_is_left_dirty() const {
    std::string dirt;
    constexpr std::array off_modes{1049, 1047, 47,   1000, 1002, 1003, 1005,
                                   1006, 1015, 1016, 2004, 2026, 1};
    for (const int number : off_modes) {
        if (emulator_.mode(number)) dirt += "mode " + std::to_string(number) + " is on; ";
    }
    if (!emulator_.mode(25)) dirt += "the cursor is hidden; ";
    if (emulator_.key_stack() != 0) dirt += "the key protocol is on; ";
    const termios after = modes();
    const bool has_same_modes =
        after.c_iflag == modes_at_start_.c_iflag && after.c_oflag == modes_at_start_.c_oflag &&
        after.c_cflag == modes_at_start_.c_cflag && after.c_lflag == modes_at_start_.c_lflag &&
        std::memcmp(after.c_cc, modes_at_start_.c_cc, NCCS) == 0;
    if (!has_same_modes) dirt += "the line's modes differ; ";
    return dirt;
}

std::string mouse_press(int button, int column, int row) {
    return "\033[<" + std::to_string(button) + ';' + std::to_string(column + 1) + ';' +
           std::to_string(row + 1) + 'M';
}

std::string mouse_release(int button, int column, int row) {
    std::string report = mouse_press(button, column, row);
    report.back() = 'm';
    return report;
}

std::string mouse_drag(int button, int column, int row) {
    constexpr int motion = 32;
    return mouse_press(button + motion, column, row);
}

}  // namespace carom::test
