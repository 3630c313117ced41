// Thread counts that the tables go through.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/statics.hpp"

namespace bondstatic::bench {

int machine_cores();

/// 1, 2, 4 ... up to the cores of the machine.
std::vector<int> thread_counts();

/// "1 thread", "2 threads".
std::string plural(int threads);

StaticOptions on_threads(const std::string& solver, int threads);

}  // namespace bondstatic::bench
