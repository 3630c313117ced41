// Errors are part of the interface: each says what was found, what is allowed and how to cure it, and carries
// the exit code that the command line ends with.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace bondstatic {

enum class ExitCode {
  done = 0,
  internal = 1,
  invalid_input = 2,
  mechanism = 3,
  not_accurate = 4,
  out_of_memory = 5,
  interrupted = 130,
  terminated = 143,
};

class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// Where in the input: line and column count from 1; 0 means that there is none (a command-line override).
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// One thing that is wrong with the input.
struct Fault {
  Place place;
  std::string message;  ///< what was found and what is allowed: "young = -5 Pa must be positive"
  std::string cure;     ///< what to do about it: "give Young's modulus of the bond material, e.g. 50e9"
};

/// "packing.csv:12:7: radius = -1 must be positive\n    cure: ..."
std::string to_string(const Fault& fault);

/// Everything that is wrong with the input, reported at once.
class InputError : public Error {
 public:
  explicit InputError(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// The answer did not reach the asked accuracy, or the matrix is numerically singular.
class AccuracyError : public Error {
 public:
  explicit AccuracyError(const std::string& message) : Error(ExitCode::not_accurate, message) {}
};

/// The solve would not fit in memory; thrown before anything large is allocated.
class MemoryError : public Error {
 public:
  explicit MemoryError(const std::string& message) : Error(ExitCode::out_of_memory, message) {}
};

}  // namespace bondstatic
