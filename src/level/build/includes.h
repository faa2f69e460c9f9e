#pragma once

#include "level/build/unroll.h"
#include "level/draft/context.h"

/// Opens included files, each read once; refuses paths that lead out, and circles.
namespace carom {

struct Included {
    const std::vector<Node>* tree = nullptr;
    bool is_new = false;  ///< the first time that this file is included
};

class Includes {
  public:
    Includes(const IncludeResolver& resolver, Texts& texts, Reporter& reporter)
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
    Texts& texts_;
    Reporter& reporter_;
    std::map<std::string, File> files_;
    std::vector<std::string> open_;  ///< from the outermost to the one that is being carried out
    std::size_t bytes_ = 0;
};

}  // namespace carom
