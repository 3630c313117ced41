#include "bond/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace bondstatic {
namespace {

constexpr std::size_t most_faults = 20;

}  // namespace

void Findings::add(const Model& model, const Bond& bond, const std::string& text) {
  if (faults.size() >= most_faults) {
    ++unsaid;
    return;
  }
  const std::size_t split = text.find("; ");
  const Index a = model.particles[std::size_t(bond.a)].id, b = model.particles[std::size_t(bond.b)].id;
  faults.push_back({{},
                    fmt::format("bond {} between particles {} and {} (law {}): {}", bond.id, a, b,
                                model.blocks[std::size_t(bond.block)].law, text.substr(0, split)),
                    split == std::string::npos ? "see `bondstatic laws`" : text.substr(split + 2)});
}

void visit_pieces(Index count, int threads, std::vector<Fault> faults,
                  const std::function<void(Index begin, Index end, Findings& findings)>& visit) {
  constexpr Index piece = 1 << 14;
  const Index pieces = (count + piece - 1) / piece;
  std::vector<Findings> findings(static_cast<std::size_t>(pieces));
  threads = int(std::clamp<Index>(pieces, 1, std::max(1, threads)));
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
  for (Index i = 0; i < pieces; ++i) {
    Findings& found = findings[std::size_t(i)];
    try {
      visit(i * piece, std::min(count, (i + 1) * piece), found);
    } catch (...) {
      found.failure = std::current_exception();
    }
  }

  std::size_t unsaid = 0;
  for (Findings& found : findings) {
    unsaid += found.unsaid;
    for (Fault& fault : found.faults)
      if (faults.size() < most_faults)
        faults.push_back(std::move(fault));
      else
        ++unsaid;
    if (found.failure) std::rethrow_exception(found.failure);
  }
  if (unsaid > 0)
    faults.push_back({{}, fmt::format("and {} more faults of this kind in other bonds", unsaid), "as above"});
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace bondstatic
