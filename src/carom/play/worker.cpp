#include "carom/play/worker.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cassert>
#include <system_error>
#include <utility>

namespace carom {
namespace {

/// While it lives, new threads receive no signals but those of their own faults: other signals must
/// interrupt the first thread, which may be stuck in a write to the terminal.
class SignalsBlocked {
  public:
    SignalsBlocked() {
        sigset_t blocked;
        sigfillset(&blocked);
        for (const int fault : std::array{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP})
            sigdelset(&blocked, fault);
        pthread_sigmask(SIG_SETMASK, &blocked, &before_);
    }
    SignalsBlocked(const SignalsBlocked&) = delete;
    SignalsBlocked& operator=(const SignalsBlocked&) = delete;
    ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  private:
    sigset_t before_{};
};

}  // namespace

Worker::Worker() {
    if (pipe(pipe_ends_) != 0) return;
    for (const int end : pipe_ends_) {
        fcntl(end, F_SETFL, O_NONBLOCK);
        fcntl(end, F_SETFD, FD_CLOEXEC);
    }
    const SignalsBlocked blocked;
    try {
        thread_ = std::thread([this] { work(); });
    } catch (const std::system_error&) {
    }
}

Worker::~Worker() {
    {
        const std::lock_guard lock(mutex_);
        is_over_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
    for (const int end : pipe_ends_)
        if (end >= 0) ::close(end);
}

void Worker::start(std::function<void()> job) {
    assert(is_there());
    {
        const std::lock_guard lock(mutex_);
        assert(!is_started_);
        job_ = std::move(job);
        is_started_ = true;
    }
    changed_.notify_all();
}

bool Worker::is_done() const {
    const std::lock_guard lock(mutex_);
    return is_done_;
}

void Worker::finish() {
    std::unique_lock lock(mutex_);
    assert(is_started_);
    changed_.wait(lock, [this] { return is_done_; });
    is_started_ = false;
    is_done_ = false;
    char byte = 0;
    [[maybe_unused]] const ssize_t count = ::read(pipe_ends_[0], &byte, 1);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Worker::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return is_over_ || job_; });
        if (!job_) return;
        const std::function<void()> job = std::exchange(job_, nullptr);
        lock.unlock();
        std::exception_ptr failure;
        try {
            job();
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        failure_ = failure;
        is_done_ = true;
        const char byte = 1;
        [[maybe_unused]] const ssize_t count = ::write(pipe_ends_[1], &byte, 1);
        changed_.notify_all();
    }
}

}  // namespace carom
