#include "io/module_file.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "bondstatic/error.hpp"
#include "bondstatic/version.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

// Of the program, or of the shared library where this code is in one.
fs::path folder_of_this_code() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&module_path), &info) == 0 || !info.dli_fname) return {};
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

[[noreturn]] void fail(const std::string& what, const std::string& cure) {
  throw Error(ExitCode::invalid_input, fmt::format("{}\n    cure: {}", what, cure));
}

}  // namespace

std::string module_path(const ModuleFile& module) {
  std::error_code none;
  for (const fs::path& place : places()) {
    const fs::path file = place / module.file;
    if (fs::is_regular_file(file, none)) return file.lexically_normal().string();
  }
  return "";
}

const void* load_module(const ModuleFile& module) {
  const std::string cure = fmt::format(
      "install Debian's {} and build bondstatic with -D{}=ON, or name the folder of {} in the environment "
      "variable BONDSTATIC_MODULES",
      module.package, module.option, module.file);
  const std::string path = module_path(module);
  if (path.empty()) fail(fmt::format("the {} module ({}) is not there", module.name, module.file), cure);
  void* handle = dlopen(path.c_str(), RTLD_NOW | (module.to_all ? RTLD_GLOBAL : RTLD_LOCAL));
  if (!handle) fail(fmt::format("the {} module does not load: {}", module.name, dlerror()), cure);
  const auto entry = reinterpret_cast<const ModuleHead* (*)()>(dlsym(handle, module.entry));
  const ModuleHead* head = entry ? entry() : nullptr;
  if (!head || head->abi != module.abi || head->version != version())
    fail(fmt::format("{} belongs to another bondstatic{}, this is {}", path,
                     head ? fmt::format(" ({})", head->version) : "", version()),
         "build both together");
  return head;
}

}  // namespace bondstatic
