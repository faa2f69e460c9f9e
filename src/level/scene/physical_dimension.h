#pragma once

/// The physical dimension of a quantity: a length, a speed, an energy.
namespace carom {

/// Exponents of the base dimensions. All zero: a bare number, which takes the dimension of its
/// context.
struct Dimension {
    int length = 0;
    int mass = 0;
    int time = 0;
    int angle = 0;

    friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

inline constexpr Dimension length_dimension{1, 0, 0, 0};
inline constexpr Dimension mass_dimension{0, 1, 0, 0};
inline constexpr Dimension time_dimension{0, 0, 1, 0};
inline constexpr Dimension angle_dimension{0, 0, 0, 1};
inline constexpr Dimension rate_dimension{0, 0, -1, 0};

constexpr Dimension operator*(const Dimension& a, const Dimension& b) {
    return {a.length + b.length, a.mass + b.mass, a.time + b.time, a.angle + b.angle};
}
constexpr Dimension operator/(const Dimension& a, const Dimension& b) {
    return {a.length - b.length, a.mass - b.mass, a.time - b.time, a.angle - b.angle};
}
inline constexpr Dimension speed_dimension{1, 0, -1, 0};
inline constexpr Dimension momentum_dimension{1, 1, -1, 0};
inline constexpr Dimension angular_momentum_dimension{2, 1, -1, 0};
inline constexpr Dimension energy_dimension{2, 1, -2, 0};
inline constexpr Dimension pressure_dimension{0, 1, -2, 0};  ///< in two dimensions, by length
inline constexpr Dimension area_dimension{2, 0, 0, 0};
inline constexpr Dimension modulus_dimension{-1, 1, -2, 0};  ///< Young's, of a solid
inline constexpr Dimension angular_speed_dimension{0, 0, -1, 1};

}  // namespace carom
