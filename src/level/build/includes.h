#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "level/build/source_store.h"
#include "level/scene/load_options.h"
#include "level/text/reporter.h"

/// Opens included files, and reads each of them once. Refuses paths that lead out of the level's
/// folder, and files that include themselves.
namespace carom {

struct Included {
    const std::vector<Node>* tree = nullptr;
    bool is_new = false;  ///< the first time that this file is included
};

class Includes {
  public:
    Includes(const IncludeResolver& resolver, SourceStore& store, Reporter& reporter)
        : resolver_(resolver), store_(store), reporter_(reporter) {}

    /// `path` is the quoted word. None: reported. Every file that was opened must be closed.
    std::optional<Included> open(const Word& path, const Word& keyword);
    void close() { open_.pop_back(); }

  private:
    struct File {
        const SourceText* source = nullptr;
        const std::vector<Node>* tree = nullptr;
    };

    const IncludeResolver& resolver_;
    SourceStore& store_;
    Reporter& reporter_;
    std::map<std::string, File> files_;
    std::vector<std::string> open_;  ///< the chain of includes, outermost first
    std::size_t bytes_ = 0;
};

}  // namespace carom
