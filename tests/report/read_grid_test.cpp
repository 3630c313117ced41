#include "report/read_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bondstatic/error.hpp"
#include "io/vtu_writer.hpp"
#include "report/grids.hpp"

namespace bondstatic {
namespace {

using test::ScratchFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using Of = Grid::Of;

const std::vector<double> points{0, 0, 0, 0.1, 1e-300, -2, 1.0 / 3, 4, 5e10, 7, 8, 9};
const std::vector<Index> lines{0, 1, 3, 2, 1, 2};
const std::vector<Index> ids{1, 2, 40, 1'000'000'007};
const std::vector<double> displacement{1, 2, 3, -0.0, 0.7, 1e-17, 1e300, 5e-324, 6, 4, 3, 2};
const std::vector<double> sigma{-1.5, 2.5, 0.1};

struct ReadGrid : testing::Test {
  const ScratchFolder scratch;

  std::string write(std::optional<Index> first_copy = {}) const {
    FileSet files(scratch / "out");
    files.supersede({"model.vtu"});
    const std::vector<Column> point_data{{"id", ids}, {"displacement", displacement, 3}};
    const std::vector<Column> line_data{{"sigma", sigma}};
    write_vtu(files.create("model.vtu"), LineGrid{points, lines, point_data, line_data, first_copy});
    files.commit();
    return (scratch / "out/model.vtu").string();
  }

  /// What is said of the file when `was` is replaced by `is`, and everything asked for.
  std::string refused(const std::string& was, const std::string& is) const {
    std::string text = test::read_text(write(3));
    const auto at = text.find(was);
    if (at == std::string::npos) return "(no " + was + " in the file)";
    text.replace(at, was.size(), is);
    return refused(text);
  }

  std::string refused(const std::string& text) const {
    const std::string file = scratch.write("damaged.vtu", text);
    try {
      const Grid grid({file});
      for (const Of of : {Of::points, Of::lines})
        for (const GridArray& array : grid.arrays(of)) grid.numbers(of, array.name);
      grid.positions(), grid.ends(), grid.copies();
      return "(read)";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalid_input);
      EXPECT_THAT(error.what(), HasSubstr(file + ": "));
      EXPECT_THAT(error.what(), HasSubstr("cure: solve the case again"));
      return error.what();
    }
  }
};

TEST_F(ReadGrid, EveryBitComesBack) {
  const Grid grid({write()});
  EXPECT_EQ(grid.count(Of::points), 4);
  EXPECT_EQ(grid.count(Of::lines), 3);
  EXPECT_EQ(grid.positions(), points);
  EXPECT_EQ(grid.ends(), lines);
  EXPECT_EQ(grid.copies(), std::vector<bool>(4, false));
  EXPECT_EQ(grid.arrays(Of::points), (std::vector<GridArray>{{"id", 1, true}, {"displacement", 3, false}}));
  EXPECT_EQ(grid.arrays(Of::lines), (std::vector<GridArray>{{"sigma", 1, false}}));
  EXPECT_EQ(grid.whole_numbers(Of::points, "id"), ids);
  EXPECT_EQ(grid.numbers(Of::points, "id"), std::vector<double>(ids.begin(), ids.end()));
  EXPECT_EQ(grid.numbers(Of::points, "displacement"), displacement);
  EXPECT_EQ(grid.numbers(Of::lines, "sigma"), sigma);
  EXPECT_TRUE(grid.has(Of::lines, "sigma"));
  EXPECT_FALSE(grid.has(Of::points, "sigma"));
}

TEST_F(ReadGrid, CopiesAreToldAndAreNoColumn) {
  const Grid grid({write(3)});
  EXPECT_EQ(grid.copies(), (std::vector<bool>{false, false, false, true}));
  EXPECT_EQ(grid.arrays(Of::points).size(), 2u);
}

TEST_F(ReadGrid, PiecesFollowOneAnother) {
  const std::string file = write(3);
  const Grid grid({file, file});
  EXPECT_EQ(grid.count(Of::points), 8);
  EXPECT_THAT(grid.ends(), ElementsAre(0, 1, 3, 2, 1, 2, 4, 5, 7, 6, 5, 6));
  EXPECT_THAT(grid.numbers(Of::lines, "sigma"), ElementsAre(-1.5, 2.5, 0.1, -1.5, 2.5, 0.1));
  EXPECT_EQ(grid.positions().size(), 24u);
}

TEST_F(ReadGrid, FilesThatAreNotThereAreNamed) {
  for (const char* name : {"nothing.vtu", "."}) try {
      Grid({(scratch / name).string()});
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalid_input);
      EXPECT_THAT(error.what(), HasSubstr(scratch.path().string()));
    }
}

TEST_F(ReadGrid, DamagedFilesAreRefused) {
  const std::string whole = test::read_text(write(3));
  EXPECT_THAT(refused(whole.substr(0, whole.find("<CellData>"))), HasSubstr("damaged at byte"));
  for (const std::size_t lost : {1, 20, 30, 400})
    EXPECT_THAT(refused(whole.substr(0, whole.size() - lost)), HasSubstr("does not end as it was written"));
  EXPECT_THAT(refused(whole + "\n"), HasSubstr("does not end as it was written"));
  EXPECT_THAT(refused(""), HasSubstr("damaged at byte 0"));
  EXPECT_THAT(refused("id,x,y\n1,2,3\n"), HasSubstr("damaged at byte"));
  EXPECT_THAT(refused("<a/>"), HasSubstr("no VTKFile"));
  EXPECT_THAT(refused("type=\"UnstructuredGrid\"", "type=\"PolyData\""), HasSubstr("type PolyData"));
  EXPECT_THAT(refused("LittleEndian", "BigEndian"), HasSubstr("byte_order is \"BigEndian\""));
  EXPECT_THAT(refused("UInt64", "UInt32"), HasSubstr("header_type"));
  EXPECT_THAT(refused("header_type", "compressor=\"vtkZLibDataCompressor\" header_type"),
              HasSubstr("compressor"));
  EXPECT_THAT(refused("<Piece ", "<Piece/><Piece "), HasSubstr("no single Piece"));
  EXPECT_THAT(refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"5\""), HasSubstr("bytes are no 5 rows"));
  EXPECT_THAT(refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"4000\""),
              HasSubstr("4000 points and 3 lines"));
  EXPECT_THAT(refused("NumberOfCells=\"3\"", "NumberOfCells=\"3000\""), HasSubstr("4 points and 3000 lines"));
  for (const char* count : {"-1", "4.5", "", "9223372036854775807", "99999999999999999999"})
    EXPECT_THAT(refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"" + std::string(count) + "\""),
                HasSubstr("no count"));
  EXPECT_THAT(refused("NumberOfComponents=\"3\"", "NumberOfComponents=\"2\""), HasSubstr("2 components"));
  EXPECT_THAT(refused("Int64\" Name=\"id", "Float32\" Name=\"id"), HasSubstr("Float32"));
  for (const char* nowhere : {"ascii\" offset=\"0\"", "appended\"", "appended\" offset=\"500\"",
                              "appended\" offset=\"18446744073709551615\"", "appended\" offset=\"1\""})
    EXPECT_THAT(refused("appended\" offset=\"0\"", nowhere), HasSubstr("array id is damaged"));
  EXPECT_THAT(refused("_" + std::string(1, char(4 * 8)), "_" + std::string(1, char(3 * 8))),
              HasSubstr("24 bytes are no 4 rows"));
  EXPECT_THAT(refused("encoding=\"raw\"", "encoding=\"base64\""), HasSubstr("damaged at byte"));
  EXPECT_THAT(refused(whole.substr(0, whole.find("<AppendedData")) + "</VTKFile>\n"),
              HasSubstr("no appended raw data"));
  EXPECT_THAT(refused("Name=\"offsets\"", "Name=\"o\""), HasSubstr("no array offsets"));
  EXPECT_THAT(refused("<Points>", "<Spots>"), HasSubstr("damaged at byte"));
}

TEST_F(ReadGrid, NoMoreOfAFileIsReadThanCanBeXml) {
  EXPECT_THAT(refused("<VTKFile>" + std::string(std::size_t(1) << 24, ' ')),
              HasSubstr("no appended raw data in its first 16777216 bytes"));
}

TEST_F(ReadGrid, XmlOfAnyLengthIsRead) {
  // The beginning of the data lies across the pieces that are read.
  const std::string whole = test::read_text(write(3));
  const auto data = whole.find("<AppendedData");
  for (std::size_t at = 65536 - 40; at < 65536 + 10; ++at) {
    std::string text = whole;
    text.insert(data, std::string(at - data, ' '));
    EXPECT_EQ(refused(text), "(read)") << at;
  }
}

TEST_F(ReadGrid, GridsThatCannotBeAreRefused) {
  const auto refused_grid = [&](const std::vector<double>& at, const std::vector<Index>& ends) {
    FileSet files(scratch / "out");
    files.supersede({"model.vtu"});
    const std::vector<Column> none;
    write_vtu(files.create("model.vtu"), LineGrid{at, ends, none, none});
    files.commit();
    return refused(test::read_text(scratch / "out/model.vtu"));
  };
  EXPECT_THAT(refused_grid(points, {0, 4}), HasSubstr("line 0 ends at point 4 of 4"));
  EXPECT_THAT(refused_grid(points, {0, 1, -1, 0}), HasSubstr("line 1 ends at point -1"));
  EXPECT_THAT(refused_grid({0, 0, not_given}, {}), HasSubstr("point 0 lies nowhere"));
}

TEST_F(ReadGrid, ArraysThatAreNotThereAreNamed) {
  const Grid grid({write()});
  EXPECT_THROW(grid.numbers(Of::lines, "tau"), Error);
  EXPECT_THROW(grid.whole_numbers(Of::lines, "sigma"), Error);
}

TEST_F(ReadGrid, PiecesOfDifferentRunsAreRefused) {
  FileSet files(scratch / "other");
  const std::vector<Column> point_data{{"id", ids}}, line_data{{"sigma", sigma}};
  write_vtu(files.create("model.vtu"), LineGrid{points, lines, point_data, line_data});
  files.commit();
  EXPECT_THROW(Grid({write(), (scratch / "other/model.vtu").string()}), Error);
}

}  // namespace
}  // namespace bondstatic
