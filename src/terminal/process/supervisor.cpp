#include "terminal/process/supervisor.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "terminal/screen/restore.h"
#include "terminal/screen/signals.h"

namespace carom {
namespace {

std::vector<int> passed_on() {
    std::vector<int> signals = signals_that_end_the_game();
    signals.push_back(SIGTSTP);
    return signals;
}

volatile sig_atomic_t child_process = 0;

void pass_on(int signal) {
    const int errno_before = errno;
    if (child_process > 0) kill(static_cast<pid_t>(child_process), signal);
    errno = errno_before;
}

struct sigaction action_of(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    return action;
}

// Signals that were ignored (nohup) stay ignored.
void pass_signals_on() {
    const struct sigaction action = action_of(pass_on);
    for (const int signal : passed_on()) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
}

void stop_until_continued() {
    const struct sigaction by_default = action_of(SIG_DFL);
    struct sigaction before {};
    sigaction(SIGTSTP, &by_default, &before);
    raise(SIGTSTP);
    sigaction(SIGTSTP, &before, nullptr);
}

// The child's final status. This process stops when the child stops, and continues it afterwards.
int wait_for(pid_t child) {
    for (;;) {
        int status = 0;
        if (waitpid(child, &status, WUNTRACED) < 0) {
            if (errno == EINTR) continue;
            return 0;
        }
        if (!WIFSTOPPED(status)) return status;
        if (WSTOPSIG(status) == SIGSTOP) continue;  // the sender of STOP will send CONT too
        stop_until_continued();
        kill(child, SIGCONT);
    }
}

// Dies of the signal, so that the shell sees what killed the child. The core file, if any, is the
// child's.
int die_of(int signal) {
    const rlimit none{.rlim_cur = 0, .rlim_max = 0};
    setrlimit(RLIMIT_CORE, &none);
    const struct sigaction by_default = action_of(SIG_DFL);
    sigaction(signal, &by_default, nullptr);
    raise(signal);
    return 128 + signal;
}

}  // namespace

int run_supervised(const std::function<int()>& play, const std::string& resume_hint) {
    if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) return play();
    prepare_restoration();
    sigset_t held;
    sigset_t held_before;
    sigemptyset(&held);
    for (const int signal : passed_on()) {
        sigaddset(&held, signal);
    }
    sigprocmask(SIG_BLOCK, &held, &held_before);  // no signal is lost around the fork
    [[maybe_unused]] const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0) {
#ifdef __linux__
        prctl(PR_SET_PDEATHSIG, SIGHUP);
        if (getppid() != parent) raise(SIGHUP);
#endif
        sigprocmask(SIG_SETMASK, &held_before, nullptr);
        return play();
    }
    if (child > 0) {
        child_process = static_cast<sig_atomic_t>(child);
        pass_signals_on();
    }
    sigprocmask(SIG_SETMASK, &held_before, nullptr);
    if (child < 0) return play();

    const int status = wait_for(child);
    child_process = 0;
    if (is_restoration_armed() || WIFSIGNALED(status)) restore_after_death();
    if (!WIFSIGNALED(status)) return WEXITSTATUS(status);
    const int signal = WTERMSIG(status);
    std::string message =
        fmt::format("carom: the game was ended by signal {} ({})\n", signal, strsignal(signal));
    if (!resume_hint.empty()) message += resume_hint + '\n';
    std::fputs(message.c_str(), stderr);  // fails harmlessly if standard error is gone
    return die_of(signal);
}

}  // namespace carom
