#include "app/status_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/terminal.hpp"

namespace bondstatic {

namespace {

std::string first_word(const std::string& text) {
  return text.substr(0, text.find(' '));
}

std::string time_text(double seconds) {
  const auto whole = long(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

std::string status_text(const std::string& what, double seconds, double part) {
  if (part < 0) return seconds < 1 ? what + " ..." : fmt::format("{}, {}", what, time_text(seconds));
  constexpr int width = 20;
  part = std::min(part, 1.0);
  const int done = int(part * width);
  std::string text = fmt::format("{} [{}{}] {:.0f} %", what, std::string(std::size_t(done), '#'),
                                 std::string(std::size_t(width - done), ' '), 100 * part);
  if (seconds >= 1 && part > 0) text += fmt::format(", {} left", time_text(seconds * (1 - part) / part));
  return text;
}

StatusLine::StatusLine() {
  if (shows_style(stderr)) teller_ = std::jthread([this](const std::stop_token& stop) { tell(stop); });
}

StatusLine::~StatusLine() {
  if (!teller_.joinable()) return;
  teller_.request_stop();
  teller_.join();
  wipe();
}

void StatusLine::show(const std::string& what, double part) {
  if (!teller_.joinable()) return;
  const std::lock_guard lock(mutex_);
  if (first_word(what) != first_word(what_)) begun_ = Clock::now();
  what_ = what;
  part_ = part;
}

void StatusLine::clear() {
  if (!teller_.joinable()) return;
  const std::lock_guard lock(mutex_);
  what_.clear();
  wipe();
}

void StatusLine::tell(const std::stop_token& stop) {
  using namespace std::chrono_literals;
  std::unique_lock lock(mutex_);
  for (auto pause = 330ms; !stopped_.wait_for(lock, stop, pause, [] { return false; }); pause = 200ms) {
    if (stop.stop_requested()) return;
    if (what_.empty()) continue;
    const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    fmt::print(stderr, "\r\033[K{}", status_text(what_, seconds, part_));
    std::fflush(stderr);
    shown_ = true;
  }
}

void StatusLine::wipe() {
  if (shown_) fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace bondstatic
