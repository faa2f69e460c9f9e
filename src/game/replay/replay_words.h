#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "geometry/vec2.h"

namespace carom {

/// The words of one line, taken from the left. A missing or invalid word gives none, and so does
/// every word after it.
class Words {
  public:
    explicit Words(std::string_view line) : rest_(line) {}

    std::optional<std::string_view> next() {
        if (failed_ || rest_.empty()) return std::nullopt;
        const std::size_t end = rest_.substr(0, rest_.find(' ')).size();
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(end < rest_.size() ? end + 1 : end);
        return word;
    }
    std::string_view rest() const { return rest_; }
    /// The rest of the line.
    std::string_view take_rest() { return std::exchange(rest_, {}); }
    bool done() const { return !failed_ && rest_.empty(); }
    bool failed() const { return failed_; }
    void fail() { failed_ = true; }

    template <typename T>
    T integer(int base = 10) {
        T value{};
        const auto word = next();
        if (!word) return nothing<T>();
        const auto [end, error] =
            std::from_chars(word->data(), word->data() + word->size(), value, base);
        return error == std::errc{} && end == word->data() + word->size() ? value : nothing<T>();
    }
    double real() {
        const auto word = next();
        return word ? real_of(*word) : nothing<double>();
    }
    Vec2 point() {
        const auto word = next();
        const std::size_t comma = word ? word->find(',') : std::string_view::npos;
        if (comma == std::string_view::npos) return nothing<Vec2>();
        return {real_of(word->substr(0, comma)), real_of(word->substr(comma + 1))};
    }
    /// The number of `key=number`, if that comes next.
    std::optional<double> optional_real(std::string_view key) {
        if (failed_ || !rest_.starts_with(key)) return std::nullopt;
        return real_of(next()->substr(key.size()));
    }

  private:
    template <typename T>
    T nothing() {
        failed_ = true;
        return T{};
    }
    double real_of(std::string_view text) {
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
            return nothing<double>();
        return value;
    }

    std::string_view rest_;
    bool failed_ = false;
};

}  // namespace carom
