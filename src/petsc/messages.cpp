#include "petsc/messages.hpp"

#include <algorithm>

#include "petsc/mpi_lifetime.hpp"

namespace bondstatic {

namespace {

constexpr int tag = 1;

}  // namespace

void Messages::send(const void* data, std::size_t bytes, int to) {
  const char* begin = static_cast<const char*>(data);
  for (std::size_t at = 0; at < bytes; at += longest_)
    check_mpi(MPI_Isend(begin + at, int(std::min(longest_, bytes - at)), MPI_BYTE, to, tag, among_,
                        &under_way_.emplace_back(MPI_REQUEST_NULL)));
}

void Messages::receive(void* data, std::size_t bytes, int from) {
  char* begin = static_cast<char*>(data);
  for (std::size_t at = 0; at < bytes; at += longest_)
    check_mpi(MPI_Irecv(begin + at, int(std::min(longest_, bytes - at)), MPI_BYTE, from, tag, among_,
                        &under_way_.emplace_back(MPI_REQUEST_NULL)));
}

void Messages::wait() {
  check_mpi(MPI_Waitall(int(under_way_.size()), under_way_.data(), MPI_STATUSES_IGNORE));
  under_way_.clear();
}

}  // namespace bondstatic
