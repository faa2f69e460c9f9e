#include "level/load.h"

#include "level/assemble.h"
#include "level/unroll.h"

namespace carom {
namespace {

// FNV-1a, 64 bits, over texts with their lengths between them.
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

}  // namespace

LoadResult load_level(std::string_view text, std::string_view file, const LoadOptions& options) {
    Texts texts;
    Context context;
    Scene scene;
    const SourceText& main = texts.add(std::string(file), std::string(text));
    if (const auto fault = find_fault(main.text)) {
        context.reporter.error({&main, fault->line, fault->column, 1}, fault->message,
                               fault->remedy);
        return {std::nullopt, context.reporter.diagnostics()};
    }
    scene.file = std::string(file);
    unroll(main, options, texts, scene, context);
    assemble(options, scene, context);

    LoadResult result;
    result.diagnostics = context.reporter.diagnostics();
    if (context.reporter.has_errors()) return result;
    TextHash hash;
    for (const SourceText& source : texts.sources) {
        hash.add(source.text);
        if (source.name != "--set") scene.files.push_back(source.name);
    }
    scene.text_hash = hash.value();
    result.scene = std::move(scene);
    return result;
}

}  // namespace carom
