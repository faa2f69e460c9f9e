#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "carom/support/process.h"

// Every file includes, itself or through carom's own headers, what its names of the standard
// library and of fmt need. Builds with precompiled headers cannot tell, and other builds see only
// what one library's headers happen to include of each other.

namespace {

namespace fs = std::filesystem;

using Headers = std::set<std::string>;

// Headers that promise names. Each of `headers` is enough.
struct Row {
    std::string_view headers;
    std::string_view names;
};

constexpr Row rows[] = {
    {"algorithm",
     "all_of any_of binary_search clamp copy copy_backward count count_if equal fill find find_if "
     "lower_bound max max_element merge min min_element minmax minmax_element mismatch none_of "
     "nth_element pop_heap push_heap remove_if replace reverse rotate sort stable_sort transform "
     "unique upper_bound"},
    {"array", "array to_array"},
    {"bit", "bit_cast bit_width countl_zero countr_zero popcount rotl rotr"},
    {"charconv", "from_chars to_chars"},
    {"cmath",
     "acos asin atan2 cbrt ceil copysign cos exp expm1 fabs floor fmod frexp hypot isfinite isinf "
     "isnan ldexp lgamma llround log log10 log2 lround nextafter pow remainder round sin sqrt tan"},
    {"cstdint", "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t uintptr_t"},
    {"cstring", "memcmp memcpy memset strerror strlen"},
    {"functional", "function greater hash not_equal_to ref"},
    {"iterator string vector map span array string_view", "back_inserter next prev"},
    {"limits", "numeric_limits"},
    {"map", "map multimap"},
    {"memory", "make_shared make_unique shared_ptr unique_ptr"},
    {"numeric", "accumulate iota"},
    {"optional", "nullopt optional"},
    {"set", "set"},
    {"span", "span"},
    {"string", "string to_string u32string"},
    {"string_view string", "string_view u32string_view"},
    {"tuple map utility memory functional", "tie tuple tuple_size_v"},
    {"type_traits variant utility optional bit tuple memory",
     "is_enum_v is_integral_v is_same_v is_trivially_copyable_v underlying_type_t"},
    {"utility map vector algorithm tuple functional optional variant string",
     "as_const exchange forward index_sequence make_index_sequence move pair swap"},
    {"variant", "get_if holds_alternative monostate variant visit"},
    {"vector", "vector"},
};

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream in{std::string(text)};
    std::vector<std::string> words;
    for (std::string word; in >> word;)
        words.push_back(word);
    return words;
}

// By name, the headers of which one is needed.
const std::map<std::string, std::vector<std::string>>& headers_of_names() {
    static const auto table = [] {
        std::map<std::string, std::vector<std::string>> made;
        for (const Row& row : rows)
            for (const std::string& name : words_of(row.names))
                made["std::" + name] = words_of(row.headers);
        return made;
    }();
    return table;
}

bool is_name_character(char c) {
    return c == '_' || c == ':' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
           (c >= 'A' && c <= 'Z');
}

struct Source {
    std::set<std::string> own;  ///< headers of carom that it includes
    Headers others;
    std::set<std::string> names;  ///< of the standard library, and "fmt::"
};

void take_names(const std::string& line, Source& source) {
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() && is_name_character(line[end]))
            ++end;
        const std::string name = line.substr(at, end - at);
        if (name.starts_with("std::ranges::")) source.names.insert("std::" + name.substr(13));
        if (name.starts_with("std::")) source.names.insert(name);
        if (name.starts_with("fmt::")) source.names.insert("fmt::");
        at = std::max(end, at + 1);
    }
}

Source read(const std::string& text) {
    Source source;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const std::size_t open = line.find_first_of("\"<");
        if (line.starts_with("#include") && open != std::string::npos) {
            const std::string name =
                line.substr(open + 1, line.find_first_of("\">", open + 1) - open - 1);
            (line[open] == '<' ? source.others : source.own).insert(name);
        } else {
            take_names(line.substr(0, line.find("//")), source);
        }
    }
    return source;
}

// The names in the source for which no header is among these.
std::vector<std::string> without_header(const Source& source, const Headers& included) {
    std::vector<std::string> names;
    const auto is_included = [&](const std::string& header) { return included.contains(header); };
    for (const std::string& name : source.names) {
        const auto row = headers_of_names().find(name);
        const bool is_missing =
            name == "fmt::"
                ? !is_included("fmt/format.h")
                : row != headers_of_names().end() && std::ranges::none_of(row->second, is_included);
        if (is_missing) names.push_back(name);
    }
    return names;
}

using Sources = std::map<std::string, Source>;

void add_headers(const Sources& sources, const std::string& name, std::set<std::string>& seen,
                 Headers& headers) {
    const auto source = sources.find(name);
    if (source == sources.end() || !seen.insert(name).second) return;
    headers.insert(source->second.others.begin(), source->second.others.end());
    for (const std::string& own : source->second.own)
        add_headers(sources, own, seen, headers);
}

}  // namespace

TEST_CASE("includes: a name without its header is found") {
    const Source source = read(
        "#include <vector>\n#include \"geometry/vec2.h\"\n"
        "std::vector<double> list;  // std::map\n"
        "const auto most = std::ranges::max_element(list);\nstd::string text = "
        "fmt::format(\"\");\n");
    CHECK(source.own == std::set<std::string>{"geometry/vec2.h"});
    CHECK(without_header(source, source.others) ==
          std::vector<std::string>{"fmt::", "std::max_element", "std::string"});
    CHECK(without_header(source, {"vector", "string", "algorithm", "fmt/format.h"}).empty());
}

TEST_CASE("includes: every file includes what its names of other libraries need") {
    const fs::path root = fs::path(CAROM_SOURCE_DIR) / "src";
    Sources sources;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const fs::path& path = entry.path();
        if (path.extension() == ".h" || path.extension() == ".cpp")
            sources[path.lexically_relative(root).string()] =
                read(carom::test::content(path.string()));
    }
    REQUIRE(sources.size() > 100);
    for (const auto& [name, source] : sources) {
        std::set<std::string> seen;
        Headers headers;
        add_headers(sources, name, seen, headers);
        for (const std::string& missing : without_header(source, headers))
            FAIL_CHECK(name, " names ", missing, " without its header");
    }
}
