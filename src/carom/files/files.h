#pragma once

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
/// loader sees that it is too long. Folders and unreadable files are errors.
FileText read_file(const std::string& path, std::size_t most = std::size_t{4} << 20);

/// A file that appears under its name only when it is complete. Until `commit`, the text goes into
/// a temporary file beside it, and an existing file stays as it was. Anything but a plain file (a
/// pipe, a device) is written directly, and so is "-", standard output.
///
/// Invariant: after an error, or without a commit, nothing is left behind.
class OutputFile {
  public:
    /// Opens the file; see `error` for success.
    explicit OutputFile(std::string path);
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
    void flush();
    void fail();
    void discard();

    std::string path_;
    std::string temporary_;  // empty: written directly
    std::string buffer_;
    std::string error_;
    int descriptor_ = -1;
    bool is_standard_output_ = false;
};

/// Writes `text` as OutputFile does. Returns the error, if any.
std::optional<std::string> write_file_atomically(const std::string& path, std::string_view text);

}  // namespace carom
