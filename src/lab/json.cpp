#include "lab/json.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "level/text/utf8.h"

namespace carom {
namespace {

void append_escaped(std::string& out, char c) {
    switch (c) {
        case '"':
            out += "\\\"";
            return;
        case '\\':
            out += "\\\\";
            return;
        case '\n':
            out += "\\n";
            return;
        case '\t':
            out += "\\t";
            return;
        case '\r':
            out += "\\r";
            return;
        default:
            break;
    }
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
        out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    } else {
        out += c;
    }
}

}  // namespace

std::string json_number(double value) {
    if (!std::isfinite(value)) return "null";
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string json_string(std::string_view text) {
    std::string out = "\"";
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length == 0) {
            out += "\xef\xbf\xbd";
        } else if (length == 1) {
            append_escaped(out, text[0]);
        } else {
            out += text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    out += '"';
    return out;
}

void JsonWriter::before_member() {
    if (is_after_key_) {
        is_after_key_ = false;
        return;
    }
    if (layouts_.empty()) return;
    if (!is_first_) text_ += layouts_.back() == 'l' ? "," : ", ";
    if (layouts_.back() == 'l') {
        text_ += '\n';
        text_.append(2 * layouts_.size(), ' ');
    }
    is_first_ = false;
}

void JsonWriter::open(char bracket, Layout layout) {
    before_member();
    text_ += bracket;
    layouts_ += layout == Layout::lines ? 'l' : 'o';
    is_first_ = true;
}

void JsonWriter::close(char bracket) {
    assert(!layouts_.empty() && !is_after_key_);
    const bool on_lines = layouts_.back() == 'l';
    layouts_.pop_back();
    if (on_lines && !is_first_) {
        text_ += '\n';
        text_.append(2 * layouts_.size(), ' ');
    }
    text_ += bracket;
    is_first_ = false;
}

void JsonWriter::begin_object(Layout layout) {
    open('{', layout);
}
void JsonWriter::end_object() {
    close('}');
}
void JsonWriter::begin_list(Layout layout) {
    open('[', layout);
}
void JsonWriter::end_list() {
    close(']');
}

void JsonWriter::key(std::string_view name) {
    before_member();
    text_ += json_string(name);
    text_ += ": ";
    is_after_key_ = true;
}

void JsonWriter::value(double number) {
    before_member();
    text_ += json_number(number);
}
void JsonWriter::value(std::uint64_t number) {
    before_member();
    text_ += fmt::format("{}", number);
}
void JsonWriter::value(std::int64_t number) {
    before_member();
    text_ += fmt::format("{}", number);
}
void JsonWriter::value(bool truth) {
    before_member();
    text_ += truth ? "true" : "false";
}
void JsonWriter::value(std::string_view text) {
    before_member();
    text_ += json_string(text);
}
void JsonWriter::null() {
    before_member();
    text_ += "null";
}

std::string JsonWriter::text() && {
    assert(layouts_.empty());
    return std::move(text_) + '\n';
}

}  // namespace carom
