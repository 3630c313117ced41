// All that a reader found, as text with 17 digits; checks that it is sound.
#pragma once

#include <string>

#include "formats/malformed.hpp"
#include "formats/readers.hpp"

namespace bondstatic::test {

/// Ids are distinct, numbers finite, radii positive or not given; bonds join two particles, which are there
/// where the file has particles; columns are as long as what they belong to.
std::string digest(const ForeignModel& model);
std::string digest(const ParticleState& state);
std::string digest(const BondState& state);

/// A function of formats/readers.hpp, or one of its kind, as expect_robust() takes it.
template <class Read>
DigestingReader digesting(Read read, const ReadOptions& options = {}) {
  return [read, options](const std::string& path, std::vector<Fault>& faults) -> std::optional<std::string> {
    const auto found = read(path, options, named_at, faults);
    return found ? std::optional(digest(*found)) : std::nullopt;
  };
}

}  // namespace bondstatic::test
