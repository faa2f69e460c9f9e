#include "carom/files/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <thread>
#include <utility>

namespace carom {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 16;

// The target of a rename: the existing file at the end of a chain of symbolic links.
std::string resolved(const std::string& path) {
    char* real = ::realpath(path.c_str(), nullptr);
    if (real == nullptr) return path;
    std::string result = real;
    std::free(real);
    return result;
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

int open_again_on_signal(const char* path, int flags, mode_t mode = 0) {
    int descriptor = -1;
    do {
        descriptor = ::open(path, flags | O_CLOEXEC, mode);
    } while (descriptor < 0 && errno == EINTR);
    return descriptor;
}

mode_t current_umask() {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return mask;
}

constexpr std::string_view temporary_ending = ".XXXXXX.tmp";
constexpr std::size_t longest_name = 255;    // bytes, of the usual file systems
constexpr std::time_t abandoned_after = 60;  // s

// A temporary file is named after its target, cut short where the name would be too long.
std::string_view stem_of_temporaries(std::string_view target) {
    return target.substr(0, longest_name - temporary_ending.size());
}

bool is_temporary_of(std::string_view name, std::string_view target) {
    const std::string_view stem = stem_of_temporaries(target);
    return name.size() == stem.size() + temporary_ending.size() && name.starts_with(stem) &&
           name[stem.size()] == '.' && name.ends_with(".tmp");
}

// Whether no process writes it any more.
bool is_abandoned(const std::string& path) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
    if (std::time(nullptr) - status.st_mtime < abandoned_after) return false;
    const int file = open_again_on_signal(path.c_str(), O_RDONLY | O_NOFOLLOW);
    if (file < 0) return false;
    const bool is_free = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    ::close(file);
    return is_free;
}

void remove_left_behind(const std::string& path) {
    const std::string folder = folder_of(path);
    const std::string name = path.substr(path.rfind('/') + 1);
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string found = entry.path().string();
        if (is_temporary_of(entry.path().filename().string(), name) && is_abandoned(found))
            ::unlink(found.c_str());
    }
}

}  // namespace

FileText read_file(const std::string& path, std::size_t most) {
    const auto failed = [&] {
        return FileText{.text = std::nullopt,
                        .error = fmt::format("cannot read '{}': {}", path, std::strerror(errno))};
    };
    // O_NONBLOCK: opening a pipe that nobody writes to would wait.
    const int descriptor = open_again_on_signal(path.c_str(), O_RDONLY | O_NONBLOCK);
    if (descriptor < 0) return failed();
    struct stat status {};
    if (::fstat(descriptor, &status) == 0 && S_ISFIFO(status.st_mode)) {
        ::close(descriptor);
        return {.text = std::nullopt,
                .error =
                    fmt::format("'{}' is a pipe; copy what comes out of it to a file first", path)};
    }
    std::string text;
    std::array<char, buffer_bytes> chunk;
    while (text.size() <= most) {
        const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) {
            FileText result = failed();
            ::close(descriptor);
            return result;
        }
        if (got == 0) break;
        text.append(chunk.data(), static_cast<std::size_t>(got));
    }
    ::close(descriptor);
    if (text.size() > most) text.resize(most + 1);
    return {.text = std::move(text), .error = {}};
}

OutputFile::OutputFile(std::string path, Access access, Existing existing)
    : path_(std::move(path)), access_(access), existing_(existing) {
    open();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      buffer_(std::exchange(other.buffer_, {})),
      error_(std::move(other.error_)),
      access_(other.access_),
      existing_(other.existing_),
      mode_(other.mode_),
      descriptor_(std::exchange(other.descriptor_, -1)),
      is_standard_output_(other.is_standard_output_) {}

OutputFile::~OutputFile() {
    if (temporary_.empty()) flush();
    discard();
}

void OutputFile::open() {
    if (path_ == "-") {
        is_standard_output_ = true;
        descriptor_ = STDOUT_FILENO;
        return;
    }
    struct stat status {};
    const bool exists = ::stat(path_.c_str(), &status) == 0;
    if (!exists && errno == ENAMETOOLONG) return fail();
    if (exists && existing_ == Existing::kept) return fail(EEXIST);
    if (exists && S_ISDIR(status.st_mode)) return fail(EISDIR);
    if (exists && !S_ISREG(status.st_mode)) {
        descriptor_ = open_again_on_signal(path_.c_str(), O_WRONLY);
        if (descriptor_ < 0) fail();
        return;
    }
    if (exists && ::access(path_.c_str(), W_OK) != 0) return fail();
    path_ = resolved(path_);
    mode_ = exists ? status.st_mode & 0777 : 0666 & ~current_umask();
    if (access_ == Access::owner) mode_ &= 0700;
    remove_left_behind(path_);
    const std::size_t name = path_.rfind('/') + 1;
    temporary_ = path_.substr(0, name);
    temporary_ += stem_of_temporaries(std::string_view(path_).substr(name));
    temporary_ += temporary_ending;
    descriptor_ = ::mkostemps(temporary_.data(), 4, O_CLOEXEC);
    if (descriptor_ < 0) {
        temporary_.clear();
        return fail();
    }
    ::flock(descriptor_, LOCK_EX | LOCK_NB);
}

void OutputFile::write(std::string_view text) {
    if (is_closed()) return;
    buffer_ += text;
    if (buffer_.size() >= buffer_bytes) flush();
}

void OutputFile::flush() {
    std::string_view rest = buffer_;
    while (!rest.empty() && !is_closed()) {
        const ssize_t put = ::write(descriptor_, rest.data(), rest.size());
        if (put >= 0) {
            rest.remove_prefix(static_cast<std::size_t>(put));
        } else if (errno == EPIPE) {
            discard();
        } else if (errno != EINTR) {
            fail();
        }
    }
    buffer_.clear();
}

// Gives the temporary file its name. A link replaces nothing; file systems without links get a
// rename.
bool OutputFile::take_name() {
    if (existing_ == Existing::kept) {
        if (::link(temporary_.c_str(), path_.c_str()) == 0) {
            ::unlink(temporary_.c_str());
            return true;
        }
        if (errno == EEXIST) return false;
    }
    return ::rename(temporary_.c_str(), path_.c_str()) == 0;
}

void OutputFile::commit() {
    flush();
    if (is_closed() || temporary_.empty()) return;
    if (::fchmod(descriptor_, mode_) != 0) return fail();
    if (::fsync(descriptor_) != 0 && errno != EINVAL) return fail();
    if (!take_name()) return fail();
    temporary_.clear();
    discard();
    // The new name reaches the disk when its folder is synced; a failure to sync is ignored.
    const int folder = open_again_on_signal(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY);
    if (folder >= 0) {
        ::fsync(folder);
        ::close(folder);
    }
}

void OutputFile::fail(int error) {
    const std::string name = is_standard_output_ ? "standard output" : fmt::format("'{}'", path_);
    error_ = fmt::format("cannot write {}: {}", name, std::strerror(error));
    discard();
}

void OutputFile::discard() {
    if (descriptor_ >= 0 && !is_standard_output_) ::close(descriptor_);
    descriptor_ = -1;
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    temporary_.clear();
}

std::optional<std::string> write_file_atomically(const std::string& path, std::string_view text,
                                                 Access access, Existing existing) {
    OutputFile file(path, access, existing);
    file.write(text);
    file.commit();
    if (file.error().empty()) return std::nullopt;
    return file.error();
}

FileLock::FileLock(std::string path, Wait wait) : path_(std::move(path)) {
    constexpr int most_tries = 500;
    constexpr std::chrono::milliseconds pause{10};
    for (int left = wait == Wait::no ? 0 : most_tries; !try_lock(); --left) {
        if (!is_held_elsewhere_ || left == 0) return;
        std::this_thread::sleep_for(pause);
    }
}

// Locks an open file. A file system without locks grants every one.
bool FileLock::grants(int file) {
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) return true;
    return errno == ENOLCK || errno == ENOSYS || errno == EOPNOTSUPP || errno == EINVAL;
}

// Post: if not held, `error_` and `is_held_elsewhere_` say why.
bool FileLock::try_lock() {
    for (;;) {
        const int file = open_again_on_signal(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW, 0600);
        const bool is_locked = file >= 0 && grants(file);
        is_held_elsewhere_ = file >= 0 && !is_locked && errno == EWOULDBLOCK;
        if (!is_locked) {
            error_ =
                fmt::format("cannot lock '{}': {}", path_,
                            is_held_elsewhere_ ? "another process uses it" : std::strerror(errno));
            if (file >= 0) ::close(file);
            return false;
        }
        // The former holder may have removed the file after it was opened here.
        struct stat ours {};
        struct stat named {};
        if (::fstat(file, &ours) == 0 && ::lstat(path_.c_str(), &named) == 0 &&
            ours.st_ino == named.st_ino && ours.st_dev == named.st_dev) {
            descriptor_ = file;
            return true;
        }
        ::close(file);
    }
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      is_held_elsewhere_(other.is_held_elsewhere_),
      error_(std::move(other.error_)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    release();
    path_ = std::move(other.path_);
    descriptor_ = std::exchange(other.descriptor_, -1);
    is_held_elsewhere_ = other.is_held_elsewhere_;
    error_ = std::move(other.error_);
    return *this;
}

FileLock::~FileLock() {
    release();
}

void FileLock::release() {
    if (descriptor_ < 0) return;
    ::unlink(path_.c_str());
    ::close(std::exchange(descriptor_, -1));
}

}  // namespace carom
