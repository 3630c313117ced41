// Several processes under mpirun as one run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include "app/run_program.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::cantilever;
using test::Ended;
using test::everything_in;
using test::Program;
using test::read_text;
using test::ScratchFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Clock = std::chrono::steady_clock;

constexpr const char* packing = R"([[particles]]
lattice = { kind = "fcc", count = [3, 4, 5], spacing = 1.0 }
radius = 0.36
density = 2500
[[bonds]]
law = "timoshenko"
young = 50e9
poisson = 0.25
radius_factor = 0.6
[[supports]]
at = { box = { min = [-1, -1, -1], max = [9, 9, 0.2] } }
fix = ["x", "y", "z", "rx"]
[[loads]]
at = { all = true }
gravity = [1, 0, -9.81]
)";

// A solve that never ends.
const std::vector<std::string> forever{"--solver",   "petsc",       "--",        "-ksp_type",
                                       "richardson", "-pc_type",    "none",      "-ksp_richardson_scale",
                                       "0",          "-ksp_max_it", "1000000000"};

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// mpirun refuses root, and more ranks than cores, unless told.
std::vector<std::string> launch(int ranks, const std::vector<std::string>& arguments) {
  return joined({"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "mpirun", "--oversubscribe",
                 "-np", std::to_string(ranks), BONDSTATIC_PROGRAM},
                arguments);
}

// Ranks with arguments of their own.
std::vector<std::string> launch_two(const std::vector<std::string>& first,
                                    const std::vector<std::string>& second) {
  return joined(joined(launch(1, first), {":", "-np", "1", BONDSTATIC_PROGRAM}), second);
}

Ended run(const std::vector<std::string>& command) {
  return Program(command, "/usr/bin/env").end();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Numbers of a table, "" as 0.
std::vector<double> numbers(const std::string& csv) {
  std::vector<double> result;
  std::string field;
  for (const char c : csv.substr(csv.find('\n') + 1)) {
    if (c != ',' && c != '\n') {
      field += c;
      continue;
    }
    result.push_back(std::strtod(field.c_str(), nullptr));
    field.clear();
  }
  return result;
}

// Column by column, relative to the column's largest value.
double largest_difference(const std::string& a, const std::string& b) {
  const std::size_t columns = count(a.substr(0, a.find('\n')), ",") + 1;
  const std::vector<double> x = numbers(a), y = numbers(b);
  if (x.size() != y.size()) return 1;
  std::vector<double> size(columns, 0), apart(columns, 0);
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    size[i % columns] = std::max(size[i % columns], std::abs(x[i]));
    apart[i % columns] = std::max(apart[i % columns], std::abs(x[i] - y[i]));
  }
  for (std::size_t c = 0; c < columns; ++c)
    if (size[c] > 0) largest = std::max(largest, apart[c] / size[c]);
  return largest;
}

// Rows in the order of their ids: ranks write theirs one rank after the other.
std::string by_id(const std::string& csv) {
  std::istringstream lines(csv);
  std::string heading, line;
  std::getline(lines, heading);
  std::map<long, std::string> rows;
  while (std::getline(lines, line)) EXPECT_TRUE(rows.emplace(std::stol(line), line).second) << line;
  for (const auto& [id, row] : rows) heading += "\n" + row;
  return heading + "\n";
}

std::set<std::string> files_of(int ranks) {
  if (ranks == 1) return {"bonds.csv", "case.resolved.toml", "model.vtu", "particles.csv", "summary.json"};
  std::set<std::string> files{"bonds.csv", "case.resolved.toml", "model.pvtu", "particles.csv",
                              "summary.json"};
  for (int r = 0; r < ranks; ++r) files.insert("model_" + std::to_string(r) + ".vtu");
  return files;
}

// MUMPS is refined until the last bit stands, conjugate gradients until the last digit does.
TEST(Ranks, AnyNumberOfThemWritesTheSameAnswerOnce) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", packing);
  ASSERT_EQ(test::run_program({"solve", file, "--out", (scratch / "one").string()}).code, 0);
  for (const char* solver : {"multigrid", "petsc", "petsc-mumps"})
    for (const int ranks : {1, 2, 3, 4}) {
      const fs::path folder = scratch / (solver + std::to_string(ranks));
      const Ended ended = run(launch(ranks, {"solve", file, "--solver", solver, "--out", folder.string()}));
      ASSERT_EQ(ended.code, 0) << ended.err;
      EXPECT_EQ(count(ended.out, "accuracy"), 1u);
      EXPECT_EQ(everything_in(folder), files_of(ranks));
      for (const char* name : {"particles.csv", "bonds.csv"}) {
        const std::string expected = by_id(read_text(scratch / "one" / name)),
                          found = by_id(read_text(folder / name));
        if (solver == std::string("petsc-mumps"))
          EXPECT_EQ(found, expected) << ranks;
        else
          EXPECT_LT(largest_difference(expected, found), 1e-12) << name << " " << solver << " " << ranks;
      }
    }
}

TEST(Ranks, GetTheMultigridWhereTheCaseLeavesItOpen) {
  const ScratchFolder scratch;
  const Ended ended = run(launch(2, {"solve", scratch.write("case.toml", packing)}));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("by multigrid"));
}

TEST(Ranks, MoreOfThemThanParticlesThatMove) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  for (const char* solver : {"petsc", "petsc-mumps"}) {
    const Ended ended = run(launch(
        4,
        {"solve", file, "--solver", solver, "--set", "particles.0.line={from=[0,0,0], to=[4,0,0], count=3}",
         "--set", "particles.0.radius=1", "--set", "loads.0.at={id=3}", "--set", "outputs.0.at={id=3}"}));
    EXPECT_EQ(ended.code, 0) << ended.err;
  }
}

TEST(Ranks, AnErrorOfAllIsSaidOnce) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const std::vector<std::pair<std::vector<std::string>, int>> failures{
      {{"solve", file, "--set", "particles.0.radius=-1"}, 2},
      {{"solve", file, "--set", "supports.0.fix=[\"x\"]"}, 3},
      {{"solve", file, "--solver", "cholmod"}, 2},
      {{"relax", file}, 2},
      {{"solv"}, 2},
      {{"solve", file, "--solver", "petsc", "--", "-pc_type", "gamng"}, 2}};
  for (const auto& [arguments, code] : failures) {
    const Ended ended = run(launch(3, arguments));
    EXPECT_EQ(ended.code, code) << ended.err;
    EXPECT_EQ(count(ended.err, "cure:") + count(ended.err, "see:"), 1u) << ended.err;
    EXPECT_THAT(ended.out, IsEmpty());
  }
}

TEST(Ranks, AnErrorOfOneBeforeItBeginsIsTheErrorOfAll) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever()), folder = (scratch / "out").string();
  const Ended ended = run(launch_two({"solve", file, "--out", folder}, {"solve", file, "--threads", "none"}));
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(count(ended.err, "none"), 1u) << ended.err;
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_FALSE(fs::exists(folder));
}

TEST(Ranks, OnlyTheFirstReadsTheCase) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  EXPECT_EQ(run(launch_two({"solve", file}, {"solve", scratch.path() / "missing.toml"})).code, 0);
  const Ended ended = run(launch_two({"solve", scratch.path() / "missing.toml"}, {"solve", file}));
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(count(ended.err, "missing.toml\" does not exist"), 1u) << ended.err;
}

TEST(Ranks, AnErrorOfOneWhileTheOthersWaitForItEndsThem) {
  const auto begin = Clock::now();
  std::vector<std::string> command = launch(3, {});
  command.back() = BONDSTATIC_FAILING_RANK;
  const Ended ended = run(command);
  EXPECT_EQ(ended.code, 5);
  EXPECT_EQ(count(ended.err, "out of memory in the middle"), 1u) << ended.err;
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(30));
}

// Processes that `parent` started.
std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream stat(entry.path() / "stat");
    std::string line;
    if (!std::getline(stat, line)) continue;
    std::istringstream behind_name(line.substr(line.rfind(')') + 1));
    char state = 0;
    pid_t its_parent = 0;
    behind_name >> state >> its_parent;
    if (its_parent == parent) found.push_back(std::stoi(entry.path().filename().string()));
  }
  return found;
}

TEST(Ranks, WhereOneIsKilledAllAreGoneAndNoFileIsThere) {
  for (const std::size_t victim : {0u, 1u}) {
    const ScratchFolder scratch;
    const std::string file = scratch.write("case.toml", cantilever());
    const fs::path folder = scratch / "out";
    Program program(launch(2, joined({"solve", file, "--out", folder.string()}, forever)), "/usr/bin/env");
    std::vector<pid_t> ranks;
    while (ranks.size() < 2 && program.running()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      ranks = children_of(program.id());
    }
    ASSERT_EQ(ranks.size(), 2u);
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));  // into the solve
    ASSERT_TRUE(program.running());
    const auto begin = Clock::now();
    kill(ranks[victim], SIGKILL);
    const Ended ended = program.end();
    const auto gone = [](pid_t rank) { return kill(rank, 0) != 0; };
    while (!(gone(ranks[0]) && gone(ranks[1])) && Clock::now() - begin < std::chrono::seconds(30))
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_TRUE(gone(ranks[0]) && gone(ranks[1]));
    EXPECT_NE(ended.code, 0);
    EXPECT_THAT(ended.out, Not(HasSubstr("accuracy")));
    EXPECT_FALSE(fs::exists(folder));
  }
}

}  // namespace
}  // namespace bondstatic
