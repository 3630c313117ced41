// What this machine gives at this moment: the measures that solvers are held against.
#pragma once

namespace bondstatic::bench {

/// Operations a second of the BLAS that CHOLMOD uses, dgemm of order 2000, best of a few; zero where there is
/// none.
double dgemm_rate(int threads);

/// Bytes a second of a[i] = b[i] + s c[i] over arrays far larger than the caches, best of a few.
double triad_rate(int threads);

/// The same of so many processes at once, each with arrays of its own: what all of them move in the same
/// second.
double triad_rate_of_processes(int processes);

}  // namespace bondstatic::bench
