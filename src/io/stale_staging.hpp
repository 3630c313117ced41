// Staging folders of FileSet, hidden in the result folder, and what becomes of those whose owner was killed.
// While its owner lives, a staging folder is locked (flock), so one that can be locked has none.
#pragma once

#include <filesystem>

namespace bondstatic {

/// Subfolders of a staging folder: files being written, files that come into place, files set aside for them.
/// "new" becomes "ready" once all is set aside; from then on a commit is completed, before that undone.
inline constexpr const char* staged_new = "new";
inline constexpr const char* staged_ready = "ready";
inline constexpr const char* staged_old = "old";

class FolderLock {
 public:
  enum class State { held, taken, unsupported };

  FolderLock() = default;
  /// Never waits. Taken: another has it, or has removed the folder. Throws filesystem_error.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept { *this = std::move(other); }
  FolderLock& operator=(FolderLock&& other) noexcept;

  State state() const { return state_; }

 private:
  int descriptor_ = -1;
  State state_ = State::unsupported;
};

/// Makes a staging folder; no sweep touches it while the lock lives. Throws filesystem_error.
std::filesystem::path make_staging(const std::filesystem::path& folder, FolderLock& lock);

void remove_staging(const std::filesystem::path& staging) noexcept;

/// Removes the staging folders of killed runs from a result folder. A commit that was cut short is undone, or
/// completed where it had got too far, so that the results are those of one run and none is lost. Leaves what
/// it cannot remove, and everything where the file system has no locks.
void sweep_stale_staging(const std::filesystem::path& folder) noexcept;

}  // namespace bondstatic
