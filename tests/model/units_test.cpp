#include "bondstatic/units.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

namespace bondstatic::test {
namespace {

namespace d = dimension;

struct Quantity {
  std::string text;
  Dimension dimension;
  double value;
};

TEST(Units, AreTheNearestDoubles) {
  const std::vector<Quantity> quantities{
      {"200 GPa", d::stress, 200e9},
      {"-100 kN", d::force, -100e3},
      {"2 mm", d::length, 0.002},
      {"2e-3 m", d::length, 0.002},
      {"2mm", d::length, 0.002},
      {"  +0.7  um ", d::length, 7e-7},
      {"0.7 µm", d::length, 7e-7},
      {"0.3 nm", d::length, 3e-10},
      {"0.3 s", d::time, 0.3},
      {"0.3 ms", d::time, 0.0003},
      {"0.7 us", d::time, 7e-7},
      {"0.7 µs", d::time, 7e-7},
      {"0.3 ns", d::time, 3e-10},
      {"1.5 min", d::time, 90},
      {"0.5 h", d::time, 1800},
      {"0.7 m/s", d::velocity, 0.7},
      {"0.7 m s-1", d::velocity, 0.7},
      {"0.7 mm/s", d::velocity, 0.0007},
      {"0.3 nm/s", d::velocity, 3e-10},
      {"36 km/h", d::velocity, 10},
      {"30 m/min", d::velocity, 0.5},
      {"7850 kg/m3", d::density, 7850},
      {"7.85 g/cm3", d::density, 7850},
      {"7.85 g/cm^3", d::density, 7850},
      {"2.5 t/m3", d::density, 2500},
      {"9.81 m/s2", d::acceleration, 9.81},
      {"9.81 m s^-2", d::acceleration, 9.81},
      {"3 kN m", d::moment, 3000},
      {"3 kN*m", d::moment, 3000},
      {"3 Nm", d::moment, 3},
      {"3 N mm", d::moment, 0.003},
      {"3 mJ", d::moment, 0.003},
      {"5 kJ/m3", d::stress, 5000},
      {"3 kN m/rad", d::moment, 3000},
      {"5 MPa/m", d::stress_per_length, 5e6},
      {"5 N/m3", d::stress_per_length, 5},
      {"5 N/mm2", d::stress, 5e6},
      {"1.1 kN/m", d::stiffness, 1100},
      {"1.1 N/mm", d::stiffness, 1100},
      {"3 cm", d::length, 0.03},
      {"3 km", d::length, 3000},
      {"1 in", d::length, 0.0254},
      {"1 ft", d::length, 0.3048},
      {"2 bar", d::stress, 2e5},
      {"0.25", d::none, 0.25},
      {"25 %", d::none, 0.25},
      {"180 deg", d::none, std::numbers::pi},
      {"0.5 rad", d::none, 0.5},
      {"5 mrad", d::none, 0.005},
      {"1e3 N", d::force, 1000},
      {"5 kg m/s2", d::force, 5},
      {"4 MN", d::force, 4e6},
      {"4 mN", d::force, 0.004},
  };
  for (const Quantity& quantity : quantities)
    EXPECT_EQ(parse_quantity(quantity.text, quantity.dimension), quantity.value) << quantity.text;
}

TEST(Units, ImperialStressesAreThoseOfPoundAndInch) {
  EXPECT_NEAR(parse_quantity("1 psi", d::stress), 4.4482216152605 / (0.0254 * 0.0254), 1e-11);
  EXPECT_NEAR(parse_quantity("1 ksi", d::stress) / parse_quantity("1000 psi", d::stress), 1, 1e-15);
}

TEST(Units, OfAnotherDimensionAreRefusedWithTheKnownOnes) {
  for (const auto& [text, part] : std::vector<std::pair<std::string, std::string>>{
           {"2 kg", "\"kg\" is not of this dimension; a stress is wanted, in Pa, kPa, MPa"},
           {"2 m", "\"m\" is not of this dimension but a length"},
           {"2 min", "\"min\" is not of this dimension but a time"},
           {"2 m/s", "\"m/s\" is not of this dimension but a velocity"},
           {"2 mmin", "unknown unit \"mmin\""},
           {"2", "the number has no unit"},
           {"2 gpa", "unknown unit \"gpa\""},
           {"2 Pa/", "unknown unit"},
           {"2 Pa^", "unknown unit"},
           {"2 Pa^99999999999", "unknown unit"},
           {"2 PaPa", "unknown unit"},
           {"2 /Pa", "unknown unit"},
           {"GPa", "no number found"},
           {"", "no number found"},
           {"nan Pa", "no number found"},
           {"inf Pa", "no number found"},
           {"1e999 Pa", "out of range"}}) {
    try {
      parse_quantity(text, d::stress);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(part)) << text;
    }
  }
}

TEST(Units, SiUnitsReadAsOne) {
  for (const Dimension& dimension :
       {d::length, d::time, d::velocity, d::density, d::acceleration, d::force, d::moment, d::stress,
        d::stress_per_length, d::stiffness, d::rotational_stiffness, Dimension{1, 2, -3}})
    EXPECT_EQ(parse_quantity("1 " + si_unit(dimension), dimension), 1) << si_unit(dimension);
  EXPECT_EQ(si_unit(d::none), "");
  EXPECT_EQ(si_unit(d::stress), "Pa");
}

}  // namespace
}  // namespace bondstatic::test
