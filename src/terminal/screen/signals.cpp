#include "terminal/screen/signals.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>

namespace carom {
namespace {

constexpr std::array common{SIGWINCH, SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGTSTP, SIGCONT};

/// By number of the signal.
template <typename T>
using BySignal = std::array<T, NSIG>;
BySignal<struct sigaction> actions_before;
BySignal<bool> is_caught;
BySignal<volatile sig_atomic_t> has_come;
std::array<int, 2> pipe_ends{-1, -1};

bool is_common(int signal) {
    return std::ranges::find(common, signal) != common.end();
}

bool is_taken_from(const struct sigaction& before, int signal) {
    if (signal == SIGWINCH || signal == SIGCONT) return true;
    return is_common(signal) ? before.sa_handler != SIG_IGN : before.sa_handler == SIG_DFL;
}

void note(int signal) {
    has_come[static_cast<std::size_t>(signal)] = 1;
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
    switch (signal) {
        case SIGINT:
        case SIGQUIT:
        case SIGTERM:
        case SIGHUP:
        case SIGUSR1:
        case SIGUSR2:
        case SIGALRM:
        case SIGVTALRM:
        case SIGPROF:
        case SIGXCPU:
#ifdef __linux__
        case SIGPOLL:
        case SIGPWR:
        case SIGSTKFLT:
#endif
            return true;
        default:
            break;
    }
#ifdef SIGRTMIN
    return signal >= SIGRTMIN && signal <= SIGRTMAX;
#else
    return false;
#endif
}

std::vector<int> signals_that_end_the_game() {
    std::vector<int> signals;
    for (int signal = 1; signal < NSIG; ++signal)
        if (ends_the_game(signal)) signals.push_back(signal);
    return signals;
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
    for (int signal = 1; signal < NSIG; ++signal) {
        const auto index = static_cast<std::size_t>(signal);
        is_caught[index] = false;
        if (!ends_the_game(signal) && !is_common(signal)) continue;
        sigaction(signal, nullptr, &actions_before[index]);
        if (!is_taken_from(actions_before[index], signal)) continue;
        is_caught[index] = sigaction(signal, &action, nullptr) == 0;
    }
}

SignalPipe::~SignalPipe() {
    for (int signal = 1; signal < NSIG; ++signal) {
        const auto index = static_cast<std::size_t>(signal);
        if (!is_caught[index]) continue;
        if (ends_the_game(signal) && has_come[index] != 0) {
            ignore(signal);
        } else {
            sigaction(signal, &actions_before[index], nullptr);
        }
    }
    for (int& end : pipe_ends) {
        if (end >= 0) ::close(end);
        end = -1;
    }
}

SignalPipe::Delay::Delay() {
    sigset_t delayed;
    sigemptyset(&delayed);
    for (int signal = 1; signal < NSIG; ++signal)
        if (is_caught[static_cast<std::size_t>(signal)]) sigaddset(&delayed, signal);
    sigprocmask(SIG_BLOCK, &delayed, &before_);
}

SignalPipe::Delay::~Delay() {
    sigprocmask(SIG_SETMASK, &before_, nullptr);
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
