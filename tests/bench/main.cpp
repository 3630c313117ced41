#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/exchange.hpp"
#include "bench/fracture.hpp"
#include "bench/million.hpp"
#include "bench/packings.hpp"
#include "bench/ranks.hpp"
#include "bench/residual.hpp"
#include "bench/solvers.hpp"
#include "bench/tables.hpp"

namespace {

using namespace bondstatic;
using namespace bondstatic::bench;

constexpr const char* usage =
    "    run                                  the tables that the README quotes\n"
    "    run solvers [--million] [--quick]    all solvers on growing packings\n"
    "        [--packing NAME]... [--solver NAME]...   only these\n"
    "    run residual [--packing NAME]... [--particles N]\n"
    "                                         multigrid and PETSc's GAMG to the same true residual\n"
    "    run million [--particles N] [--keep] the program on a million particles, from case file to results\n"
    "    run exchange [--particles N]...      import of LAMMPS data files, bonds by contact radius, of "
    "growing size\n"
    "    run fracture [--packing NAME]... [--particles 2000|8000|27000]...\n"
    "                                         a break against a full refactorisation, and three ways to go "
    "on "
    "after it\n"
    "    run ranks [--particles N] [--ranks N]... [--solver NAME]...\n"
    "                                         the program on MPI ranks against itself in one process\n"
    "    run busy                             of the first tables, solves beside busy processes\n";

// What is left of the command line.
class Arguments {
 public:
  Arguments(int count, char** values) : left_(values + 1, values + count) {}

  bool empty() const { return left_.empty(); }

  bool take(const std::string& name) {
    if (empty() || left_.front() != name) return false;
    left_.erase(left_.begin());
    return true;
  }

  /// `name` and the value behind it.
  bool take(const std::string& name, std::string& value) {
    if (left_.size() < 2 || !take(name)) return false;
    value = left_.front();
    left_.erase(left_.begin());
    return true;
  }

  bool take(const std::string& name, Index& number) {
    std::string text;
    if (!take(name, text)) return false;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || number < 1)
      throw std::invalid_argument(name + " " + text);
    return true;
  }

  [[noreturn]] void refuse() const { throw std::invalid_argument(left_.front()); }

 private:
  std::vector<std::string> left_;
};

// A name that there is not would print an empty table.
void add_packing(const std::string& name, std::vector<std::string>& packings) {
  const auto& all = families();
  if (std::none_of(all.begin(), all.end(), [&](const Family& family) { return family.name == name; }))
    throw std::invalid_argument(name);
  packings.push_back(name);
}

void run_solvers(Arguments& arguments) {
  Campaign campaign;
  campaign.plot = BONDSTATIC_BINARY_DIR "/solvers.svg";
  for (std::string name; !arguments.empty();) {
    if (arguments.take("--million"))
      campaign.million = true;
    else if (arguments.take("--quick"))
      campaign.quick = true;
    else if (arguments.take("--packing", name))
      add_packing(name, campaign.packings);
    else if (arguments.take("--solver", name))
      campaign.solvers.push_back(name);
    else
      arguments.refuse();
  }
  compare_solvers(campaign);
}

void run_residual(Arguments& arguments) {
  Race race;
  for (std::string name; !arguments.empty();) {
    if (arguments.take("--packing", name))
      add_packing(name, race.packings);
    else if (!arguments.take("--particles", race.particles))
      arguments.refuse();
  }
  race_to_residual(race);
}

void run_million(Arguments& arguments) {
  Million asked;
  while (!arguments.empty()) {
    if (arguments.take("--keep"))
      asked.keep = true;
    else if (!arguments.take("--particles", asked.particles))
      arguments.refuse();
  }
  print_million(asked);
}

void run_exchange(Arguments& arguments) {
  std::vector<Index> sizes;
  for (Index number = 0; !arguments.empty();) {
    if (!arguments.take("--particles", number)) arguments.refuse();
    sizes.push_back(number);
  }
  if (sizes.empty()) sizes = {125'000, 250'000, 500'000, 1'000'000};
  print_exchange(sizes);
}

void run_fracture(Arguments& arguments) {
  BreakCost asked;
  Index number = 0;
  for (std::string name; !arguments.empty();) {
    if (arguments.take("--packing", name))
      add_packing(name, asked.packings);
    else if (arguments.take("--particles", number))
      asked.particles.push_back(number);
    else
      arguments.refuse();
  }
  print_break_cost(asked);
}

void run_ranks(Arguments& arguments) {
  OnRanks asked;
  Index number = 0;
  for (std::string name; !arguments.empty();) {
    if (arguments.take("--ranks", number))
      asked.ranks.push_back(int(number));
    else if (arguments.take("--solver", name))
      asked.solvers.push_back(name);
    else if (!arguments.take("--particles", asked.particles))
      arguments.refuse();
  }
  compare_ranks(asked);
}

void run(Arguments& arguments) {
  if (arguments.take("solvers")) return run_solvers(arguments);
  if (arguments.take("residual")) return run_residual(arguments);
  if (arguments.take("million")) return run_million(arguments);
  if (arguments.take("exchange")) return run_exchange(arguments);
  if (arguments.take("fracture")) return run_fracture(arguments);
  if (arguments.take("ranks")) return run_ranks(arguments);
  const bool busy_only = arguments.take("busy");
  if (!arguments.empty()) arguments.refuse();
  std::puts("| what | figure |\n|---|---|");
  if (busy_only) return print_crowded();
  print_statics();
  print_crowded();
  print_dynamics();
}

}  // namespace

int main(int count, char** values) {
  Arguments arguments(count, values);
  try {
    run(arguments);
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "found %s, allowed are\n%s", error.what(), usage);
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
