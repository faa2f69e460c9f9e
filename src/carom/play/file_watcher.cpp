#include "carom/play/file_watcher.h"

#include <sys/stat.h>

#include <algorithm>
#include <utility>

#include "carom/files/files.h"

namespace carom {
namespace {

std::uint64_t hash_of(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325ull;  // FNV-1a
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    return hash;
}

}  // namespace

FileWatcher::FileWatcher(std::vector<std::string> paths) {
    std::ranges::sort(paths);
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    for (std::string& path : paths) {
        files_.push_back({std::move(path), {}, 0});
        renew(files_.back());
    }
}

FileWatcher::Stamp FileWatcher::stamp_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {status.st_dev, status.st_ino, status.st_size, status.st_mtim.tv_sec,
            status.st_mtim.tv_nsec};
}

bool FileWatcher::renew(Watched& file) {
    const Stamp stamp = stamp_of(file.path);
    if (stamp.size < 0 || stamp == file.stamp) return false;
    const FileText read = read_file(file.path);
    if (!read.text) return false;
    file.stamp = stamp;
    return std::exchange(file.hash, hash_of(*read.text)) != file.hash;
}

bool FileWatcher::has_changed() {
    bool changed = false;
    for (Watched& file : files_)
        changed = renew(file) || changed;
    return changed;
}

}  // namespace carom
