// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace limitcurve::cli {

/// What a run says on standard error: notes, and how far it is if it takes long. On a terminal that is a bar, from the
/// first second on; anywhere else a line, after 5 s, and again after 5 s or a tenth of the time that has passed,
/// whichever is longer.
class Messages {
 public:
  enum class Kind { none, notes, notes_and_progress };

  explicit Messages(Kind kind) : kind_(kind) {}
  /// Notes go to `lines` instead of standard error.
  explicit Messages(std::vector<std::string>& lines) : kind_(Kind::notes), lines_(&lines) {}
  /// Clears the bar.
  ~Messages() { stop(); }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  /// From here on nothing is said.
  void silence() noexcept { kind_ = Kind::none; }
  /// One line, which ends in no line break.
  void say(const std::string& line);
  /// Lines that begin with "note: " or "warning: ".
  void say(const std::vector<std::string>& remarks);

  /// The work named `job` begins.
  void start(const std::string& job);
  /// This fraction of it, 0 to 1, is done. Cheap.
  void progress(double fraction) noexcept;
  /// Nothing more is said of progress, and the bar is cleared: before results appear on the same terminal.
  void stop();

 private:
  using Clock = std::chrono::steady_clock;

  void watch();
  [[nodiscard]] std::string status(double seconds) const;
  void clear();

  Kind kind_;
  std::vector<std::string>* lines_ = nullptr;
  bool bar_ = false;
  std::string job_;
  Clock::time_point began_;
  double share_ = -1.0;    ///< negative where it is not known
  std::size_t shown_ = 0;  ///< letters of the bar that stand on the terminal
  bool ends_ = false;
  std::mutex mutex_;  ///< for all of the above while the thread runs
  std::condition_variable wake_;
  std::thread thread_;
};

}  // namespace limitcurve::cli
