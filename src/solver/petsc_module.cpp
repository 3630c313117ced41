#include "solver/petsc_module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "bondstatic/error.hpp"
#include "bondstatic/version.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

constexpr const char* cure =
    "install Debian's petsc-dev and build bondstatic with -DBONDSTATIC_PETSC=ON, or name the folder of "
    "libbondstatic_petsc.so in the environment variable BONDSTATIC_MODULES";

// Of the program, or of the shared library where this code is in one.
fs::path folder_of_this_code() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&petsc_module_path), &info) == 0 || !info.dli_fname) return {};
  std::error_code none;
  const bool program =
      !std::strchr(info.dli_fname, '/') || fs::equivalent(info.dli_fname, "/proc/self/exe", none);
  const fs::path file = fs::canonical(program ? "/proc/self/exe" : info.dli_fname, none);
  return file.parent_path();
}

std::vector<fs::path> places() {
  if (const char* folder = std::getenv("BONDSTATIC_MODULES")) return {folder};
  std::vector<fs::path> list;
  const fs::path here = folder_of_this_code();
  if (!here.empty())
    for (const char* below : {".", BONDSTATIC_BIN_TO_LIB "/bondstatic", "bondstatic", "..", "../.."})
      list.push_back(here / below);
  list.emplace_back(BONDSTATIC_LIB_FOLDER "/bondstatic");
  return list;
}

const PetscModule& load() {
  const std::string path = petsc_module_path();
  if (path.empty())
    throw Error(ExitCode::invalid_input,
                fmt::format("the PETSc module ({}) is not there\n    cure: {}", petsc_module_file, cure));
  // Open MPI's own plug-ins look for its symbols among the global ones.
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!handle)
    throw Error(ExitCode::invalid_input,
                fmt::format("the PETSc module does not load: {}\n    cure: {}", dlerror(), cure));
  const auto entry = reinterpret_cast<const PetscModule* (*)()>(dlsym(handle, petsc_module_entry));
  const PetscModule* module = entry ? entry() : nullptr;
  if (!module || module->abi != petsc_module_abi || module->version != version())
    throw Error(ExitCode::invalid_input,
                fmt::format("{} belongs to another bondstatic{}, this is {}\n    cure: build both together",
                            path, module ? fmt::format(" ({})", module->version) : "", version()));
  return *module;
}

}  // namespace

std::string petsc_module_path() {
  std::error_code none;
  for (const fs::path& place : places()) {
    const fs::path file = place / petsc_module_file;
    if (fs::is_regular_file(file, none)) return file.lexically_normal().string();
  }
  return "";
}

const PetscModule& petsc_module() {
  static const PetscModule& module = load();
  return module;
}

}  // namespace bondstatic
