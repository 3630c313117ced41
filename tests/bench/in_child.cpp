#include "bench/in_child.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace bondstatic::bench {

ChildEnd in_child(double seconds, const std::function<void(void*)>& work, void* buffer, int size) {
  void* shared = mmap(nullptr, std::size_t(size), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  int end[2];  // closed by the child's end, however it comes
  if (shared == MAP_FAILED || pipe(end) != 0) throw std::runtime_error("no pipe to a child");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    close(end[0]);
    work(shared);
    _exit(0);
  }
  close(end[1]);
  pollfd ended{end[0], POLLIN, 0};
  const bool in_time = poll(&ended, 1, int(1e3 * seconds)) > 0;
  if (!in_time) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  close(end[0]);
  std::memcpy(buffer, shared, std::size_t(size));
  munmap(shared, std::size_t(size));
  if (!in_time) return ChildEnd::out_of_time;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? ChildEnd::done : ChildEnd::died;
}

}  // namespace bondstatic::bench
