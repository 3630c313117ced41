// --report: the results of a command as a page beside them.
#pragma once

#include <functional>

#include "app/commands.hpp"

namespace bondstatic {

/// Runs the command and, where the arguments ask for it, writes report.html into the folder of its results.
/// That of earlier results goes, as it would show what is no longer there. Throws Error (invalid_input)
/// before the command where there could be none.
ExitCode with_report(const SolveArguments& arguments, const std::function<ExitCode()>& command);

}  // namespace bondstatic
