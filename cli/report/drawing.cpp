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
    if (::pipe(ends_.data()) != 0) throw std::runtime_error(system_complaint("make", "a pipe"));
    for (const int end : ends_) ::fcntl(end, F_SETFD, FD_CLOEXEC);
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

  /// Calls `take` with every line, its end included, until the other end is closed everywhere.
  template <class Take>
  void lines(const Take& take) {
    std::string text;
    std::array<char, 4096> chunk{};
    for (;;) {
      const ssize_t count = ::read(ends_[0], chunk.data(), chunk.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) break;
      text.append(chunk.data(), static_cast<std::size_t>(count));
      for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
        take(text.substr(0, end + 1));
        text.erase(0, end + 1);
      }
    }
    if (!text.empty()) take(text);
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// A file without a name that is gone with this object. A pipe would have to be read at the same time as the other.
class Scratch {
 public:
  Scratch() : file_(std::tmpfile()) {
    if (file_ == nullptr) throw std::runtime_error(system_complaint("make", "a temporary file"));
  }
  ~Scratch() { std::fclose(file_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] int descriptor() const { return ::fileno(file_); }
  std::string contents() {
    std::rewind(file_);
    std::string text;
    std::array<char, 4096> chunk{};
    while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file_)) text.append(chunk.data(), count);
    return text;
  }

 private:
  std::FILE* file_;
};

/// The last line of a text, which is where Python says what went wrong.
std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? text : text.substr(end + 1);
}

}  // namespace

std::string draw_report(const std::filesystem::path& script, const std::filesystem::path& directory, Messages& messages, double begin) {
  const std::string kept = "; the CSV files are in '" + directory.string() + "'";
  std::array<std::string, 6> words{python, script.string(), "--data", directory.string(), "--output", directory.string()};
  std::array<char*, 7> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  Pipe results;
  Scratch complaints;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, results.entrance(), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, complaints.descriptor(), STDERR_FILENO);
  pid_t child = 0;
  const int refused = ::posix_spawn(&child, python, &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (refused != 0) {
    throw std::runtime_error(std::string("cannot run ") + python + " to draw the report: " + std::generic_category().message(refused) +
                             "; install python3-matplotlib" + kept);
  }
  results.close_entrance();
  std::string printed;
  results.lines([&](const std::string& line) {
    int figure = 0;
    int figures = 0;
    if (std::sscanf(line.c_str(), "figure %d of %d", &figure, &figures) == 2 && figures > 0) {
      messages.progress(begin + (1.0 - begin) * figure / figures);
    } else {
      printed += line;
    }
  });
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::runtime_error("lost track of '" + script.string() + "'" + kept);
  }
  const std::string said = complaints.contents();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("the report could not be drawn (python3-matplotlib is needed): " +
                             (said.empty() ? "'" + script.string() + "' failed" : last_line(said)) + kept);
  }
  if (!said.empty()) messages.say(said.substr(0, said.find_last_not_of('\n') + 1));
  return printed;
}

}  // namespace limitcurve::cli
