#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "terminal/canvas/canvas.h"

/// Encodes colours and attributes as SGR sequences, ESC [ parameters m (ECMA-48 8.3.117, with
/// xterm's extensions for 16, 256 and 2^24 colours).
namespace carom {

struct SgrStyle {
    Color foreground = default_color;
    Color background = default_color;
    std::uint8_t attributes = plain;  ///< of enum Attribute

    friend bool operator==(const SgrStyle&, const SgrStyle&) = default;
};

/// One sequence, or two for a reset followed by a style. It cannot exceed its buffer: two 24-bit
/// colours and all attributes take 48 bytes.
class SgrText {
  public:
    std::string_view text() const { return {bytes_.data(), size_}; }
    std::size_t size() const { return size_; }
    void add(char byte) { bytes_[size_++] = byte; }
    void add(std::string_view text);
    void add_number(int number);  ///< Pre: 0 <= number <= 999.

  private:
    std::array<char, 64> bytes_;
    std::size_t size_ = 0;
};

/// The shortest change from one style to another; empty where they are equal. `from` is empty where
/// the style in force is not known. `has_own_colors`: the terminal understands 39 and 49, which
/// restore the default foreground and background separately.
SgrText style_change(const std::optional<SgrStyle>& from, const SgrStyle& to, bool has_own_colors);

}  // namespace carom
