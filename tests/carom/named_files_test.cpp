#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "carom/support/process.h"

// Comments and pages send readers to other files. A name that no file has sends them nowhere.

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> endings{".h", ".cpp", ".md"};

bool is_file_name_part(char c) {
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// The names of source files and pages in a text: "solver.h", "event/README.md".
std::vector<std::string> names_in(std::string_view text) {
    std::vector<std::string> names;
    for (const std::string_view ending : endings)
        for (std::size_t at = text.find(ending); at != text.npos; at = text.find(ending, at + 1)) {
            const std::size_t end = at + ending.size();
            if (end < text.size() && is_file_name_part(text[end])) continue;
            std::size_t begin = at;
            while (begin > 0 && (is_file_name_part(text[begin - 1]) || text[begin - 1] == '.' ||
                                 text[begin - 1] == '/' || text[begin - 1] == '-'))
                --begin;
            std::string_view name = text.substr(begin, end - begin);
            while (name.starts_with("../"))
                name.remove_prefix(3);
            // Neither a pattern such as {a,b}_test.cpp, nor a place to fill in, nor an address.
            const bool is_name = is_file_name_part(name.front()) && name.front() != '_' &&
                                 name.find("NAME") == name.npos && name.find("//") == name.npos;
            if (is_name) names.emplace_back(name);
        }
    return names;
}

// Every file of the repository by each of the ends of its path: "physics/solver.h", "solver.h".
std::set<std::string> known_names() {
    std::set<std::string> known;
    const fs::path root(CAROM_SOURCE_DIR);
    const auto add = [&](const fs::path& file) {
        const std::string name = file.lexically_relative(root).string();
        known.insert(name);
        for (std::size_t at = name.find('/'); at != name.npos; at = name.find('/', at + 1))
            known.insert(name.substr(at + 1));
    };
    for (const char* const folder : {"src", "docs", "tests", "benchmarks"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file()) add(entry.path());
    add(root / "README.md");
    return known;
}

// What a file says to people: all of a page, the comments of a source file.
std::string words_of(const fs::path& file) {
    const std::string text = carom::test::content(file.string());
    if (file.extension() == ".md") return text;
    std::string words;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        const std::size_t comment = text.find("//", from);
        if (comment < end) words += text.substr(comment, end - comment) + '\n';
        from = end + 1;
    }
    return words;
}

}  // namespace

TEST_CASE("named files: names are found in a text, and patterns and addresses are not") {
    const std::vector<std::string> names = names_in(
        "See ../a/b.h, (c-d.md) and e.cpp. Not f.html, {g,h}_test.cpp, src/NAME.cpp, "
        "https://example.org/i.md, j.hpp");
    CHECK(names == std::vector<std::string>{"a/b.h", "e.cpp", "c-d.md"});
}

TEST_CASE("named files: every file that a comment or a page names exists") {
    const std::set<std::string> known = known_names();
    std::vector<fs::path> files{fs::path(CAROM_SOURCE_DIR) / "README.md"};
    for (const char* const folder : {"src", "docs"})
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(CAROM_SOURCE_DIR) / folder))
            if (std::ranges::find(endings, entry.path().extension().string()) != endings.end())
                files.push_back(entry.path());
    REQUIRE(files.size() > 300);
    std::ranges::sort(files);
    for (const fs::path& file : files)
        for (const std::string& name : names_in(words_of(file))) {
            INFO(file.string() << " names " << name);
            CHECK(known.contains(name));
        }
}
