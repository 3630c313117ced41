#pragma once

#include <memory>

#include "bondstatic/linear_solver.hpp"

namespace bondstatic {

std::unique_ptr<LinearSolver> make_cholmod(int threads);
std::unique_ptr<LinearSolver> make_multigrid(int threads);
std::unique_ptr<LinearSolver> make_eigen(int threads);

}  // namespace bondstatic
