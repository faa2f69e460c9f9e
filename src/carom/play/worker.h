#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

/// A second thread, for one job at a time. A job owns what it works on from start() to finish(): no
/// other thread touches it meanwhile, so it needs no lock.
namespace carom {

class Worker {
  public:
    Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    ~Worker();  ///< waits for the job to end

    /// False where the system gave no thread: then no job can be started.
    bool is_there() const { return thread_.joinable(); }

    /// Pre: is_there(), and no job that has not been finished.
    void start(std::function<void()> job);
    /// Whether the job has ended; finish() is still to be called.
    bool is_done() const;
    /// Waits for the end of the job. Throws what the job threw.
    void finish();

    /// For poll(): readable from the end of a job to its finish().
    int handle() const { return pipe_ends_[0]; }

  private:
    void work();

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::function<void()> job_;
    std::exception_ptr failure_;
    bool is_started_ = false;  // guarded by mutex_, as all above: a job that is not finished
    bool is_done_ = false;
    bool is_over_ = false;
    int pipe_ends_[2] = {-1, -1};
    std::thread thread_;
};

}  // namespace carom
