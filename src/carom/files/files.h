#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Files are read whole and written whole. Errors are sentences for people, such as "cannot read
/// 'a.level': No such file or directory".
namespace carom {

struct FileText {
    std::optional<std::string> text;  ///< none: see `error`
    std::string error;
};

/// Reads a file of at most `most` bytes. A longer one is read up to one byte more, so that the
/// loader sees that it is too long. Folders, pipes and unreadable files are errors: nothing waits
/// for a pipe that nobody writes to.
FileText read_file(const std::string& path, std::size_t most = std::size_t{4} << 20);

/// Who may read a file that is new.
enum class Access : std::uint8_t {
    everybody,  ///< as the process's umask says
    owner       ///< nobody else, whatever the umask: a player's scores, preferences and games
};

/// What becomes of a file that has the name already.
enum class Existing : std::uint8_t {
    replaced,
    kept  ///< an error, also if it has appeared since the OutputFile was opened
};

/// A file that appears under its name only when it is complete. Until `commit`, the text goes into
/// a temporary file beside it, and an existing file stays as it was. Anything but a plain file (a
/// pipe, a device) is written directly, and so is "-", standard output.
///
/// The temporary file is new, with a name that cannot be guessed, and only its owner may read it.
/// It is locked while it is written: one that is not, and has not changed for a minute, was left by
/// a process that was killed, and the next OutputFile of that path removes it.
///
/// Invariant: after an error, or without a commit, nothing is left behind.
class OutputFile {
  public:
    /// Opens the file; see `error` for success. An existing file keeps its permissions, except that
    /// `Access::owner` takes those of others away.
    explicit OutputFile(std::string path, Access access = Access::everybody,
                        Existing existing = Existing::replaced);
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile();

    /// Does nothing after an error. Buffered.
    void write(std::string_view text);
    /// Flushes, syncs to the disk and renames; see `error` for success.
    void commit();

    /// The first error, or empty. A pipe that its reader has closed is no error: see `is_closed`.
    const std::string& error() const { return error_; }
    /// Whether writes no longer have an effect.
    bool is_closed() const { return descriptor_ < 0; }

  private:
    void open();
    bool take_name();
    void flush();
    void fail(int error = errno);
    void discard();

    std::string path_;
    std::string temporary_;  // empty: written directly
    std::string buffer_;
    std::string error_;
    Access access_ = Access::everybody;
    Existing existing_ = Existing::replaced;
    unsigned mode_ = 0;  ///< permissions of the finished file
    int descriptor_ = -1;
    bool is_standard_output_ = false;
};

/// Writes `text` as OutputFile does. Returns the error, if any.
std::optional<std::string> write_file_atomically(const std::string& path, std::string_view text,
                                                 Access access = Access::everybody,
                                                 Existing existing = Existing::replaced);

/// A lock between processes: an empty file, which its holder removes. The lock is gone when its
/// process has ended, however that ended, though the file may then stay until the next lock.
/// Where the file system has no locks, every process gets it: saving the data matters more than
/// taking turns.
class FileLock {
  public:
    /// Whether to wait, for at most five seconds, while another holds the lock.
    enum class Wait : std::uint8_t { no, a_while };

    /// Opens or makes the file and locks it; see `is_held` for success.
    FileLock(std::string path, Wait wait);
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;
    ~FileLock();  ///< releases the lock

    bool is_held() const { return descriptor_ >= 0; }
    /// Whether another process, or another FileLock of this one, holds the lock.
    bool is_held_elsewhere() const { return is_held_elsewhere_; }
    /// Why it is not held: a sentence.
    const std::string& error() const { return error_; }

  private:
    static bool grants(int file);
    bool try_lock();
    void release();

    std::string path_;
    int descriptor_ = -1;
    bool is_held_elsewhere_ = false;
    std::string error_;
};

}  // namespace carom
