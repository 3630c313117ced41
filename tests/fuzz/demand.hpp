// Ends the process, which libFuzzer then reports with the input.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace bondstatic {

inline void demand(bool sound, const char* what) {
  if (sound) return;
  std::fprintf(stderr, "not sound: %s\n", what);
  std::abort();
}

}  // namespace bondstatic
