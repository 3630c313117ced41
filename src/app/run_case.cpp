#include "app/run_case.hpp"

#include <algorithm>

#include "solver/machine.hpp"

namespace bondstatic {

Case read_case(const SolveArguments& arguments, const std::vector<std::string>& overrides, Purpose purpose) {
  const int threads = arguments.threads > 0 ? arguments.threads : cores_at_hand();
  Case given = read_case(arguments.file, overrides, arguments.folder, purpose, threads);
  if (!arguments.solver.empty()) given.solve.solver = arguments.solver;
  given.solve.backend_options = arguments.backend_options;
  if (arguments.threads > 0) given.solve.threads = arguments.threads;
  return given;
}

Answer answer(const Case& given, const std::function<void(const std::string&)>& progress) {
  StaticOptions options = given.solve;
  options.progress = progress;
  Answer result{solve_statics(given.model, options), {}};
  result.outputs = evaluate_outputs(given.model, result.solution, given.outputs);
  return result;
}

}  // namespace bondstatic
