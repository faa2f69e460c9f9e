#pragma once

#include <string>
#include <vector>

/// The program as a process, as a shell would start it.
namespace carom::test {

struct Finished {
    int exit_code = -1;  ///< 128 + n if signal n ended it
    std::string out;
    std::string err;
};

/// Runs the built `carom` with these arguments, an empty standard input, and CAROM_LEVELS set to
/// `levels` (unset if that is empty), and waits for its end. `interrupt_after`: sends INT after so
/// many bytes on standard output; 0: never.
Finished run_carom(const std::vector<std::string>& arguments, const std::string& levels = {},
                   std::size_t interrupt_after = 0);

/// Runs it with standard output as a pipe that is closed after its first `bytes`.
Finished run_carom_into_closed_pipe(const std::vector<std::string>& arguments, std::size_t bytes);

inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// A folder for a test, deleted with all its contents.
class TemporaryFolder {
  public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();

    std::string path(const std::string& name) const { return path_ + "/" + name; }
    const std::string& path() const { return path_; }
    /// Writes a file into it and returns its path.
    std::string file(const std::string& name, const std::string& text) const;
    /// The names of its files, sorted.
    std::vector<std::string> names() const;

  private:
    std::string path_;
};

/// A file's bytes; fails the test if it cannot be read.
std::string content(const std::string& path);

}  // namespace carom::test
