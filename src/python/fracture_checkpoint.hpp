// The file that keeps an unfinished run of fracture.
#pragma once

#include <filesystem>
#include <vector>

#include "results/fracture_checkpoint.hpp"

namespace bondstatic {

/// `path` empty: nothing is kept. Throws Error (invalid_input) where a run lies there and is not to be gone
/// on with, where the file is damaged, and where it is of other outputs.
KeptFracture kept_run(const std::filesystem::path& path, bool resume, const std::vector<Output>& outputs);

/// Of a run that has ended.
void remove_kept(const std::filesystem::path& path);

/// Replaces the file as a whole.
void keep_run(const std::filesystem::path& path, const KeptFracture& kept,
              const std::vector<Output>& outputs);

}  // namespace bondstatic
