// Physical dimensions and numbers with a unit. bondstatic works in any one consistent unit system; a string
// such as "200 GPa" fixes it to SI and has its dimension checked.
#pragma once

#include <string>
#include <string_view>

namespace bondstatic {

/// Exponents of kilogram, metre and second.
struct Dimension {
  int mass = 0;
  int length = 0;
  int time = 0;
  bool operator==(const Dimension&) const = default;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{0, 1, 0};
inline constexpr Dimension time{0, 0, 1};
inline constexpr Dimension velocity{0, 1, -1};
inline constexpr Dimension density{1, -3, 0};
inline constexpr Dimension acceleration{0, 1, -2};
inline constexpr Dimension force{1, 1, -2};
inline constexpr Dimension moment{1, 2, -2};
inline constexpr Dimension stress{1, -1, -2};
inline constexpr Dimension stress_per_length{1, -2, -2};
inline constexpr Dimension stiffness{1, 0, -2};             // force per length
inline constexpr Dimension rotational_stiffness{1, 2, -2};  // moment per radian
}  // namespace dimension

/// The SI unit of a dimension as people write it: "Pa", "N/m", "N m", "Pa/m", "kg/m3", "" for a pure number.
std::string si_unit(Dimension dimension);

/// Value in SI of "200 GPa", "-100 kN", "2 mm", "2e-3 m", "7850 kg/m3", "1 deg" (pure number: radians).
/// Throws std::invalid_argument with a message that names the known units of `expected` where the text has no
/// number, an unknown unit or a unit of another dimension.
double parse_quantity(std::string_view text, Dimension expected);

}  // namespace bondstatic
