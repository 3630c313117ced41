// The command line: what can be asked for, and what is said where it cannot be understood.
#pragma once

#include "bondstatic/error.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

/// Throws Error (invalid_input) for a usage error, with the nearest name where one is near, and what the
/// commands throw. `ranks`: the processes that were launched together, null for one.
ExitCode run_command_line(int argc, char** argv, Ranks* ranks = nullptr);

}  // namespace bondstatic
