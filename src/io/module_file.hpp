// Parts of bondstatic that bring many libraries with them are modules of their own, loaded when they are
// asked for. Each has one C function, its entry, that returns a pointer to a struct beginning with
//
//     int abi;               counted up with every change to what crosses
//     const char* version;   of the bondstatic that the module was built with
//
// A module carries its own copies of the few functions of this library that it needs and resolves nothing
// from the program, so it serves programs linked to the static library, to the shared one, and with or
// without exported symbols. Data crosses as types of headers both were built from, which `abi` and `version`
// stand for. Exceptions cross, as g++'s runtime, which both share, compares types by their names.
#pragma once

#include <string>

namespace bondstatic {

struct ModuleHead {
  int abi;
  const char* version;
};

struct ModuleFile {
  const char* name;   ///< what errors call it: "PETSc"
  const char* file;   ///< "libbondstatic_petsc.so"
  const char* entry;  ///< name of its C function
  int abi;
  const char* package;  ///< Debian's, to build it with: "petsc-dev"
  const char* option;   ///< CMake's: "BONDSTATIC_PETSC"
  bool to_all = false;  ///< its symbols are for libraries that it loads in turn
};

/// Where the module lies; "" where it is nowhere. Looked for in the folder that BONDSTATIC_MODULES names;
/// beside the program or library that this code is part of and the two folders above it (a build folder); in
/// its lib folder; where this was installed to. Loads nothing.
std::string module_path(const ModuleFile& module);

/// What the entry returns. Throws Error (invalid_input) that says how to come by the module where there is
/// none, or one of another version. It stays loaded.
const void* load_module(const ModuleFile& module);

}  // namespace bondstatic
