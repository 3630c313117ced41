#include "io/file_set.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void unusable(const fs::path& folder, const std::string& reason) {
  throw Error(ExitCode::invalid_input,
              fmt::format("{}: cannot write results here: {}\n    cure: name a folder that you may write to",
                          folder.string(), reason));
}

[[noreturn]] void in_the_way(const fs::path& path) {
  throw Error(ExitCode::invalid_input,
              fmt::format("{}: exists and is not a result of an earlier run, so it is not overwritten\n"
                          "    cure: name another folder, or move the file away",
                          path.string()));
}

bool present(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() > fs::file_type::not_found;
}

/// "out/" names the folder "out"; no name is the current folder.
fs::path plain(const fs::path& folder) {
  if (folder.empty()) return ".";
  return folder.has_filename() || folder == folder.root_path() ? folder : folder.parent_path();
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

FileSet::FileSet(const fs::path& folder, Checkpoint checkpoint, int threads)
    : folder_(plain(folder)), checkpoint_(std::move(checkpoint)), threads_(threads) {
  try {
    make_folders(folder_);
    sweep_stale_staging(folder_);
    staging_ = make_staging(folder_, lock_);
  } catch (const fs::filesystem_error& error) {
    remove_made_folders();
    unusable(folder_, error.code().message());
  } catch (...) {
    remove_made_folders();
    throw;
  }
}

FileSet::~FileSet() {
  current_.reset();
  roll_back();
  remove_staging(staging_);
  remove_made_folders();
}

void FileSet::make_folders(const fs::path& folder) {
  std::vector<fs::path> missing;
  for (fs::path path = folder; !path.empty() && !present(path); path = path.parent_path())
    missing.push_back(path);
  for (auto path = missing.rbegin(); path != missing.rend(); ++path)
    if (fs::create_directory(*path)) made_.push_back(*path);
  if (!fs::is_directory(folder))
    throw fs::filesystem_error("", folder, std::make_error_code(std::errc::not_a_directory));
}

std::unique_ptr<OutputFile> FileSet::open(const std::string& name, OutputFile::Begin begin,
                                          Checkpoint checkpoint, int threads) {
  const fs::path path = shared_folder() / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) unusable(folder_, error.message());
  return std::make_unique<OutputFile>(path, (folder_ / name).string(), std::move(checkpoint), threads, begin,
                                      &bytes_);
}

OutputFile& FileSet::create(const std::string& name) {
  finish_current();
  current_ = open(name, OutputFile::Begin::empty, checkpoint_, threads_);
  names_.push_back(name);
  return *current_;
}

OutputFile& FileSet::extend(const std::string& name) {
  finish_current();
  current_ = open(name, OutputFile::Begin::at_end, checkpoint_, threads_);
  return *current_;
}

std::unique_ptr<OutputFile> FileSet::create_beside(const std::string& name, Checkpoint checkpoint) {
  std::unique_ptr<OutputFile> file = open(name, OutputFile::Begin::empty, std::move(checkpoint), 1);
  names_.push_back(name);
  return file;
}

fs::path FileSet::shared_folder() {
  const fs::path shared = staging_ / staged_new;
  std::error_code error;
  fs::create_directory(shared, error);
  if (error) unusable(folder_, error.message());
  return shared;
}

void FileSet::finish_current() {
  if (current_) current_->close();
  current_.reset();
}

void FileSet::move(const fs::path& from, const fs::path& to) {
  if (checkpoint_) checkpoint_();
  fs::rename(from, to);
  moves_.push_back({from, to});
}

void FileSet::set_aside(const std::string& name) {
  const fs::path aside = staging_ / staged_old / name;
  fs::create_directories(aside.parent_path());
  move(folder_ / name, aside);
}

void FileSet::declare_ready() {
  if (names_.empty()) return;
  const Move ready{staging_ / staged_new, staging_ / staged_ready};
  fs::rename(ready.from, ready.to);
  moves_.push_back(ready);
}

void FileSet::commit() {
  finish_current();
  for (const std::string& name : names_)
    if (present(folder_ / name) && (!contains(superseded_, name) || fs::is_directory(folder_ / name)))
      in_the_way(folder_ / name);
  try {
    // In reverse: the last file of a set vouches for the others, so it goes first and comes last.
    for (auto name = superseded_.rbegin(); name != superseded_.rend(); ++name)
      if (present(folder_ / *name)) set_aside(*name);
    declare_ready();
    for (const std::string& name : names_) {
      make_folders((folder_ / name).parent_path());
      move(staging_ / staged_ready / name, folder_ / name);
    }
  } catch (const fs::filesystem_error& error) {
    roll_back();
    throw Error(ExitCode::internal,
                fmt::format("{}: {}", error.path2().empty() ? error.path1().string() : error.path2().string(),
                            error.code().message()));
  } catch (...) {
    roll_back();
    throw;
  }
  moves_.clear();
  made_.clear();
  std::error_code ignored;
  for (const std::string& name : superseded_) {
    const fs::path parent = (folder_ / name).parent_path();
    if (parent != folder_) fs::remove(parent, ignored);  // fails, as it should, where something is left in it
  }
}

void FileSet::roll_back() noexcept {
  std::error_code ignored;
  for (auto done = moves_.rbegin(); done != moves_.rend(); ++done) fs::rename(done->to, done->from, ignored);
  moves_.clear();
}

void FileSet::remove_made_folders() noexcept {
  std::error_code ignored;
  for (auto path = made_.rbegin(); path != made_.rend(); ++path) fs::remove(*path, ignored);
  made_.clear();
}

void check_writable(const fs::path& folder, const std::vector<std::string>& names,
                    const std::vector<std::string>& superseded) {
  fs::path nearest = plain(folder);
  while (!present(nearest)) nearest = nearest.has_parent_path() ? nearest.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(nearest, ignored)) unusable(folder, nearest.string() + " is not a folder");
  if (::access(nearest.c_str(), W_OK | X_OK) != 0) unusable(folder, std::strerror(errno));
  for (const std::string& name : names)
    if (present(folder / name) && !contains(superseded, name)) in_the_way(folder / name);
}

}  // namespace bondstatic
