#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Notices when files are saved, for `--watch`.
namespace carom {

/// Looks when asked: asks the system for size, time and identity first, and reads only what these
/// say may have changed. Editors that write in place, that rename a new file over the old, or that
/// take the file away for a moment are all the same to it; saving without a change is no change.
class FileWatcher {
  public:
    FileWatcher() = default;
    /// What the files say now is what they are compared with.
    explicit FileWatcher(std::vector<std::string> paths);

    /// Whether the contents of any file have changed since the last time that this said so. A file
    /// that is not there has not changed: it is expected back.
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
