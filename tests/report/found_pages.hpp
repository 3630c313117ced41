// Looking things up in pages, and folders of results to make pages of.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/run_program.hpp"
#include "io/scratch_folder.hpp"
#include "report/csv_columns.hpp"
#include "report/result_folder.hpp"

namespace bondstatic::test {

inline nlohmann::json json_in(const std::filesystem::path& file) {
  return nlohmann::json::parse(read_text(file));
}

/// Runs a command that writes into a folder, and reads what it wrote; the exit code may be 4 (no agreement).
inline void run_into(const ScratchFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--out", folder.path().string()});
  const Ended ended = run_program(std::move(arguments));
  ASSERT_TRUE(ended.code == 0 || ended.code == 4) << ended.err;
}

inline FoundRun only_run(const ScratchFolder& folder) {
  std::vector<FoundRun> runs = read_results(folder.path().string());
  if (runs.size() != 1) throw std::runtime_error("not one run but " + std::to_string(runs.size()));
  return std::move(runs.front());
}

template <class Item>
const Item& titled(const std::vector<Item>& items, const std::string& title) {
  std::string titles;
  for (const Item& item : items) {
    if (item.title == title) return item;
    titles += "\n  " + item.title;
  }
  throw std::runtime_error("no \"" + title + "\" among" + titles);
}

template <class Item>
bool has_title(const std::vector<Item>& items, const std::string& title) {
  return std::any_of(items.begin(), items.end(), [&](const Item& item) { return item.title == title; });
}

inline const PageSeries& named(const PagePlot& plot, const std::string& name) {
  std::string names;
  for (const PageSeries& series : plot.series) {
    if (series.name == name) return series;
    names += "\n  " + series.name;
  }
  throw std::runtime_error("no series \"" + name + "\" among" + names);
}

inline const PageField& cell(const PageTable& table, std::size_t row, const std::string& column) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  if (found == table.columns.end()) throw std::runtime_error(table.title + " has no column " + column);
  return table.rows.at(row).at(std::size_t(found - table.columns.begin()));
}

/// Of a table of quantities and values.
inline const PageField& fact(const PageTable& table, const std::string& name) {
  for (const auto& row : table.rows)
    if (row.front() == PageField(name)) return row.at(1);
  throw std::runtime_error(table.title + " has no row " + name);
}

inline double number(const PageField& field) {
  return std::get<double>(field);
}
inline std::string words(const PageField& field) {
  return std::get<std::string>(field);
}

/// What `call` says when it throws an Error for wrong input; "" where it does not.
template <class Call>
std::string complaint(Call call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    return error.what();
  }
  return "";
}

}  // namespace bondstatic::test
