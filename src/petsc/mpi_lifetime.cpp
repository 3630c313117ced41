#include "petsc/mpi_lifetime.hpp"

#include <cstdlib>
#include <string>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

class Mpi {
 public:
  Mpi() {
    int running = 0;
    MPI_Initialized(&running);
    if (running) return;
    // A busy machine is shared fairly, and an MPI on one core gets on at all. A user's own setting stands.
    setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
    int given = 0;
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given) != MPI_SUCCESS)
      throw Error(ExitCode::internal, "MPI does not start");
    started_ = true;
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  }

  ~Mpi() {
    int ended = 0;
    MPI_Finalized(&ended);
    if (started_ && !ended) MPI_Finalize();
  }

 private:
  bool started_ = false;
};

}  // namespace

void start_mpi() {
  static const Mpi mpi;
}

void check_mpi(int code) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING] = "";
  int length = 0;
  MPI_Error_string(code, text, &length);
  throw Error(ExitCode::internal, "MPI failed: " + std::string(text, std::size_t(length)));
}

}  // namespace bondstatic
