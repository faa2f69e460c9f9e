#include "level/text/text.h"

#include <fmt/format.h>

namespace carom {
namespace {

unsigned byte_at(std::string_view text, std::size_t i) {
    return static_cast<unsigned char>(text[i]);
}

}  // namespace

std::size_t character_length(std::string_view text, std::size_t i) {
    const unsigned first = byte_at(text, i);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || i + length > text.size()) return 0;
    unsigned low = 0x80;
    unsigned high = 0xbf;
    if (first == 0xe0) low = 0xa0;
    if (first == 0xed) high = 0x9f;
    if (first == 0xf0) low = 0x90;
    if (first == 0xf4) high = 0x8f;
    for (std::size_t k = 1; k < length; ++k) {
        const unsigned next = byte_at(text, i + k);
        if (next < low || next > high) return 0;
        low = 0x80;
        high = 0xbf;
    }
    return length;
}

int characters(std::string_view text) {
    int count = 0;
    for (const char c : text)
        count += (static_cast<unsigned char>(c) & 0xc0u) != 0x80u;
    return count;
}

std::vector<std::string_view> split_lines(std::string_view text) {
    if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        lines.push_back(line);
    }
    return lines;
}

std::optional<TextFault> find_fault(std::string_view text) {
    if (text.size() > max_file_bytes) {
        return TextFault{1, 1, "the file has more than 4 MiB",
                         "split it, or draw with repeat and part"};
    }
    int line_number = 0;
    for (const std::string_view line : split_lines(text)) {
        ++line_number;
        if (line.size() > max_line_bytes) {
            return TextFault{line_number, 1,
                             fmt::format("the line has {} bytes, more than 4096", line.size()),
                             "break it with a '\\' at the end"};
        }
        int column = 1;
        for (std::size_t i = 0; i < line.size(); ++column) {
            if (line[i] == '\0') {
                return TextFault{line_number, column, "a NUL byte stands here",
                                 "a level is plain text: save it as UTF-8"};
            }
            const std::size_t length = character_length(line, i);
            if (length == 0) {
                return TextFault{line_number, column,
                                 fmt::format("byte 0x{:02x} is not UTF-8", byte_at(line, i)),
                                 "save the file as UTF-8"};
            }
            i += length;
        }
    }
    return std::nullopt;
}

std::string legible(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = character_length(text, i);
        if (length == 0) {
            result += '?';
            ++i;
        } else {
            result += text.substr(i, length);
            i += length;
        }
    }
    return result;
}

}  // namespace carom
