#include "io/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/nearest_name.hpp"

namespace bondstatic::test {
namespace {

using testing::ElementsAre;

Table sound(const std::string& text) {
  std::vector<Fault> faults;
  auto table = Table::parse(text, "t.csv", faults);
  if (!table) throw InputError(faults);
  return *table;
}

std::vector<double> column(const Table& table, const std::string& name) {
  std::vector<Fault> faults;
  const auto values = table.numbers(table.find(std::vector<std::string>{name}, faults), true, faults);
  EXPECT_TRUE(faults.empty());
  return values;
}

TEST(Table, ReadsEverySeparator) {
  for (const std::string text :
       {"a,b,c\n1,2.5,-3e2\n4,5,6\n", "a;b;c\n1;2.5;-3e2\n4;5;6", "a\tb\tc\n1\t2.5\t-3e2\n4\t5\t6\n",
        "a b  c\n 1   2.5 -3e2 \n4 5\t6\n", "a, b ,c\r\n1, 2.5 ,-3e2\r\n4,5,6\r\n",
        "# comment, with commas\n\na,b,c # names\n1,+2.5,-300\n\n# 7,8,9\n4,5,6 # last\n",
        "\"a\",\"b\",\"c\"\n\"1\",\"2.5\",-3e2\n4,5,6\n"}) {
    const Table table = sound(text);
    EXPECT_THAT(table.names(), ElementsAre("a", "b", "c")) << text;
    EXPECT_THAT(column(table, "a"), ElementsAre(1, 4)) << text;
    EXPECT_THAT(column(table, "b"), ElementsAre(2.5, 5)) << text;
    EXPECT_THAT(column(table, "c"), ElementsAre(-300, 6)) << text;
  }
}

TEST(Table, EmptyFieldsAreNanWhereAllowed) {
  const Table table = sound("a,b,c\n1,,3\n,5,\n");
  EXPECT_TRUE(std::isnan(column(table, "b")[0]));
  EXPECT_TRUE(std::isnan(column(table, "a")[1]));
  EXPECT_TRUE(std::isnan(column(table, "c")[1]));
  EXPECT_EQ(column(table, "c")[0], 3);
}

TEST(Table, QuotesHoldSeparatorsCommentsAndQuotes) {
  const Table table = sound("name,x\n\"a, \"\"b\"\" #1\",1\nplain,2\n\"\",3\n");
  EXPECT_THAT(table.texts(0), ElementsAre("a, \"b\" #1", "plain", ""));
}

TEST(Table, PlacesAreThoseOfTheFile) {
  const Table table = sound("# top\n\na , bb\n\n 12 ,\t3\n");
  EXPECT_EQ(table.place(0, 1).line, 5);
  EXPECT_EQ(table.place(0, 1).column, 7);
  EXPECT_EQ(table.place(0, 0).column, 2);
  EXPECT_EQ(table.place(-1, 1).line, 3);
  EXPECT_EQ(table.place(-1, 1).column, 5);
}

TEST(Table, NumbersAreReadToTheLastBit) {
  const Table table =
      sound("a\n0.1\n1.7976931348623157e308\n4.9406564584124654e-324\n0.0064093101982724259\n");
  EXPECT_THAT(column(table, "a"),
              ElementsAre(0.1, 1.7976931348623157e308, 4.9406564584124654e-324, 0.0064093101982724259));
}

TEST(Table, SmallWholeNumbersMayLookReal) {
  const Table table = sound("id\n12\n3.0\n1e3\n0\n");
  std::vector<Fault> faults;
  EXPECT_THAT(table.whole_numbers(0, faults), ElementsAre(12, 3, 1000, 0));
  EXPECT_TRUE(faults.empty());
}

TEST(Table, FindsByAliasInAnyCase) {
  std::vector<Fault> faults;
  const Table table = sound("X,Radius\n1,2\n");
  EXPECT_EQ(table.find(std::vector<std::string>{"r", "radius"}, faults), 1);
  EXPECT_EQ(table.find(std::vector<std::string>{"y"}, faults), -1);
  EXPECT_TRUE(faults.empty());
}

TEST(NearestName, IsTheOneMeant) {
  const std::vector<std::string> known{"young", "poisson", "radius", "radius_factor", "uy", "uz"};
  EXPECT_EQ(nearest_name("yuong", known), "young");
  EXPECT_EQ(nearest_name("Poison", known), "poisson");
  EXPECT_EQ(nearest_name("radiusfactor", known), "radius_factor");
  EXPECT_EQ(nearest_name("uw", known), "uy");
  EXPECT_EQ(nearest_name("density", known), "");
  EXPECT_EQ(nearest_name("q", known), "");
  EXPECT_EQ(nearest_name(std::string(100'000, 'y'), known), "");
}

}  // namespace
}  // namespace bondstatic::test
