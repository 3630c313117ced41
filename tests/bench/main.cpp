#include <cstdio>
#include <cstring>

#include "bench/solvers.hpp"
#include "bench/tables.hpp"

namespace {

int usage(const char* found) {
  std::fprintf(stderr,
               "found %s, allowed are\n"
               "    run                                  the tables that the README quotes\n"
               "    run solvers [--million] [--quick]    all solvers on growing packings\n"
               "        [--packing NAME]... [--solver NAME]...   only these\n",
               found);
  return 2;
}

}  // namespace

int main(int count, char** arguments) {
  using namespace bondstatic::bench;
  if (count > 1) {
    if (std::strcmp(arguments[1], "solvers") != 0) return usage(arguments[1]);
    Campaign campaign;
    campaign.plot = BONDSTATIC_BINARY_DIR "/solvers.svg";
    for (int i = 2; i < count; ++i) {
      if (std::strcmp(arguments[i], "--million") == 0)
        campaign.million = true;
      else if (std::strcmp(arguments[i], "--quick") == 0)
        campaign.quick = true;
      else if (std::strcmp(arguments[i], "--packing") == 0 && i + 1 < count)
        campaign.packings.emplace_back(arguments[++i]);
      else if (std::strcmp(arguments[i], "--solver") == 0 && i + 1 < count)
        campaign.solvers.emplace_back(arguments[++i]);
      else
        return usage(arguments[i]);
    }
    compare_solvers(campaign);
    return 0;
  }
  std::puts("| what | figure |\n|---|---|");
  print_statics();
  print_dynamics();
  return 0;
}
