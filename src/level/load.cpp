#include "level/load.h"

#include <algorithm>
#include <utility>

#include "level/assemble/assemble.h"
#include "level/build/interpreter.h"

namespace carom {
namespace {

// A 64-bit FNV-1a hash of texts. It includes their lengths, so that "ab","c" and "a","bc" differ.
class TextHash {
  public:
    void add(std::string_view text) {
        for (const char c : text)
            add_byte(static_cast<unsigned char>(c));
        for (std::size_t length = text.size(), i = 0; i < 8; ++i, length >>= 8) {
            add_byte(static_cast<unsigned char>(length & 0xffu));
        }
    }
    std::uint64_t value() const { return hash_; }

  private:
    void add_byte(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3u; }
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

struct FoundInclude {
    std::string from;
    std::string path;
    std::string file;
};

// Wraps the caller's resolver so that it also records each file that it finds.
IncludeResolver noting(const IncludeResolver& resolver, std::vector<FoundInclude>& found) {
    if (!resolver) return {};
    return [&](std::string_view from, std::string_view path) {
        auto file = resolver(from, path);
        if (file) found.push_back({std::string(from), std::string(path), file->file});
        return file;
    };
}

// The recorded includes, by index of file. An include that ran several times, as in a `repeat`, is
// listed once.
std::vector<Include> links(const std::vector<FoundInclude>& found,
                           const std::vector<std::string>& files) {
    const auto index = [&](const std::string& name) {
        return static_cast<std::size_t>(std::ranges::find(files, name) - files.begin());
    };
    std::vector<Include> links;
    for (const FoundInclude& include : found) {
        Include link{index(include.from), index(include.file), include.path};
        if (std::ranges::count(links, link) == 0) links.push_back(std::move(link));
    }
    return links;
}

}  // namespace

LoadResult load_level(std::string_view text, std::string_view file, const LoadOptions& options) {
    SourceStore store;
    Context context;
    Scene scene;
    const SourceText& main = store.add(std::string(file), std::string(text));
    if (const auto fault = find_fault(main.text)) {
        context.reporter.error(fault->code, {&main, fault->line, fault->column, 1}, fault->message,
                               fault->remedy);
        return {std::nullopt, context.reporter.diagnostics(), 0};
    }
    scene.file = std::string(file);
    std::vector<FoundInclude> found;
    LoadOptions noted = options;
    noted.resolve_include = noting(options.resolve_include, found);
    try {
        interpret(main, noted, store, scene, context);
        assemble(noted, scene, context);
    } catch (const LoadStopped&) {
        // The reason is among the diagnostics.
    }

    LoadResult result;
    result.operations = context.work.spent();
    result.diagnostics = context.reporter.diagnostics();
    if (context.reporter.has_errors()) return result;
    TextHash hash;
    for (const SourceText& source : store.sources) {
        hash.add(source.text);
        if (source.name == "--set") continue;
        scene.files.push_back(source.name);
        scene.texts.push_back(source.text);
    }
    scene.includes = links(found, scene.files);
    scene.text_hash = hash.value();
    result.scene = std::move(scene);
    return result;
}

}  // namespace carom
