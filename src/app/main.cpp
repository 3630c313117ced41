#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "app/command_line.hpp"
#include "app/interrupt.hpp"
#include "app/terminal.hpp"
#include "bondstatic/error.hpp"

namespace {

using bondstatic::Error;
using bondstatic::ExitCode;

ExitCode fail(ExitCode code, const std::string& message) {
  std::fflush(stdout);
  fmt::print(stderr, "{} {}\n", bondstatic::red("bondstatic:", stderr), message);
  return code;
}

ExitCode guarded(int argc, char** argv) {
  try {
    return bondstatic::run_command_line(argc, argv);
  } catch (const bondstatic::InputError& error) {
    // Each fault begins with its place, as editors expect it.
    fmt::print(stderr, "{}\n", error.what());
    return error.code();
  } catch (const Error& error) {
    return fail(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::out_of_memory, "out of memory");
  } catch (const std::exception& error) {
    return fail(ExitCode::internal, fmt::format("internal error: {}", error.what()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  bondstatic::handle_interrupts();
  ExitCode code = guarded(argc, argv);
  // An answer that did not arrive is no answer.
  if (std::fflush(stdout) != 0 && code == ExitCode::done)
    code = fail(ExitCode::internal, "cannot write to standard output");
  return int(code);
}
