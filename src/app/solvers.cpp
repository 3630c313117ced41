#include <dlfcn.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/terminal.hpp"
#include "bondstatic/linear_solver.hpp"
#include "bondstatic/version.hpp"

namespace bondstatic {

namespace {

/// Asked of the running process: libblas.so.3 is chosen by the system, not by the build.
std::string blas_in_use() {
  const auto has = [](const char* symbol) { return dlsym(RTLD_DEFAULT, symbol) != nullptr; };
  if (void* config = dlsym(RTLD_DEFAULT, "openblas_get_config"))
    return reinterpret_cast<char* (*)()>(config)();
  if (has("mkl_get_version_string")) return "Intel MKL";
  if (has("bli_info_get_version_str")) return "BLIS";
  if (has("ATL_buildinfo")) return "ATLAS";
  if (has("dgemm_")) return "reference BLAS (slow: install libopenblas0-pthread)";
  return "none";
}

}  // namespace

ExitCode solvers(bool json) {
  const std::vector<SolverInfo> available = available_solvers();
  if (json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SolverInfo& solver : available)
      list.push_back({{"name", solver.name}, {"description", solver.description}});
    fmt::print("{}\n", list.dump(2));
    return ExitCode::done;
  }
  TextTable table;
  for (const SolverInfo& solver : available) table.rows.push_back({solver.name, solver.description});
  fmt::print("{}", to_text(table, 0));
  return ExitCode::done;
}

std::string version_text() {
  std::string names;
  for (const SolverInfo& solver : available_solvers()) names += (names.empty() ? "" : ", ") + solver.name;
  return fmt::format("bondstatic {}\nsolvers: {}\nBLAS: {}", version(), names, blas_in_use());
}

}  // namespace bondstatic
