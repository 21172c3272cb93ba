// SPDX-License-Identifier: MIT
#include "cli/io/messages.hpp"

#include "cli/io/descriptor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace limitcurve::cli {

void Messages::say(const std::string& line) {
  if (kind_ == Kind::none) return;
  if (lines_ != nullptr) return lines_->push_back(line);
  const std::lock_guard lock(mutex_);
  clear();
  std::fprintf(stderr, "%s\n", line.c_str());
}

void Messages::say(const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) say("limitcurve: " + remark);
}

void Messages::start(const std::string& job) {
  if (kind_ != Kind::notes_and_progress) return;
  job_ = job;
  began_ = Clock::now();
  bar_ = descriptor::draws(descriptor::standard_error);
  thread_ = std::thread([this] { watch(); });
}

void Messages::progress(double fraction) noexcept {
  if (!thread_.joinable()) return;
  const std::lock_guard lock(mutex_);
  if (fraction > 0.0) share_ = std::min(fraction, 1.0);  // at 0 nobody knows yet how long it takes
}

void Messages::stop() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_one();
  thread_.join();
  clear();
}

void Messages::watch() {
  using Seconds = std::chrono::duration<double>;
  constexpr Seconds first_line{5.0};
  std::unique_lock lock(mutex_);
  Seconds pause = bar_ ? Seconds(1.0) : first_line;
  while (!wake_.wait_for(lock, pause, [this] { return ends_; })) {
    const Seconds passed = Clock::now() - began_;
    const std::string text = status(passed.count());
    pause = bar_ ? Seconds(0.2) : std::max(first_line, passed / 10.0);
    if (!bar_) {
      std::fprintf(stderr, "%s\n", text.c_str());
      continue;
    }
    // What the last one had more of is written over with blanks.
    std::fprintf(stderr, "\r%-*s\r", static_cast<int>(std::max(shown_, text.size())), text.c_str());
    std::fflush(stderr);
    shown_ = text.size();
  }
}

std::string Messages::status(double seconds) const {
  const std::string time = std::to_string(std::lround(seconds)) + " s";
  const std::string percent = share_ < 0.0 ? "" : std::to_string(static_cast<int>(100.0 * share_)) + " %, ";
  std::string text = "limitcurve: " + job_ + ": ";
  if (bar_) {
    constexpr std::size_t width = 20;
    constexpr std::size_t mark = 4;
    // Of unknown length: a mark that runs along the bar.
    const std::size_t begin = share_ < 0.0 ? static_cast<std::size_t>(5.0 * seconds) % (width - mark + 1) : 0;
    const std::size_t length = share_ < 0.0 ? mark : static_cast<std::size_t>(share_ * width);
    text += '[' + std::string(begin, ' ') + std::string(length, '#') + std::string(width - begin - length, ' ') + "] ";
  }
  return text + percent + time;
}

void Messages::clear() {
  if (shown_ == 0) return;
  std::fprintf(stderr, "\r%*s\r", static_cast<int>(shown_), "");
  std::fflush(stderr);
  shown_ = 0;
}

}  // namespace limitcurve::cli
