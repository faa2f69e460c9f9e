#include "terminal/screen/restore.h"

#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace carom {
namespace {

struct Restoration {
    std::atomic<bool> is_armed{false};
    std::atomic<bool> answers{false};  // survives disarming: answers may come late
    termios modes{};
    std::size_t length = 0;
    std::array<char, 1000> bytes{};
};
static_assert(std::atomic<bool>::is_always_lock_free);

Restoration* restoration = nullptr;

void send_all(std::string_view bytes) noexcept {
    while (!bytes.empty()) {
        const ssize_t written = write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) return;
        if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

constexpr std::array fatal_signals{SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS};
std::array<struct sigaction, fatal_signals.size()> handlers_before;

void on_fatal_signal(int signal) {
    restore_terminal();
    const auto* const found = std::find(fatal_signals.begin(), fatal_signals.end(), signal);
    sigaction(signal, &handlers_before[static_cast<std::size_t>(found - fatal_signals.begin())],
              nullptr);
    raise(signal);  // takes effect when this handler returns
}

// Reads until the answer to CSI 5 n has come, or nothing has come for a second.
void discard_answers() {
    constexpr std::string_view awaited = "\033[0n";
    std::size_t matched = 0;
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    while (matched < awaited.size() && poll(&input, 1, 1000) > 0) {
        char byte = 0;
        if (read(STDIN_FILENO, &byte, 1) != 1) return;
        matched = byte == awaited[matched] ? matched + 1 : byte == awaited[0] ? 1 : 0;
    }
}

}  // namespace

void prepare_restoration() {
    if (restoration != nullptr) return;
    void* const memory = mmap(nullptr, sizeof(Restoration), PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    static Restoration unshared;
    restoration = memory == MAP_FAILED ? &unshared : new (memory) Restoration;
}

void arm_restoration(const termios& modes, std::string_view bytes, bool answers) {
    prepare_restoration();
    restoration->is_armed = false;
    restoration->modes = modes;
    restoration->length = bytes.copy(restoration->bytes.data(), restoration->bytes.size());
    restoration->answers = answers;
    restoration->is_armed = true;
}

void disarm_restoration() {
    if (restoration == nullptr) return;
    restoration->is_armed = false;
    restoration->answers = false;
}

bool is_restoration_armed() {
    return restoration != nullptr && restoration->is_armed;
}

void restore_terminal() noexcept {
    if (restoration == nullptr || !restoration->is_armed.exchange(false)) return;
    const int errno_before = errno;
    send_all({restoration->bytes.data(), restoration->length});
    tcsetattr(STDOUT_FILENO, TCSANOW, &restoration->modes);
    errno = errno_before;
}

void restore_after_death() {
    if (restoration == nullptr) return;
    if (restoration->answers.exchange(false)) {
        termios silent = restoration->modes;
        cfmakeraw(&silent);
        tcsetattr(STDOUT_FILENO, TCSANOW, &silent);
        send_all("\033[5n");
        discard_answers();
        restoration->is_armed = true;  // the modes are to be set again
    }
    restore_terminal();
    tcflush(STDIN_FILENO, TCIFLUSH);
}

void catch_fatal_signals() {
    static bool is_done = false;
    if (is_done) return;
    is_done = true;
    static std::vector<std::byte> own_stack(
        static_cast<std::size_t>(std::max<long>(SIGSTKSZ, 64L * 1024)));
    stack_t stack{};
    stack.ss_sp = own_stack.data();
    stack.ss_size = own_stack.size();
    sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = on_fatal_signal;
    action.sa_flags = SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < fatal_signals.size(); ++i) {
        sigaction(fatal_signals[i], &action, &handlers_before[i]);
    }
    std::atexit([] { restore_terminal(); });
}

}  // namespace carom
