// Long files: their bytes do not depend on the threads that format them, nor their numbers on 32 bits.
#include "io/ordered_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bondstatic/model.hpp"
#include "io/csv_writer.hpp"
#include "io/file_set.hpp"
#include "io/scratch_folder.hpp"
#include "io/vtu_writer.hpp"

namespace bondstatic {
namespace {

template <class Write>
std::string written(int threads, Write write) {
  const test::ScratchFolder scratch;
  FileSet files(scratch / "out", {}, threads);
  write(files.create("file"));
  files.commit();
  return test::read_text(scratch / "out/file");
}

TEST(OrderedBlocks, TablesAndGridsDoNotDependOnTheThreads) {
  constexpr Index rows = 50001;
  const auto value = [](Index i) { return i % 97 == 0 ? not_given : std::sin(double(i)) * 1e3; };
  std::vector<Column> columns{{"id", rows, Column::Numbers<Index>([](Index i) { return i * i; })}};
  columns.push_back({"x", rows, Column::Numbers<double>(value)});
  const Column vectors{"u", 3 * rows, Column::Numbers<double>(value), 3};
  std::vector<double> points;
  std::vector<Index> lines;
  for (Index i = 0; i < rows; ++i) {
    points.insert(points.end(), {double(i), value(i), 0.5});
    lines.insert(lines.end(), {i, (i + 1) % rows});
  }
  const auto table = [&](OutputFile& file) { write_csv(file, columns); };
  const auto grid = [&](OutputFile& file) {
    write_vtu(file, LineGrid{points, lines, std::span(&vectors, 1), columns});
  };
  const std::string table_of_one = written(1, table), grid_of_one = written(1, grid);
  EXPECT_EQ(std::count(table_of_one.begin(), table_of_one.end(), '\n'), rows + 1);
  for (const int threads : {2, 3, 4}) {
    EXPECT_TRUE(written(threads, table) == table_of_one) << threads;
    EXPECT_TRUE(written(threads, grid) == grid_of_one) << threads;
  }
}

TEST(OrderedBlocks, CountsAndOffsetsGoBeyond32Bits) {
  constexpr Index block = Index(1) << 30, count = 5 * block + 3;
  const std::string text = written(2, [&](OutputFile& file) {
    write_blocks(file, count, block, [](Index begin, Index end, fmt::memory_buffer& out) {
      fmt::format_to(std::back_inserter(out), "{}-{} ", begin, end);
    });
  });
  EXPECT_EQ(text,
            "0-1073741824 1073741824-2147483648 2147483648-3221225472 3221225472-4294967296 "
            "4294967296-5368709120 5368709120-5368709123 ");
  const Column column("u", 3 * count, Column::Numbers<double>([](Index i) { return double(i); }), 3);
  EXPECT_EQ(column.rows(), count);
  EXPECT_EQ(std::get<Column::Numbers<double>>(column.at)(3 * count - 1), double(3 * count - 1));
}

TEST(OrderedBlocks, AnInterruptLeavesTheThreads) {
  const test::ScratchFolder scratch;
  int looks = 0;
  FileSet files(
      scratch / "out",
      [&] {
        if (++looks == 3) throw std::runtime_error("enough");
      },
      4);
  const std::string piece(200000, 'x');
  EXPECT_THROW(write_blocks(files.create("file"), 50, 1,
                            [&](Index, Index, fmt::memory_buffer& out) {
                              out.append(piece.data(), piece.data() + piece.size());
                            }),
               std::runtime_error);
  EXPECT_EQ(looks, 3);
}

TEST(OrderedBlocks, WhatFormattingThrowsIsThrown) {
  for (const int threads : {1, 3})
    EXPECT_THROW(written(threads,
                         [](OutputFile& file) {
                           write_blocks(file, 10, 1, [](Index begin, Index, fmt::memory_buffer&) {
                             if (begin == 7) throw std::out_of_range("seven");
                           });
                         }),
                 std::out_of_range);
}

}  // namespace
}  // namespace bondstatic
