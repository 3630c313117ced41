// Going through many bonds by several threads, and what is found wrong with them.
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/error.hpp"

namespace bondstatic {

/// What is wrong with some of the bonds. They tend to fail together: the first ones are said, the others
/// counted.
struct Findings {
  std::vector<Fault> faults;
  std::size_t unsaid = 0;
  std::exception_ptr failure;  ///< what a law threw: it must not leave its thread

  /// `text`: finding and cure, "; " between them.
  void add(const Model& model, const Bond& bond, const std::string& text);
};

/// Calls `visit` for pieces [begin, end) that make up [0, count), several at once. Throws InputError with
/// what was found by the pieces, in their order, after `faults`; else what the first of them threw.
void visit_pieces(Index count, int threads, std::vector<Fault> faults,
                  const std::function<void(Index begin, Index end, Findings& findings)>& visit);

}  // namespace bondstatic
