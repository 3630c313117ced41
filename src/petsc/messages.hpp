// Messages of any size from one rank to another: MPI counts in int, so long ones go in pieces. Pieces between
// two ranks arrive in the order in which they left.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <vector>

namespace bondstatic {

/// Bytes of a piece.
inline constexpr std::size_t longest_message = std::size_t(1) << 30;

class Messages {
 public:
  explicit Messages(MPI_Comm among, std::size_t longest = longest_message)
      : among_(among), longest_(longest) {}

  /// Under way when this returns: the bytes must stay until wait(). Nothing is sent of zero bytes.
  void send(const void* data, std::size_t bytes, int to);
  /// As many bytes as the other side sends.
  void receive(void* data, std::size_t bytes, int from);
  /// Until all have arrived.
  void wait();

 private:
  MPI_Comm among_;
  std::size_t longest_;
  std::vector<MPI_Request> under_way_;
};

}  // namespace bondstatic
