// What the machine gives: cores, memory, BLAS threads.
#pragma once

namespace bondstatic {

/// Cores this process may use (affinity and control group), at least 1.
int cores_at_hand();

/// At most `most` threads, but no more than there are idle processors at this moment, and at least 1. BLAS
/// joins its threads thousands of times in a factorisation, and where one of them has to wait for a
/// processor, all do: beside four busy processes on four cores, four threads took ten times as long as
/// one.
int threads_worth_having(int most);

/// Bytes that can still be taken: the least of the machine's available memory, what the control group leaves,
/// and the address space limit.
double available_memory();

/// Largest resident size of this process so far, bytes.
double peak_resident_memory();

/// Gives the system what has been freed in pieces, too, and stays with the process otherwise: what is asked
/// for next need not fit into the gaps. 10 ms for a gigabyte.
void give_back_freed_memory();

/// Keeps the thread trap of SuiteSparse shut while it lives: CHOLMOD 5.12 opens OpenMP regions of four
/// threads whatever one asks for, which on a busy machine makes it up to a hundred times slower; active level
/// 0 turns each into one thread. OpenBLAS keeps threads of its own, set to `threads`. Both are put back on
/// destruction.
class SolverThreads {
 public:
  explicit SolverThreads(int threads);
  ~SolverThreads();
  SolverThreads(const SolverThreads&) = delete;
  SolverThreads& operator=(const SolverThreads&) = delete;

 private:
  int omp_levels_;
  int blas_threads_;
};

}  // namespace bondstatic
