#include "io/vtu_writer.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <sstream>

#include "io/file_set.hpp"
#include "io/read_by_vtk.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic {
namespace {

std::vector<double> numbers(const std::string& text) {
  std::istringstream words(text);
  std::vector<double> values;
  for (std::string word; words >> word;) values.push_back(std::strtod(word.c_str(), nullptr));
  return values;
}

bool same_bits_or_both_nan(const std::vector<double>& left, const std::vector<double>& right) {
  if (left.size() != right.size()) return false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (std::isnan(left[i]) && std::isnan(right[i])) continue;
    if (std::bit_cast<std::uint64_t>(left[i]) != std::bit_cast<std::uint64_t>(right[i])) return false;
  }
  return true;
}

TEST(VtuWriter, VtkReadsBackEveryBit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> points{0, 0, 0, 0.1, 1e-300, -2, 1.0 / 3, 4, 5e10, 7, 8, 9};
  const std::vector<Index> lines{0, 1, 3, 2, 1, 2};
  const std::vector<double> displacement{1, 2, 3, nan, nan, nan, -0.0, 0.7, 1e-17, 1e300, 5e-324, 6};
  const std::vector<double> sigma{-1.5, nan, 0.1};
  const std::vector<Column> point_data{{"id", std::vector<Index>{1, 2, 40, 1'000'000'007}},
                                       {"displacement", displacement, 3}};
  const std::vector<Column> line_data{{"sigma", sigma}};

  const test::ScratchFolder scratch;
  FileSet files(scratch / "out");
  write_vtu(files.create("model.vtu"), LineGrid{points, lines, point_data, line_data});
  files.commit();

  const auto found = test::read_by_vtk((scratch / "out/model.vtu").string(), scratch);
  const auto at = [&](const std::string& key) {
    return found.count(key) ? found.at(key) : "(VTK did not find " + key + ")";
  };
  EXPECT_EQ(at("points"), "4");
  EXPECT_EQ(at("cells"), "3");
  EXPECT_EQ(at("cell 0"), "3 0 1");
  EXPECT_EQ(at("cell 1"), "3 3 2");
  EXPECT_EQ(at("cell 2"), "3 1 2");
  EXPECT_EQ(at("array point id"), "1 1 2 40 1000000007");
  const auto with_components = [](double components, std::vector<double> values) {
    values.insert(values.begin(), components);
    return values;
  };
  EXPECT_TRUE(same_bits_or_both_nan(numbers(at("array position Points")), with_components(3, points)));
  EXPECT_TRUE(
      same_bits_or_both_nan(numbers(at("array point displacement")), with_components(3, displacement)));
  EXPECT_TRUE(same_bits_or_both_nan(numbers(at("array cell sigma")), with_components(1, sigma)));
}

TEST(VtuWriter, VtkReadsAGridWithoutLines) {
  const std::vector<double> points{1, 2, 3};
  const std::vector<Column> point_data{{"radius", std::vector<double>{0.5}}};
  const test::ScratchFolder scratch;
  FileSet files(scratch / "out");
  write_vtu(files.create("model.vtu"), LineGrid{points, {}, point_data, {}});
  files.commit();
  const auto found = test::read_by_vtk((scratch / "out/model.vtu").string(), scratch);
  ASSERT_EQ(found.count("points"), 1u);
  EXPECT_EQ(found.at("points"), "1");
  EXPECT_EQ(found.at("cells"), "0");
  EXPECT_EQ(found.at("array point radius"), "1 0x1.0000000000000p-1");
}

}  // namespace
}  // namespace bondstatic
