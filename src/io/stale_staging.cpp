#include "io/stale_staging.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace bondstatic {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".bondstatic-", unique = "XXXXXX";

[[noreturn]] void fail(const fs::path& path, int reason) {
  throw fs::filesystem_error("", path, std::error_code(reason, std::generic_category()));
}

bool is_at(int descriptor, const fs::path& path) {
  struct stat opened = {}, named = {};
  return ::fstat(descriptor, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/// A folder of the user's may happen to have such a name, too.
bool is_staging(const fs::path& folder) {
  const std::string name = folder.filename().string();
  if (name.size() != prefix.size() + unique.size() || !name.starts_with(prefix)) return false;
  return std::all_of(fs::directory_iterator(folder), fs::directory_iterator(), [](const auto& entry) {
    const fs::path inside = entry.path().filename();
    return inside == staged_new || inside == staged_ready || inside == staged_old;
  });
}

/// Moves every file to the same place in `folder`, if that is free.
void move_files(const fs::path& from, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(from))
    if (entry.is_symlink() || !entry.is_directory()) files.push_back(entry.path());
  for (const fs::path& file : files) {
    const fs::path target = folder / file.lexically_relative(from);
    if (fs::exists(fs::symlink_status(target))) continue;
    fs::create_directories(target.parent_path());
    fs::rename(file, target);
  }
}

void sweep(const fs::path& staging, const fs::path& folder) {
  const FolderLock lock(staging);
  if (lock.state() != FolderLock::State::held || !is_staging(staging)) return;
  // What was set aside may be the only copy of an earlier result. Before anything came into place, it goes
  // back. After that, the way ahead is the one that leaves no mixture of two runs: the new files are whole,
  // and all that they supersede is set aside.
  const fs::path ready = staging / staged_ready, old = staging / staged_old;
  if (fs::exists(ready)) {
    move_files(ready, folder);
  } else if (fs::exists(old)) {
    move_files(old, folder);
  }
  remove_staging(staging);
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) {
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor_ < 0 && errno != ENOENT) fail(folder, errno);
  state_ = State::taken;
  if (descriptor_ < 0) return;
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
    state_ = errno == EWOULDBLOCK ? State::taken : State::unsupported;
  else if (is_at(descriptor_, folder))
    state_ = State::held;
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(state_, other.state_);
  return *this;
}

fs::path make_staging(const fs::path& folder, FolderLock& lock) {
  // Between the making and the locking, a sweep of another run may get hold of the folder and remove it.
  for (int attempt = 0; attempt < 100; ++attempt) {
    std::string path = (folder / prefix).string().append(unique);
    if (!::mkdtemp(path.data())) fail(folder, errno);
    try {
      lock = FolderLock(path);
    } catch (...) {
      ::rmdir(path.c_str());
      throw;
    }
    if (lock.state() != FolderLock::State::taken) return path;
  }
  fail(folder, EBUSY);
}

void remove_staging(const fs::path& staging) noexcept {
  // The old files go first: as long as they are there, "ready" must say that they are superseded.
  std::error_code ignored;
  fs::remove_all(staging / staged_old, ignored);
  fs::remove_all(staging, ignored);
}

void sweep_stale_staging(const fs::path& folder) noexcept {
  // A leftover does no harm, but a run that fails because of one does: so no failure goes further.
  try {
    std::vector<fs::path> candidates;
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().filename().string().starts_with(prefix)) candidates.push_back(entry.path());
    for (const fs::path& staging : candidates) {
      try {
        sweep(staging, folder);
      } catch (const fs::filesystem_error&) {
        continue;
      }
    }
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace bondstatic
