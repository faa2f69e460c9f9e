#include "level/language/blocks.h"

#include <fmt/format.h>

#include <algorithm>

#include "level/text/joined.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

std::string listed(const std::vector<std::string_view>& words) {
    return joined(words, ", ");
}

// The statement that a misspelt keyword stands for: decides only whether it opens a block.
const Statement* guess(const StatementTable& table, std::string_view keyword) {
    const auto nearest = nearest_word(keyword, table.keywords());
    return nearest ? table.find(*nearest) : nullptr;
}

void report_unknown(const StatementTable& table, const Word& keyword, Reporter& reporter) {
    std::string otherwise = "a line begins with a keyword, such as ball or edge";
    const std::vector<std::string_view> keywords = table.keywords();
    for (const std::string_view first : keywords) {
        if (meant_by(keyword.text, keywords)) break;  // `circle` is a peg, not `paint circle`
        const std::vector<std::string_view> seconds = table.second_words(first);
        if (std::ranges::count(seconds, keyword.text) > 0) {
            reporter.error("unknown-statement", keyword.span(),
                           fmt::format("'{}' is not a statement", keyword.text),
                           fmt::format("did you mean '{} {}'?", first, keyword.text));
            return;
        }
    }
    reporter.error("unknown-statement", keyword.span(),
                   fmt::format("'{}' is not a statement", keyword.text),
                   did_you_mean(keyword.text, keywords, otherwise));
}

const Statement* find_statement(const StatementTable& table, const std::vector<Word>& words,
                                Reporter& reporter) {
    const Word& keyword = words.front();
    if (const Statement* statement = table.find(keyword.text)) return statement;
    const std::vector<std::string_view> seconds = table.second_words(keyword.text);
    if (seconds.empty()) {
        report_unknown(table, keyword, reporter);
        return nullptr;
    }
    if (words.size() < 2) {
        reporter.error("second-word-missing", keyword.span(),
                       fmt::format("'{}' wants one of its words", keyword.text),
                       fmt::format("they are: {}", listed(seconds)));
        return nullptr;
    }
    const Word& second = words[1];
    const std::string name = fmt::format("{} {}", keyword.text, second.text);
    if (const Statement* statement = table.find(name)) return statement;
    reporter.error("unknown-second-word", second.span(),
                   fmt::format("{} has no '{}'", keyword.text, second.text),
                   did_you_mean(second.text, seconds, fmt::format("it has: {}", listed(seconds))));
    return nullptr;
}

bool is_end(const Word& line) {
    const std::size_t first = line.text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return false;
    const std::size_t last = line.text.find_last_not_of(" \t");
    return line.text.substr(first, last + 1 - first) == "end";
}

void report_no_end(const Node& node, Reporter& reporter) {
    reporter.error("end-missing", node.keyword().span(),
                   fmt::format("'{}' has no 'end'", node.keyword().text),
                   "close it with a line that says end");
}

class BlockReader {
  public:
    BlockReader(const SourceText& source, const StatementTable& table, Reporter& reporter)
        : lines_(source, reporter), table_(table), reporter_(reporter) {}

    std::vector<Node> read() {
        std::vector<Node> nodes;
        read_into(nodes, 0);
        return nodes;
    }

  private:
    // Reads up to the `end` of this block; false: the source ends first.
    bool read_into(std::vector<Node>& nodes, int depth) {
        while (true) {
            std::vector<Word> words = lines_.next();
            if (words.empty()) return false;
            if (words.front().text == "end") {
                if (words.size() > 1) {
                    reporter_.error("word-after-end", words[1].span(),
                                    "nothing stands behind 'end'", "put it on a line of its own");
                }
                if (depth > 0) return true;
                reporter_.error("end-without-block", words.front().span(),
                                "this 'end' closes nothing",
                                "take it out, or open a block above it");
                continue;
            }
            if (is_forgotten_continuation(words, nodes)) continue;
            Node node;
            node.statement = find_statement(table_, words, reporter_);
            node.words = std::move(words);
            read_body(node, depth);
            nodes.push_back(std::move(node));
        }
    }

    // A line that begins with key=value: the line above lacks its backslash. Reports it, and then
    // joins the line to the statement above, as the author meant.
    bool is_forgotten_continuation(const std::vector<Word>& words, std::vector<Node>& nodes) {
        const Word& first = words.front();
        const std::size_t equals = first.text.find('=');
        if (equals == std::string_view::npos || !is_identifier(first.text.substr(0, equals))) {
            return false;
        }
        reporter_.error(
            "unknown-statement", first.span(), fmt::format("'{}' is not a statement", first.text),
            words.size() == 1 ? fmt::format("write let {}, or continue the line above: end it with "
                                            "'\\'",
                                            first.text)
                              : "a '\\' at the end of the line above would continue it");
        if (!nodes.empty() && nodes.back().body.empty()) {
            nodes.back().words.insert(nodes.back().words.end(), words.begin(), words.end());
        }
        return true;
    }

    void read_body(Node& node, int depth) {
        const Statement* shape =
            node.statement ? node.statement : guess(table_, node.keyword().text);
        if (!shape || !shape->opens_block) return;
        if (depth >= max_block_depth) {
            reporter_.stop("block-too-deep", node.keyword().span(),
                           fmt::format("blocks are nested deeper than {}", max_block_depth),
                           "take some of them out, or use part and place");
        }
        const bool is_closed =
            shape->body_is_drawing ? read_drawing(node) : read_into(node.body, depth + 1);
        if (!is_closed) report_no_end(node, reporter_);
    }

    bool read_drawing(Node& node) {
        while (const std::optional<Word> line = lines_.next_verbatim()) {
            if (is_end(*line)) return true;
            node.drawing.push_back(*line);
        }
        return false;
    }

    LineReader lines_;
    const StatementTable& table_;
    Reporter& reporter_;
};

}  // namespace

std::vector<Word> Node::rest() const {
    const auto count = statement ? 1 + std::ranges::count(statement->name, ' ') : 1;
    return {words.begin() + std::min<std::ptrdiff_t>(count, std::ssize(words)), words.end()};
}

std::vector<Node> read_blocks(const SourceText& source, const StatementTable& table,
                              Reporter& reporter) {
    return BlockReader(source, table, reporter).read();
}

}  // namespace carom
