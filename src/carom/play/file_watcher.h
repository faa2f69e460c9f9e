#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Detects when files are saved, for `--watch`.
namespace carom {

/// Checks when asked. It compares size, time and identity first, and reads only files for which
/// these differ. It handles editors that write in place, that rename a new file over the old, and
/// that remove the file for a moment. Saving without a change is no change.
class FileWatcher {
  public:
    FileWatcher() = default;
    /// Later contents are compared with the contents now.
    explicit FileWatcher(std::vector<std::string> paths);

    /// Whether the contents of any file have changed since this last returned true. A missing file
    /// has not changed: it is expected to reappear.
    bool has_changed();

  private:
    struct Stamp {
        std::uint64_t device = 0;
        std::uint64_t inode = 0;
        std::int64_t size = -1;
        std::int64_t seconds = 0;
        std::int64_t nanoseconds = 0;

        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    struct Watched {
        std::string path;
        Stamp stamp;
        std::uint64_t hash = 0;
    };
    static Stamp stamp_of(const std::string& path);
    static bool renew(Watched& file);

    std::vector<Watched> files_;
};

}  // namespace carom
