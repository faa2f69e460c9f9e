#include "carom/play/worker.h"

#include <doctest/doctest.h>
#include <poll.h>
#include <signal.h>

#include <atomic>
#include <stdexcept>
#include <vector>

using carom::Worker;

namespace {

bool is_readable(int handle, int milliseconds) {
    pollfd source{.fd = handle, .events = POLLIN, .revents = 0};
    return poll(&source, 1, milliseconds) == 1;
}

}  // namespace

TEST_CASE("a worker does one job after another, and returns its data") {
    Worker worker;
    REQUIRE(worker.is_there());
    std::vector<int> squares;  // without a lock
    for (int i = 0; i < 1000; ++i) {
        worker.start([&squares, i] { squares.push_back(i * i); });
        worker.finish();
        REQUIRE(squares.size() == static_cast<std::size_t>(i) + 1);
    }
    CHECK(squares.back() == 999 * 999);
}

TEST_CASE("the end of a worker's job can be polled together with other events") {
    Worker worker;
    CHECK_FALSE(is_readable(worker.handle(), 0));
    std::atomic<bool> may_end = false;
    worker.start([&] {
        while (!may_end) {
        }
    });
    CHECK_FALSE(worker.is_done());
    CHECK_FALSE(is_readable(worker.handle(), 0));
    may_end = true;
    CHECK(is_readable(worker.handle(), 10000));
    worker.finish();
    CHECK_FALSE(is_readable(worker.handle(), 0));
    worker.start([] {});
    CHECK(is_readable(worker.handle(), 10000));
    worker.finish();
}

TEST_CASE("finish rethrows an exception of a worker's job, and the next job runs") {
    Worker worker;
    worker.start([] { throw std::runtime_error("no"); });
    CHECK_THROWS_AS(worker.finish(), std::runtime_error);
    bool is_done = false;
    worker.start([&] { is_done = true; });
    worker.finish();
    CHECK(is_done);
}

TEST_CASE("the destructor of a worker waits for its job") {
    bool is_done = false;
    {
        Worker worker;
        worker.start([&] { is_done = true; });
    }
    CHECK(is_done);
}

TEST_CASE("signals are left to the first thread") {
    Worker worker;
    sigset_t blocked;
    sigemptyset(&blocked);
    worker.start([&] { pthread_sigmask(SIG_BLOCK, nullptr, &blocked); });
    worker.finish();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGWINCH, SIGTSTP, SIGCONT})
        CHECK(sigismember(&blocked, signal) == 1);
    CHECK(sigismember(&blocked, SIGSEGV) == 0);
    pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
    CHECK(sigismember(&blocked, SIGTERM) == 0);
}
