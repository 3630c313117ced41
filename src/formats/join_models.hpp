// Several files of one model: particles here, bonds there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/foreign_model.hpp"

namespace bondstatic {

struct ReadFile {
  std::string path;
  ForeignModel model;
};

struct JoinedModel {
  ForeignModel model;
  Index parallel_bonds = 0;  ///< that join a pair which another bond joins already
};

/// All of them as one model, in their order, which is sound then: every particle and every bond has an id of
/// its own (those without one are numbered behind the largest), positions are finite, radii positive or
/// everywhere absent, bonds join two different particles that are there. Where one file is in SI units, those
/// that do not say theirs are assumed to be, too. Nothing, and faults with file and line, where it cannot be.
/// The files' models are used up.
std::optional<JoinedModel> join_models(std::vector<ReadFile> files, std::vector<Fault>& faults);

}  // namespace bondstatic
