#pragma once

/// The balls of snooker by number: 1 to 15 are red, then follow the colours.
namespace carom::snooker {

inline constexpr int red_count = 15;
inline constexpr int yellow = 16;
inline constexpr int green = 17;
inline constexpr int brown = 18;
inline constexpr int blue = 19;
inline constexpr int pink = 20;
inline constexpr int black = 21;

constexpr bool is_red(int ball) {
    return ball >= 1 && ball <= red_count;
}
constexpr bool is_color(int ball) {
    return ball >= yellow && ball <= black;
}
/// 1 for a red, 2 for the yellow, ... 7 for the black.
constexpr int value_of(int ball) {
    return is_red(ball) ? 1 : ball - yellow + 2;
}

}  // namespace carom::snooker
