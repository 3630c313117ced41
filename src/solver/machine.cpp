#include "solver/machine.hpp"

#include <dlfcn.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <omp.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <thread>

namespace bondstatic {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

// "max" or anything that is no number means: no limit.
double number_in(const std::string& path) {
  std::ifstream file(path);
  double value = 0;
  return file >> value ? value : unlimited;
}

// Number behind a name at the beginning of a line, as in /proc/stat.
double field_of(const std::string& path, const std::string& name) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (line.rfind(name, 0) == 0) return std::strtod(line.c_str() + name.size(), nullptr);
  return unlimited;
}

// Threads of this process that run now: OpenBLAS's workers spin for a while after the program has started.
int own_running_threads() {
  int running = 0;
  std::error_code none;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", none)) {
    std::ifstream file(task.path() / "stat");
    std::string line;
    std::getline(file, line);
    const std::size_t name_end = line.rfind(") ");  // the name may hold anything
    running += name_end != std::string::npos && line[name_end + 2] == 'R';
  }
  return std::max(1, running);
}

// Bytes in a "Name:   123 kB" line, as in /proc/meminfo.
double kilobyte_field(const std::string& path, const std::string& name) {
  return 1024 * field_of(path, name + ":");
}

// Folders of this process's control group and of the groups above it: a limit holds for all below.
template <class Visit>
void for_each_control_group(const std::string& controller, const std::string& mount, Visit visit) {
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string number, names, path;
    std::getline(fields, number, ':');
    std::getline(fields, names, ':');
    std::getline(fields, path);
    if (("," + names + ",").find("," + controller + ",") == std::string::npos) continue;
    for (;; path = path.substr(0, path.find_last_of('/'))) {
      visit(mount + path);
      if (path.empty() || path == "/") break;
    }
  }
}

double control_group_memory() {
  double left = unlimited;
  for_each_control_group("", "/sys/fs/cgroup", [&left](const std::string& folder) {  // version 2
    const double limit = number_in(folder + "/memory.max");
    if (limit < unlimited) left = std::min(left, limit - number_in(folder + "/memory.current"));
  });
  for_each_control_group("memory", "/sys/fs/cgroup/memory", [&left](const std::string& folder) {  // version 1
    const double limit = number_in(folder + "/memory.limit_in_bytes");
    if (limit < 0x1p62) left = std::min(left, limit - number_in(folder + "/memory.usage_in_bytes"));
  });
  return left;
}

double control_group_cores() {
  double cores = unlimited;
  for_each_control_group("", "/sys/fs/cgroup", [&cores](const std::string& folder) {
    std::ifstream file(folder + "/cpu.max");
    double quota = 0, period = 0;
    if (file >> quota >> period && period > 0) cores = std::min(cores, quota / period);
  });
  return cores;
}

using SetThreads = void (*)(int);
using GetThreads = int (*)();

template <class Function>
Function blas_function(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

int cores_at_hand() {
  cpu_set_t set;
  int cores = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : omp_get_num_procs();
  const double quota = control_group_cores();
  if (quota < cores) cores = int(std::ceil(quota));
  return std::max(1, cores);
}

int threads_worth_having(int most) {
  constexpr int samples = 3;  // a process that only woke up for a moment is no competitor
  int idle = 0;
  for (int i = 0; i < samples && idle < most; ++i) {
    if (i > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const int own = own_running_threads();
    const double running = field_of("/proc/stat", "procs_running");
    if (!(running < unlimited)) return most;
    idle = std::max(idle, int(sysconf(_SC_NPROCESSORS_ONLN)) - std::max(0, int(running) - own));
  }
  return std::clamp(idle, 1, most);
}

// Address space that BLAS and the heaps of its threads take when they are first called. OpenBLAS tries for
// ever where it gets none.
constexpr double reserved_by_blas = 256e6;

double available_memory() {
  double left = std::min(kilobyte_field("/proc/meminfo", "MemAvailable"), control_group_memory());
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    left = std::min(
        left, double(limit.rlim_cur) - kilobyte_field("/proc/self/status", "VmSize") - reserved_by_blas);
  return std::max(0.0, left);
}

double peak_resident_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * double(usage.ru_maxrss);
}

void give_back_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

SolverThreads::SolverThreads(int threads) : omp_levels_(omp_get_max_active_levels()), blas_threads_(0) {
  omp_set_max_active_levels(0);
  const auto get = blas_function<GetThreads>("openblas_get_num_threads");
  const auto set = blas_function<SetThreads>("openblas_set_num_threads");
  if (!get || !set) return;
  blas_threads_ = get();
  set(threads);
}

SolverThreads::~SolverThreads() {
  omp_set_max_active_levels(omp_levels_);
  if (blas_threads_ > 0) blas_function<SetThreads>("openblas_set_num_threads")(blas_threads_);
}

}  // namespace bondstatic
