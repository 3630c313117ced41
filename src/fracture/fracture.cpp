#include "bondstatic/fracture.hpp"

#include "fracture/fracture_run.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

std::string text_of(FractureEnd end) {
  switch (end) {
    case FractureEnd::breaks:
      return "asked number of breaks reached";
    case FractureEnd::factor:
      return "asked factor reached";
    case FractureEnd::displacement:
      return "asked displacement reached";
    case FractureEnd::load_drop:
      return "asked drop of the load reached";
    case FractureEnd::separated:
      return "specimen separated";
    case FractureEnd::unbreakable:
      return "nothing more can break";
    case FractureEnd::mechanism:
      return "what is left is a mechanism";
    case FractureEnd::interrupted:
      return "interrupted";
  }
  return "";
}

Fracture fracture(const Model& model, const FractureOptions& options, const StaticOptions& solve,
                  const FractureHooks& hooks) {
  const int asked = solve.threads > 0 ? solve.threads : cores_at_hand();
  const int threads = solve.yield_cores ? threads_worth_having(asked) : asked;
  return FractureRun(model, options, solve, hooks, threads).run();
}

}  // namespace bondstatic
