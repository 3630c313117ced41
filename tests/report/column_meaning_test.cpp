#include "report/column_meaning.hpp"

#include <gtest/gtest.h>

namespace bondstatic {
namespace {

TEST(ColumnMeaning, UnitsAreThoseOfTheQuantity) {
  const std::pair<const char*, const char*> units[] = {{"displacement", "m"},
                                                       {"run_displacement", "m"},
                                                       {"displacement_difference", "m"},
                                                       {"rotation_difference", "rad"},
                                                       {"uz", "m"},
                                                       {"ry", "rad"},
                                                       {"reaction_fx", "N"},
                                                       {"reaction_mx", "N m"},
                                                       {"applied_force", "N"},
                                                       {"applied_moment", "N m"},
                                                       {"difference_fz", "N"},
                                                       {"run_mz", "N m"},
                                                       {"shear_force", "N"},
                                                       {"bending_moment", "N m"},
                                                       {"tau", "Pa"},
                                                       {"energy", "J"},
                                                       {"velocity", "m/s"},
                                                       {"utilisation", ""},
                                                       {"break_step", ""},
                                                       {"fixed", ""}};
  for (const auto& [name, unit] : units) EXPECT_EQ(unit_of(name, true), unit) << name;
}

TEST(ColumnMeaning, UnitsOfTheUsersOwnAreNotNamed) {
  EXPECT_EQ(unit_of("displacement", false), "");
  EXPECT_EQ(unit_of("rotation", false), "rad");
}

TEST(ColumnMeaning, SignsSaySomethingWhereThereAreTwo) {
  for (const char* name : {"normal_force", "sigma", "twisting_moment", "fx", "difference_mx", "displacement"})
    EXPECT_TRUE(page_column({name, 1, false}, true).is_signed) << name;
  for (const char* name : {"shear_force", "bending_moment", "tau", "energy", "utilisation", "radius"})
    EXPECT_FALSE(page_column({name, 1, false}, true).is_signed) << name;
  const PageColumn steps = page_column({"break_step", 1, true}, true);
  EXPECT_TRUE(steps.is_whole);
  EXPECT_FALSE(steps.is_signed);
}

}  // namespace
}  // namespace bondstatic
