#include "bench/program.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>

#include "bench/timing.hpp"

namespace bondstatic::bench {

namespace {

// Binds this process to the first so many of the cores that it may use.
bool bind_to(int cores) {
  cpu_set_t all, few;
  if (sched_getaffinity(0, sizeof all, &all) != 0) return false;
  CPU_ZERO(&few);
  for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&few) < cores; ++core)
    if (CPU_ISSET(core, &all)) CPU_SET(core, &few);
  return sched_setaffinity(0, sizeof few, &few) == 0;
}

double in_seconds(const timeval& time) {
  return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
}

}  // namespace

ProgramRun run_program(const std::vector<std::string>& arguments, const Where& where) {
  std::vector<char*> argv{const_cast<char*>("bondstatic")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  std::fflush(stdout);  // else the child writes it, too
  ProgramRun run;
  int status = 0;
  rusage usage{};
  run.seconds = seconds_of([&] {
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) {
      if (!freopen(where.output.c_str(), "w", stdout)) _exit(126);
      if (where.cores > 0 && !bind_to(where.cores)) _exit(126);
      execv(BONDSTATIC_PROGRAM, argv.data());
      _exit(127);
    }
    wait4(child, &status, 0, &usage);
  });
  if (status != 0) {
    std::string command;
    for (const std::string& argument : arguments) command += " " + argument;
    throw std::runtime_error("the program failed on" + command);
  }
  run.cpu_seconds = in_seconds(usage.ru_utime) + in_seconds(usage.ru_stime);
  run.peak_bytes = 1024.0 * double(usage.ru_maxrss);
  return run;
}

}  // namespace bondstatic::bench
