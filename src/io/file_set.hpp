// A set of output files that appears whole or not at all: written to a staging folder inside the target
// folder, renamed into place by commit(), and removed without a trace where commit() is not reached or fails.
// A staging folder that a killed run left behind is removed by the next set in the same folder.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/output_file.hpp"
#include "io/stale_staging.hpp"

namespace bondstatic {

class FileSet {
 public:
  /// Makes `folder` (and its parents) where it is missing. The checkpoint is called between pieces of work,
  /// by whichever of the `threads` is at it.
  /// Throws Error (invalid_input) that names the folder where nothing can be written there.
  explicit FileSet(const std::filesystem::path& folder, Checkpoint checkpoint = {}, int threads = 1);
  ~FileSet();
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;

  /// Files of an earlier run, relative to the folder: commit() replaces those that are written again, and
  /// removes the others together with subfolders that they leave empty.
  void supersede(const std::vector<std::string>& names) { superseded_ = names; }

  /// Starts a file; finishes the one before, whose reference is then no longer valid.
  OutputFile& create(const std::string& name);

  /// Goes on with a file that create() started and another create() finished.
  OutputFile& extend(const std::string& name);

  /// A file that stays open beside the others, for one thread and with a checkpoint of its own (SideFile).
  /// The caller closes it before commit().
  std::unique_ptr<OutputFile> create_beside(const std::string& name, Checkpoint checkpoint);

  /// Where create() puts the files until commit(), made where it is missing. Other processes may put files
  /// there, too: adopt() makes such a one part of the set, as if it had been created here and now. The others
  /// must be removed before commit().
  std::filesystem::path shared_folder();
  void adopt(const std::string& name) { names_.push_back(name); }

  /// Bytes written so far, of all files.
  double bytes() const { return double(bytes_); }
  int threads() const { return threads_; }
  const Checkpoint& checkpoint() const { return checkpoint_; }

  /// Puts everything in place, the file that was created last comes last. A file in the way that is not
  /// superseded is never overwritten: Error (invalid_input). After any error all is as it was before.
  void commit();

 private:
  struct Move {
    std::filesystem::path from, to;
  };

  void make_folders(const std::filesystem::path& folder);
  std::unique_ptr<OutputFile> open(const std::string& name, OutputFile::Begin begin, Checkpoint checkpoint,
                                   int threads);
  void move(const std::filesystem::path& from, const std::filesystem::path& to);
  void finish_current();
  void set_aside(const std::string& name);
  void declare_ready();
  void roll_back() noexcept;
  void remove_made_folders() noexcept;

  std::filesystem::path folder_, staging_;
  FolderLock lock_;  ///< on the staging folder
  Checkpoint checkpoint_;
  int threads_;
  std::atomic<Index> bytes_ = 0;
  std::vector<std::string> names_, superseded_;
  std::unique_ptr<OutputFile> current_;
  std::vector<std::filesystem::path> made_;  ///< folders that were not there before
  std::vector<Move> moves_;                  ///< done by commit(), to be undone where it fails
};

/// Throws Error (invalid_input) where no file could be written in `folder`, or where one of `names` exists
/// there and is not among `superseded`. Touches nothing: the check to make before the work that leads to the
/// files.
void check_writable(const std::filesystem::path& folder, const std::vector<std::string>& names,
                    const std::vector<std::string>& superseded);

}  // namespace bondstatic
