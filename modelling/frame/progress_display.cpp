// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/frame/progress_display.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sys/ioctl.h>
#include <unistd.h>

namespace rollfem::modelling {

namespace {

constexpr auto redraw_interval = std::chrono::milliseconds(100);
// In a log, a long stage reports at least this often.
constexpr auto longest_silence = std::chrono::seconds(10);
constexpr auto tick_interval = std::chrono::seconds(1);
constexpr double worth_an_estimate = 3.0;  // s

std::size_t terminal_width() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

/// Remaining time if later load points take as long as the earlier ones; "" while the estimate is
/// not useful.
std::string time_left(const contact::ProgressEvent& event, double seconds) {
  const int done = event.finished ? event.point : event.point - 1;
  if (done < 1 || done >= event.points || seconds < worth_an_estimate) return "";
  return fmt::format(", about {:.0f} s left", seconds / done * (event.points - done));
}

}  // namespace

std::string progress_line(const contact::ProgressEvent& event, double seconds) {
  std::string line = fmt::format("{:<10} {:<18}", event.model, event.stage);
  if (event.point > 0) line += fmt::format(" {}/{}", event.point, event.points);
  if (event.point > 0 && event.creepage) line += fmt::format(" xi {:<7g}", *event.creepage);
  if (event.iteration > 0) line += fmt::format(" it {:<3}", event.iteration);
  if (event.residual > 0.0) line += fmt::format(" res {:.1e}", event.residual);
  if (event.contact_elements > 0) line += fmt::format(" contact {}", event.contact_elements);
  if (event.adhesion_elements > 0) line += fmt::format(" adhesion {}", event.adhesion_elements);
  line += fmt::format(" {:.1f} s{}", seconds, time_left(event, seconds));
  if (!event.note.empty()) line += (event.warns ? "  warning: " : "  ") + event.note;
  return line;
}

ProgressDisplay::Mode ProgressDisplay::mode_of_stderr() {
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal == nullptr || std::strcmp(terminal, "dumb") == 0;
  if (const char* wanted = std::getenv("ROLLFEM_PROGRESS"); wanted && *wanted) return Mode::plain;
  if (isatty(STDERR_FILENO) != 1) return Mode::silent;  // a file is for errors and warnings
  return dumb ? Mode::plain : Mode::terminal;
}

ProgressDisplay::~ProgressDisplay() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
    clear_line();
  }
  end_.notify_all();
  if (ticking_.joinable()) ticking_.join();
}

void ProgressDisplay::show(const contact::ProgressEvent& event) {
  if (mode_ == Mode::silent) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto now = Clock::now();
  const std::string stage = event.model + '/' + event.stage;
  if (stage != stage_) {
    stage_ = stage;
    // The stages of a step alternate, so each keeps its starting time.
    if (event.point <= 1 || begins_.count(stage) == 0) begins_[stage] = now;
    stage_begin_ = begins_[stage];
    if (mode_ == Mode::terminal) last_shown_ = Clock::time_point();
  }
  event_ = event;
  // All load points of a stage share one line.
  const bool complete = event.finished && (event.point == 0 || event.point == event.points);
  const auto since = now - last_shown_;
  if (!complete &&
      (mode_ == Mode::plain ? !event.finished || since < longest_silence : since < redraw_interval))
    return;
  write(now, complete);
  if (mode_ == Mode::terminal && !ticking_.joinable()) ticking_ = std::thread([this] { tick(); });
}

void ProgressDisplay::write(Clock::time_point now, bool complete) {
  last_shown_ = now;
  std::string line =
      progress_line(event_, std::chrono::duration<double>(now - stage_begin_).count());
  if (mode_ == Mode::terminal) {
    // A wrapped line could not be erased.
    const std::size_t width = terminal_width();
    if (line.size() >= width) line.resize(width - 1);
    line = "\r\033[K" + line;
  }
  if (complete || mode_ == Mode::plain) line += '\n';
  line_open_ = mode_ == Mode::terminal && !complete;
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
}

/// Updates the seconds of the open line between events.
void ProgressDisplay::tick() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!end_.wait_for(lock, tick_interval, [this] { return ended_; })) {
    const auto now = Clock::now();
    if (line_open_ && now - last_shown_ >= tick_interval) write(now, false);
  }
}

void ProgressDisplay::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  clear_line();
}

void ProgressDisplay::clear_line() {
  if (!line_open_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  line_open_ = false;
}

}  // namespace rollfem::modelling
