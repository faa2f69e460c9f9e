#include "level/build/includes.h"

#include <fmt/format.h>

#include <algorithm>

#include "level/build/all_statements.h"

namespace carom {
namespace {

constexpr std::size_t max_included_bytes = 16u << 20;

// The reason for which a path is refused; empty: it is accepted.
std::string_view refusal(std::string_view path) {
    if (path.empty()) return "the path is empty";
    if (path.find('\\') != std::string_view::npos) return "the path has a '\\'";
    if (path.front() == '/' || path.find(':') != std::string_view::npos) {
        return "the path is absolute";
    }
    while (!path.empty()) {
        const std::size_t slash = path.find('/');
        if (path.substr(0, slash) == "..") return "the path leads upward";
        path.remove_prefix(slash == std::string_view::npos ? path.size() : slash + 1);
    }
    return "";
}

}  // namespace

std::optional<Included> Includes::open(const Word& path, const Word& keyword) {
    const std::string_view text = path.text;
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') {
        reporter_.error("path-without-quotes", path.span(), "the path stands in quotes",
                        R"(write it as: include "FILE")");
        return std::nullopt;
    }
    const std::string_view inner = text.substr(1, text.size() - 2);
    if (const std::string_view why = refusal(inner); !why.empty()) {
        reporter_.error("path-refused", path.span(), std::string(why),
                        "include files in the level's own folder, such as \"parts.level\"");
        return std::nullopt;
    }
    if (open_.size() >= max_block_depth) {
        reporter_.error("include-too-deep", path.span(),
                        fmt::format("includes are nested deeper than {}", max_block_depth),
                        "include less deeply");
        return std::nullopt;
    }
    const std::optional<IncludedFile> found =
        resolver_ ? resolver_(path.source->name, inner) : std::nullopt;
    if (!found) {
        reporter_.error("unknown-file", path.span(), fmt::format("there is no file {}", text),
                        "paths are relative to the folder of the file that includes");
        return std::nullopt;
    }
    const bool is_main = found->file == store_.sources.front().name;
    if (is_main || std::ranges::count(open_, found->file) > 0) {
        reporter_.error("include-of-itself", path.span(),
                        fmt::format("{} includes itself", found->file),
                        "take one include of the circle out");
        return std::nullopt;
    }
    if (const auto known = files_.find(found->file); known != files_.end()) {
        open_.push_back(found->file);
        return Included{known->second.tree, false};
    }
    bytes_ += found->text.size();
    if (bytes_ > max_included_bytes) {
        reporter_.error("include-too-large", path.span(),
                        "all includes together have more than 16 MiB", "include less");
        return std::nullopt;
    }
    std::vector<IncludedFrom> chain{{path.source->name, keyword.line}};
    chain.insert(chain.end(), path.source->included_from.begin(), path.source->included_from.end());
    const SourceText& source = store_.add(found->file, found->text, std::move(chain));
    if (const auto fault = find_fault(source.text)) {
        reporter_.error(fault->code, {&source, fault->line, fault->column, 1}, fault->message,
                        fault->remedy);
        return std::nullopt;
    }
    const auto& tree = store_.trees.emplace_back(read_blocks(source, all_statements(), reporter_));
    files_[found->file] = {&source, &tree};
    open_.push_back(found->file);
    return Included{&tree, true};
}

}  // namespace carom
