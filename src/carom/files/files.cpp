#include "carom/files/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
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

}  // namespace

FileText read_file(const std::string& path, std::size_t most) {
    const auto failed = [&] {
        return FileText{.text = std::nullopt,
                        .error = fmt::format("cannot read '{}': {}", path, std::strerror(errno))};
    };
    const int descriptor = open_again_on_signal(path.c_str(), O_RDONLY);
    if (descriptor < 0) return failed();
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

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
    open();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      buffer_(std::exchange(other.buffer_, {})),
      error_(std::move(other.error_)),
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
    if (exists && S_ISDIR(status.st_mode)) {
        errno = EISDIR;
        return fail();
    }
    if (exists && !S_ISREG(status.st_mode)) {
        descriptor_ = open_again_on_signal(path_.c_str(), O_WRONLY);
        if (descriptor_ < 0) fail();
        return;
    }
    if (exists && ::access(path_.c_str(), W_OK) != 0) return fail();
    path_ = resolved(path_);
    temporary_ = fmt::format("{}.{}.tmp", path_, ::getpid());
    const mode_t mode = exists ? status.st_mode & 0777 : 0666;
    descriptor_ = open_again_on_signal(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, mode);
    if (descriptor_ < 0) {
        temporary_.clear();
        fail();
    }
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

void OutputFile::commit() {
    flush();
    if (is_closed() || temporary_.empty()) return;
    if (::fsync(descriptor_) != 0 && errno != EINVAL) return fail();
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) return fail();
    temporary_.clear();
    discard();
    // The new name reaches the disk when its folder is synced; a failure to sync is ignored.
    const int folder = open_again_on_signal(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY);
    if (folder >= 0) {
        ::fsync(folder);
        ::close(folder);
    }
}

void OutputFile::fail() {
    const std::string name = is_standard_output_ ? "standard output" : fmt::format("'{}'", path_);
    error_ = fmt::format("cannot write {}: {}", name, std::strerror(errno));
    discard();
}

void OutputFile::discard() {
    if (descriptor_ >= 0 && !is_standard_output_) ::close(descriptor_);
    descriptor_ = -1;
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    temporary_.clear();
}

std::optional<std::string> write_file_atomically(const std::string& path, std::string_view text) {
    OutputFile file(path);
    file.write(text);
    file.commit();
    if (file.error().empty()) return std::nullopt;
    return file.error();
}

}  // namespace carom
