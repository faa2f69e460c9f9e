#include <doctest/doctest.h>

#include <cstdint>

#include "level/build/all_statements.h"
#include "level/support/files.h"
#include "physics/world/random.h"

using namespace carom;
using namespace carom::test;

namespace {

// Seeded, so that a failure can be reproduced.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : seed_(seed) {}
    std::uint64_t below(std::uint64_t n) {
        return random_bits(seed_, RandomStream::player, 0, next_++) % n;
    }

  private:
    std::uint64_t seed_;
    std::uint64_t next_ = 0;
};

// The loader returns a scene or an error, whatever the bytes, and its diagnostics render.
void check_survives(const std::string& text, const LoadOptions& options) {
    const LoadResult result = load_level(text, "fuzz.level", options);
    bool has_error = false;
    CHECK(result.diagnostics.size() <= 20);
    for (const Diagnostic& d : result.diagnostics) {
        has_error = has_error || d.severity == Severity::error;
        CHECK(d.line >= 1);
        CHECK(d.column >= 1);
        CHECK(d.length >= 1);
        CHECK(!d.message.empty());
        CHECK(!render(d).empty());
    }
    CHECK(result.scene.has_value() == !has_error);
}

std::vector<std::string> seeds() {
    const std::filesystem::path root = CAROM_SOURCE_DIR;
    std::vector<std::string> texts;
    for (const auto& folder : {root / "levels", root / "tests/level/broken"}) {
        for (const auto& file : level_files(folder)) {
            // Leave out levels that take long to load: thousands of mutants would too.
            const std::string text = read_file(file);
            if (text.size() < 6000 && text.find("0000") == std::string::npos) texts.push_back(text);
        }
    }
    return texts;
}

std::vector<std::string> soup_words() {
    std::vector<std::string> words{"\n",       "\n",          "\n",
                                   " ",        "end",         "x",
                                   "y",        "a",           "b",
                                   "W",        "0,0",         "10,20",
                                   "-1e9,3",   "1..2",        "r=",
                                   "at=0,0",   "=",           "#",
                                   "\\",       "\"",          "\"t\"",
                                   "(",        ")",           "sqrt(",
                                   "^",        "*",           "/",
                                   "mm",       "3mm",         "0.8m/s",
                                   "20deg",    "e=0.5",       "r=1",
                                   "count=3",  "box=0,0,9,9", "e",
                                   "1e308",    "within",      "-",
                                   "..",       "x=0",         "kind=a",
                                   "W=3",      "every=1",     "\t",
                                   "\xc3\xa4", "carom",       "1",
                                   "use",      "show",        "cell=2",
                                   "o#*",      "m=1..2",      "v=1,1",
                                   "at=W,W",   "r=W",         "binomial(2,0.5)",
                                   "of=bins",  "against=",    "step=1,1",
                                   "2"};
    for (const std::string_view keyword : all_statements().keywords())
        words.emplace_back(keyword);
    for (const Statement& statement : all_statements().rows())
        words.emplace_back(statement.name);
    return words;
}

}  // namespace

TEST_CASE("the loader survives random bytes") {
    Dice dice(1);
    for (int i = 0; i < 3000; ++i) {
        std::string text = dice.below(2) == 0 ? "carom 1 \"A\"\n" : "";
        const std::uint64_t size = dice.below(300);
        for (std::uint64_t k = 0; k < size; ++k)
            text += static_cast<char>(dice.below(i % 2 == 0 ? 256 : 128));
        check_survives(text, {});
    }
}

TEST_CASE("the loader survives random words") {
    Dice dice(2);
    const std::vector<std::string> words = soup_words();
    for (int i = 0; i < 5000; ++i) {
        std::string text = "carom 1 \"A\"\n";
        const std::uint64_t size = dice.below(80);
        for (std::uint64_t k = 0; k < size; ++k) {
            text += words[dice.below(words.size())];
            if (dice.below(4) != 0) text += ' ';
        }
        check_survives(text, {});
    }
}

TEST_CASE("the loader survives mutated levels") {
    Dice dice(3);
    const std::vector<std::string> texts = seeds();
    const std::vector<std::string> words = soup_words();
    REQUIRE(texts.size() > 100);
    const LoadOptions options =
        options_for(std::filesystem::path(CAROM_SOURCE_DIR) / "tests/level/broken");
    for (int i = 0; i < 1500; ++i) {
        std::string text = texts[dice.below(texts.size())];
        for (std::uint64_t k = 0; k <= dice.below(6); ++k) {
            const std::size_t at = dice.below(text.size() + 1);
            const std::string& word = words[dice.below(words.size())];
            switch (dice.below(5)) {
                case 0:
                    text.insert(at, word);
                    break;
                case 1:
                    text.erase(at, dice.below(9));
                    break;
                case 2:
                    text.replace(at, std::min<std::size_t>(word.size(), text.size() - at), word);
                    break;
                case 3: {
                    // A piece of another level.
                    const std::string& other = texts[dice.below(texts.size())];
                    const std::size_t from = dice.below(other.size() + 1);
                    text.insert(at, other.substr(from, dice.below(100)));
                    break;
                }
                default:
                    if (at < text.size()) text[at] = static_cast<char>(dice.below(256));
            }
        }
        check_survives(text, options);
    }
}
