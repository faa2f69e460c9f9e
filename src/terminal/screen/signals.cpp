#include "terminal/screen/signals.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>

namespace carom {
namespace {

constexpr std::array caught{SIGWINCH, SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGTSTP, SIGCONT};
std::array<struct sigaction, caught.size()> actions_before;
std::array<volatile sig_atomic_t, caught.size()> has_come;
std::array<int, 2> pipe_ends{-1, -1};

void note(int signal) {
    for (std::size_t i = 0; i < caught.size(); ++i) {
        if (caught[i] == signal) has_come[i] = 1;
    }
}

void on_signal(int signal) {
    const int errno_before = errno;
    note(signal);
    const char byte = static_cast<char>(signal);
    // A full pipe already reports enough.
    [[maybe_unused]] const ssize_t written = write(pipe_ends[1], &byte, 1);
    errno = errno_before;
}

void ignore(int signal) {
    struct sigaction action {};
    action.sa_handler = SIG_IGN;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

}  // namespace

bool ends_the_game(int signal) {
    return signal == SIGINT || signal == SIGQUIT || signal == SIGTERM || signal == SIGHUP;
}

SignalPipe::SignalPipe() {
    if (pipe(pipe_ends.data()) == 0) {
        for (const int end : pipe_ends) {
            fcntl(end, F_SETFL, O_NONBLOCK);
            fcntl(end, F_SETFD, FD_CLOEXEC);
        }
    }
    struct sigaction action {};
    action.sa_handler = on_signal;  // no SA_RESTART: a write to a stuck terminal must return
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < caught.size(); ++i) {
        sigaction(caught[i], nullptr, &actions_before[i]);
        const bool is_ours = caught[i] == SIGWINCH || caught[i] == SIGCONT;
        if (is_ours || actions_before[i].sa_handler != SIG_IGN) {
            sigaction(caught[i], &action, nullptr);
        }
    }
}

SignalPipe::~SignalPipe() {
    for (std::size_t i = 0; i < caught.size(); ++i) {
        if (ends_the_game(caught[i]) && has_come[i] != 0) {
            ignore(caught[i]);
        } else {
            sigaction(caught[i], &actions_before[i], nullptr);
        }
    }
    for (int& end : pipe_ends) {
        if (end >= 0) ::close(end);
        end = -1;
    }
}

void SignalPipe::expect_hangup() {
    note(SIGHUP);
}

int SignalPipe::handle() const {
    return pipe_ends[0];
}

std::vector<int> SignalPipe::take() {
    std::vector<int> signals;
    std::array<char, 64> bytes{};
    for (;;) {
        const ssize_t count = read(pipe_ends[0], bytes.data(), bytes.size());
        if (count <= 0) return signals;
        signals.insert(signals.end(), bytes.begin(), bytes.begin() + count);
    }
}

void SignalPipe::stop() {
    struct sigaction by_default {};
    struct sigaction ours {};
    by_default.sa_handler = SIG_DFL;
    sigemptyset(&by_default.sa_mask);
    sigaction(SIGTSTP, &by_default, &ours);
    raise(SIGTSTP);
    sigaction(SIGTSTP, &ours, nullptr);
}

}  // namespace carom
