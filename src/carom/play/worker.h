#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

/// A second thread that runs one job at a time. From start() to finish() a job owns the data it
/// works on: no other thread touches it, so no lock is needed.
namespace carom {

class Worker {
  public:
    Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    ~Worker();  ///< waits for the job to end

    /// False if the system could not create the thread: then no job can be started.
    bool is_there() const { return thread_.joinable(); }

    /// Pre: is_there(), and finish() has been called for the previous job.
    void start(std::function<void()> job);
    /// Whether the job has ended; finish() must still be called.
    bool is_done() const;
    /// Waits for the end of the job. Rethrows an exception of the job.
    void finish();

    /// For poll(): readable from the end of a job until its finish().
    int handle() const { return pipe_ends_[0]; }

  private:
    void work();

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::function<void()> job_;
    std::exception_ptr failure_;
    // Guarded by mutex_, like the members above: a job has not been finished yet.
    bool is_started_ = false;
    bool is_done_ = false;
    bool is_over_ = false;
    int pipe_ends_[2] = {-1, -1};
    std::thread thread_;
};

}  // namespace carom
