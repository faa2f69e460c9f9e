#pragma once

#include "level/build/interpreter.h"
#include "level/ir/context.h"

/// Opens included files, each read once; refuses paths that lead out, and circles.
namespace carom {

struct Included {
    const std::vector<Node>* tree = nullptr;
    bool is_new = false;  ///< the first time that this file is included
};

class Includes {
  public:
    Includes(const IncludeResolver& resolver, SourceStore& texts, Reporter& reporter)
        : resolver_(resolver), texts_(texts), reporter_(reporter) {}

    /// `path` is the quoted word. None: reported. A file that was opened must be closed.
    std::optional<Included> open(const Word& path, const Word& keyword);
    void close() { open_.pop_back(); }

  private:
    struct File {
        const SourceText* source = nullptr;
        const std::vector<Node>* tree = nullptr;
    };

    const IncludeResolver& resolver_;
    SourceStore& texts_;
    Reporter& reporter_;
    std::map<std::string, File> files_;
    std::vector<std::string> open_;  ///< from the outermost to the one that is being carried out
    std::size_t bytes_ = 0;
};

}  // namespace carom
