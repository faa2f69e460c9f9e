#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Writes JSON, front to back.
namespace carom {

/// The shortest decimal that reads back to the same double. It always has a point or an exponent,
/// so that readers that distinguish integers from doubles keep the sign of -0. `null` for infinity
/// and NaN, which JSON cannot express.
std::string json_number(double value);

/// `text` in quotes, with all necessary escapes. Bytes that are not UTF-8 are replaced by U+FFFD,
/// so the result is always valid UTF-8.
std::string json_string(std::string_view text);

/// Adds the commas and line breaks. Keys and values alternate inside an object; every object and
/// list that is opened must be closed, which is asserted.
class JsonWriter {
  public:
    /// Whether the members of an object or a list stand on lines of their own.
    enum class Layout : std::uint8_t { lines, one_line };

    void begin_object(Layout layout);
    void end_object();
    void begin_list(Layout layout);
    void end_list();

    void key(std::string_view name);
    void value(double number);
    void value(std::uint64_t number);
    void value(std::int64_t number);
    void value(bool truth);
    void value(std::string_view text);
    void value(const char* text) { value(std::string_view(text)); }
    void null();

    template <class Value>
    void field(std::string_view name, const Value& content) {
        key(name);
        value(content);
    }

    /// The text so far, ended by a newline.
    std::string text() &&;

  private:
    void before_member();
    void open(char bracket, Layout layout);
    void close(char bracket);

    std::string text_;
    std::string layouts_;  // one character per nesting level: 'l' lines, 'o' one line
    bool is_first_ = true;
    bool is_after_key_ = false;
};

}  // namespace carom
