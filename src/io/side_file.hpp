// One file of a set, written on a thread of its own while the set goes on with others.
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <string>

#include "io/file_set.hpp"

namespace bondstatic {

/// Where the set has one thread only, the file is written by finish() instead. Gives up where it is destroyed
/// before finish().
class SideFile {
 public:
  /// What `write` looks at must stay until the end of this. Throws Error where the file cannot be opened.
  SideFile(FileSet& files, const std::string& name, const std::function<void(OutputFile&)>& write);
  ~SideFile();
  SideFile(const SideFile&) = delete;
  SideFile& operator=(const SideFile&) = delete;

  /// Waits until the file is whole, with the set's checkpoint. Throws what `write` has thrown.
  void finish();

 private:
  FileSet& files_;
  std::atomic<bool> given_up_ = false;
  std::future<void> written_;
};

}  // namespace bondstatic
