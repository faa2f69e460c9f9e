#include "level/statements/header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "level/statements/families.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

bool is_named(const Node& node, std::string_view name) {
    return node.statement && node.statement->name == name;
}

std::string_view unquoted(std::string_view text) {
    return text.substr(1, text.size() - 2);
}

bool is_quoted(std::string_view text) {
    return text.size() >= 2 && text.front() == '"' && text.back() == '"';
}

// Whether a line such as `carom 1` has a version that this program reads; reports it if not.
bool check_version(const Word& word, std::string_view what, int own, Reporter& reporter) {
    int version = 0;
    const char* end = word.text.data() + word.text.size();
    const auto [stop, fault] = std::from_chars(word.text.data(), end, version);
    if (fault != std::errc{} || stop != end || version < 1) {
        reporter.error("not-a-version", word.span(),
                       fmt::format("'{}' is not a version", word.text),
                       fmt::format("write {} {}", what, own));
        return false;
    }
    if (version <= own) return true;
    reporter.error("version-too-new", word.span(),
                   fmt::format("the level wants {} version {}, this carom has version {}",
                               what == "carom" ? "format" : "physics", version, own),
                   "use a newer carom");
    return false;
}

void read_title_line(const Node& node, Scene& scene, Reporter& reporter) {
    const std::vector<Word> words = node.rest();
    const std::string usage = R"(write it as: carom 1 "TITLE")";
    if (words.size() != 2) {
        const Word& at = words.size() > 2 ? words[2] : node.keyword();
        reporter.error("title-line-malformed", at.span(),
                       "the first line has a version and a title", usage);
        return;
    }
    if (!check_version(words[0], "carom", format_version, reporter)) return;
    if (!is_quoted(words[1].text)) {
        // A missing closing quote has been reported already.
        if (words[1].text[0] != '"') {
            reporter.error("title-without-quotes", words[1].span(), "the title stands in quotes",
                           usage);
        }
        return;
    }
    scene.title = printable(unquoted(words[1].text));
}

// Removes trailing blanks, empty lines at the end, and the indentation that all lines share.
void trim(std::vector<std::string>& lines) {
    std::size_t margin = std::string::npos;
    for (std::string& line : lines) {
        line.erase(line.find_last_not_of(' ') + 1);
        if (!line.empty()) margin = std::min(margin, line.find_first_not_of(' '));
    }
    for (std::string& line : lines)
        line.erase(0, margin);
    while (!lines.empty() && lines.back().empty())
        lines.pop_back();
}

// The block of comment lines at the top of the file, or else directly below its first statement.
std::vector<std::string> opening_comment(const SourceText& source, int first_statement_line) {
    std::vector<std::string> comment;
    const auto mark = [](std::string_view line) {
        const std::size_t first = line.find_first_not_of(" \t");
        return first != std::string_view::npos && line[first] == '#' ? first
                                                                     : std::string_view::npos;
    };
    const auto collect = [&](std::size_t line) {
        for (; line < source.lines.size(); ++line) {
            const std::string_view text = source.lines[line];
            const std::size_t at = mark(text);
            if (at == std::string_view::npos) {
                const bool is_blank = text.find_first_not_of(" \t") == std::string_view::npos;
                if (is_blank && comment.empty()) continue;
                return;
            }
            std::size_t from = std::min(text.find_first_not_of('#', at), text.size());
            if (from < text.size() && text[from] == ' ') ++from;
            comment.emplace_back(printable(text.substr(from)));
        }
    };
    collect(0);
    if (comment.empty()) collect(static_cast<std::size_t>(first_statement_line));
    trim(comment);
    return comment;
}

void read_units(const Node& node, Scene& scene, Context& context, bool& is_set) {
    const std::vector<Word> words = node.rest();
    if (is_set) {
        context.reporter.error("units-twice", node.keyword().span(), "units stands here again",
                               "keep one of them");
        return;
    }
    is_set = true;
    if (words.size() != 1) {
        context.is_unit_unknown = true;
        context.reporter.error("units-malformed",
                               words.size() > 1 ? words[1].span() : node.keyword().span(),
                               "units takes one unit", "write it as: units mm|cm|m|in");
        return;
    }
    const std::optional<LengthUnit> unit = length_unit_named(words[0].text);
    if (!unit) {
        context.is_unit_unknown = true;
        context.reporter.error(
            "unknown-unit", words[0].span(),
            fmt::format("'{}' is not a unit of length", words[0].text),
            did_you_mean(words[0].text, length_unit_names(), "there are: mm cm m in"));
        return;
    }
    context.unit = scene.unit = *unit;
}

}  // namespace

void read_header(const std::vector<Node>& nodes, const SourceText& source, Scene& scene,
                 Context& context) {
    Reporter& reporter = context.reporter;
    if (nodes.empty()) {
        if (!reporter.has_errors()) {
            reporter.error("file-empty", {&source, 1, 1, 1}, "the file is empty",
                           R"(a level begins with a line such as: carom 1 "My level")");
        }
        return;
    }
    if (is_named(nodes.front(), "carom")) {
        read_title_line(nodes.front(), scene, reporter);
    } else if (nodes.front().statement) {
        reporter.error("format-missing", nodes.front().keyword().span(),
                       "the level does not say its format",
                       R"(begin it with a line such as: carom 1 "My level")");
    }
    scene.comment = opening_comment(source, nodes.front().keyword().line);

    bool has_units = false;
    for (const Node& node : nodes) {
        if (is_named(node, "carom") && &node != &nodes.front()) {
            reporter.error("format-not-first", node.keyword().span(),
                           "carom stands only in the first line", "take this line out");
        }
        if (is_named(node, "physics") && node.rest().size() == 1) {
            check_version(node.rest()[0], "physics", physics_version, reporter);
        }
        if (is_named(node, "units")) read_units(node, scene, context, has_units);
        if (!is_named(node, "let")) continue;
        for (const Word& word : node.rest()) {
            const std::string_view name = word.text.substr(0, word.text.find('='));
            context.top_level_lets.emplace(std::string(name), word.line);
        }
    }
}

void read_fragment_header(const std::vector<Node>& nodes, Context& context) {
    for (const Node& node : nodes) {
        const std::vector<Word> words = node.rest();
        if (is_named(node, "carom")) {
            Scene ignored;
            read_title_line(node, ignored, context.reporter);
        }
        if (is_named(node, "physics") && words.size() == 1) {
            check_version(words[0], "physics", physics_version, context.reporter);
        }
        if (!is_named(node, "units") || words.size() != 1 || context.is_unit_unknown) continue;
        if (length_unit_named(words[0].text) == context.unit) continue;
        const std::string_view own = symbol(context.unit);
        context.reporter.error(
            "units-of-include-differ", words[0].span(),
            own.empty() ? "the level that includes this file has no units"
                        : fmt::format("the level that includes this file has units {}", own),
            "use the same units in both");
    }
}

std::vector<Statement> header_statements() {
    return {
        {.name = "carom",
         .usage = R"(carom 1 "TITLE")",
         .place = Place::top,
         .plain_least = 2,
         .plain_most = 2},
        {.name = "physics",
         .usage = "physics 1",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1},
        {.name = "units",
         .usage = "units mm|cm|m|in",
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1},
    };
}

}  // namespace carom
