#include "io/side_file.hpp"

#include <chrono>

namespace bondstatic {

namespace {

struct GivenUp {};

}  // namespace

SideFile::SideFile(FileSet& files, const std::string& name, const std::function<void(OutputFile&)>& write)
    : files_(files) {
  const bool at_once = files.threads() > 1;
  const Checkpoint look = [this] {
    if (given_up_) throw GivenUp();
  };
  written_ = std::async(at_once ? std::launch::async : std::launch::deferred,
                        [write, file = files.create_beside(name, at_once ? look : files.checkpoint())] {
                          write(*file);
                          file->close();
                        });
}

SideFile::~SideFile() {
  given_up_ = true;
  written_ = {};  // waits
}

void SideFile::finish() {
  using std::chrono_literals::operator""ms;
  while (written_.wait_for(50ms) == std::future_status::timeout)
    if (files_.checkpoint()) files_.checkpoint()();
  written_.get();
}

}  // namespace bondstatic
