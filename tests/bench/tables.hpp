// Rows of the benchmarks' Markdown table. Ratios are formed within one run.
#pragma once

namespace bondstatic::bench {

void print_statics();
void print_crowded();
void print_dynamics();

}  // namespace bondstatic::bench
