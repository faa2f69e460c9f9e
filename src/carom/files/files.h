#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Files, read whole and written whole. Errors are sentences for people, such as "cannot read
/// 'a.level': No such file or directory".
namespace carom {

struct FileText {
    std::optional<std::string> text;  ///< none: see `error`
    std::string error;
};

/// Reads a file of at most `most` bytes; a longer one is read up to one byte more than that, so
/// that the loader sees that it is too long. Folders and files that cannot be read are errors.
FileText read_file(const std::string& path, std::size_t most = std::size_t{4} << 20);

/// A file that appears under its name only when it is complete: until `commit`, the text goes into
/// a temporary file beside it, and what stood under the name before stays as it was. What is not a
/// plain file (a pipe, a device) is written straight away, and so is "-", standard output.
///
/// Invariant: after an error, or without a commit, nothing is left behind.
class OutputFile {
  public:
    /// Opens; an error is told by `error`.
    explicit OutputFile(std::string path);
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile();

    /// Does nothing after an error. Buffered.
    void write(std::string_view text);
    /// Flushes, syncs to the disk and renames. Whether all of it is written: see `error`.
    void commit();

    /// The first thing that went wrong, or empty. A pipe that its reader has closed is no
    /// error: see `is_closed`.
    const std::string& error() const { return error_; }
    /// What is written goes nowhere any more.
    bool is_closed() const { return descriptor_ < 0; }

  private:
    void open();
    void flush();
    void fail();
    void discard();

    std::string path_;
    std::string temporary_;  // empty: written straight away
    std::string buffer_;
    std::string error_;
    int descriptor_ = -1;
    bool is_standard_output_ = false;
};

/// Writes `text` as OutputFile does. Returns what went wrong, if anything.
std::optional<std::string> write_file_atomically(const std::string& path, std::string_view text);

}  // namespace carom
