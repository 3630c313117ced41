#include "bench/program.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
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
  std::vector<std::string> command;
  if (where.ranks > 0) command = {"mpirun", "--oversubscribe", "-np", std::to_string(where.ranks)};
  command.push_back(BONDSTATIC_PROGRAM);
  command.insert(command.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : command) argv.push_back(word.data());
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
      // Else mpirun refuses root, as which containers run.
      setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
      setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
      execvp(argv.front(), argv.data());
      _exit(127);
    }
    wait4(child, &status, 0, &usage);
  });
  if (status != 0) {
    std::string words;
    for (const std::string& word : command) words += " " + word;
    throw std::runtime_error("this failed:" + words);
  }
  run.cpu_seconds = in_seconds(usage.ru_utime) + in_seconds(usage.ru_stime);
  run.peak_bytes = 1024.0 * double(usage.ru_maxrss);
  return run;
}

}  // namespace bondstatic::bench
