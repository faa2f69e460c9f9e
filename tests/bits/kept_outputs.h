#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace carom::bits {

/// Cached results of the old program, so that it need not run again: for each seed, the digest of
/// its outputs and the ticks at which it refused a command. A text file, one seed a line.
class KeptOutputs {
  public:
    struct Entry {
        std::uint64_t digest = 0;
        std::vector<int> refused;
    };

    explicit KeptOutputs(const std::filesystem::path& path) {
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);) {
            std::istringstream words(line);
            std::uint64_t seed = 0;
            Entry entry;
            words >> seed >> entry.digest;
            entry.refused.assign(std::istream_iterator<int>(words), {});
            entries_[seed] = entry;
        }
        file_.open(path, std::ios::app);
    }
    std::optional<Entry> find(std::uint64_t seed) {
        const std::lock_guard guard(guard_);
        const auto found = entries_.find(seed);
        return found == entries_.end() ? std::nullopt : std::optional(found->second);
    }
    void add(std::uint64_t seed, const Entry& entry) {
        const std::lock_guard guard(guard_);
        file_ << seed << ' ' << entry.digest;
        for (const int tick : entry.refused)
            file_ << ' ' << tick;
        file_ << '\n' << std::flush;
    }

  private:
    std::map<std::uint64_t, Entry> entries_;
    std::ofstream file_;
    std::mutex guard_;
};

}  // namespace carom::bits
