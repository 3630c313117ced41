#include <cstdio>

#include "bench/tables.hpp"

int main() {
  std::puts("| what | figure |\n|---|---|");
  bondstatic::bench::print_statics();
  bondstatic::bench::print_dynamics();
  return 0;
}
