// SPDX-License-Identifier: MIT
#include "cli/report/drawing.hpp"

#include "cli/io/output_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace limitcurve::cli {

namespace {

// Debian's own: another python3 that is first on the PATH may lack matplotlib.
constexpr const char* python = "/usr/bin/python3";

/// The reading end of a pipe, and its other end for a child process.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::runtime_error(system_complaint("make", "a pipe"));
  }
  ~Pipe() {
    ::close(ends_[0]);
    close_entrance();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] int entrance() const { return ends_[1]; }
  void close_entrance() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

  /// All that comes until the other end is closed everywhere, without its beginning if it is long.
  std::string drain() {
    constexpr std::size_t most = 1U << 16U;
    std::string text;
    std::array<char, 4096> chunk{};
    for (;;) {
      const ssize_t count = ::read(ends_[0], chunk.data(), chunk.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return text;
      text.append(chunk.data(), static_cast<std::size_t>(count));
      if (text.size() > most) text.erase(0, text.size() - most);
    }
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// The last line of a text, which is where Python says what went wrong.
std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? text : text.substr(end + 1);
}

}  // namespace

void draw_report(const std::filesystem::path& script, const std::filesystem::path& directory) {
  const std::string kept = "; the CSV files are in '" + directory.string() + "'";
  std::array<std::string, 6> words{python, script.string(), "--data", directory.string(), "--output", directory.string()};
  std::array<char*, 7> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  Pipe complaints;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, complaints.entrance(), STDERR_FILENO);
  pid_t child = 0;
  const int refused = ::posix_spawn(&child, python, &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (refused != 0) {
    throw std::runtime_error(std::string("cannot run ") + python + " to draw the report: " + std::generic_category().message(refused) +
                             "; install python3-matplotlib" + kept);
  }
  complaints.close_entrance();
  const std::string said = complaints.drain();
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::runtime_error("lost track of '" + script.string() + "'" + kept);
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("the report could not be drawn (python3-matplotlib is needed): " +
                             (said.empty() ? "'" + script.string() + "' failed" : last_line(said)) + kept);
  }
  std::fputs(said.c_str(), stderr);
}

}  // namespace limitcurve::cli
