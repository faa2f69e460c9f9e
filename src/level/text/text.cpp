#include "level/text/text.h"

#include <fmt/format.h>

#include "level/text/utf8.h"

namespace carom {

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
        return TextFault{"file-too-large", 1, 1, "the file has more than 4 MiB",
                         "split it, or draw with repeat and part"};
    }
    int line_number = 0;
    for (const std::string_view line : split_lines(text)) {
        ++line_number;
        if (line.size() > max_line_bytes) {
            return TextFault{"line-too-long", line_number, 1,
                             fmt::format("the line has {} bytes, more than 4096", line.size()),
                             "break it with a '\\' at the end"};
        }
        int column = 1;
        for (std::size_t i = 0; i < line.size(); ++column) {
            if (line[i] == '\0') {
                return TextFault{"nul-byte", line_number, column, "a NUL byte stands here",
                                 "a level is plain text: save it as UTF-8"};
            }
            if (line[i] == '\r') {
                return TextFault{"bare-return", line_number, column,
                                 "a carriage return stands here, and no line ends",
                                 "save the file with line ends of Unix or Windows"};
            }
            const std::size_t length = character_length(line, i);
            if (length == 0) {
                return TextFault{
                    "not-utf8", line_number, column,
                    fmt::format("byte 0x{:02x} is not UTF-8", static_cast<unsigned char>(line[i])),
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
