#include "carom/cli/interrupt.h"

#include <array>
#include <csignal>
#include <cstdlib>

namespace carom {
namespace {

constexpr std::array<int, 3> noted{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t first_signal = 0;
std::array<struct sigaction, noted.size()> before;

void note(int signal) {
    if (first_signal == 0) first_signal = signal;
}

}  // namespace

InterruptGuard::InterruptGuard() {
    first_signal = 0;
    struct sigaction action {};
    action.sa_handler = note;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < noted.size(); ++i) {
        ::sigaction(noted[i], nullptr, &before[i]);
        // Signals that the parent chose to ignore (nohup) stay ignored.
        if (before[i].sa_handler != SIG_IGN) ::sigaction(noted[i], &action, nullptr);
    }
}

InterruptGuard::~InterruptGuard() {
    for (std::size_t i = 0; i < noted.size(); ++i)
        ::sigaction(noted[i], &before[i], nullptr);
}

int InterruptGuard::signal() {
    return first_signal;
}

void die_of(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    std::_Exit(128 + signal);
}

}  // namespace carom
