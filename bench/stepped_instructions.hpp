// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <utility>

#if defined(__linux__)
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#endif

namespace limitcurve::godobject::bench {

/// How many instructions `body()` takes: a copy of the process runs it one at a time, some microseconds each. The same on every
/// run, whatever else the machine does, and without a tool. NaN where a process may not trace its child, or if
/// the body does not end.
template <class Body>
double stepped_instructions([[maybe_unused]] Body&& body) {
#if defined(__linux__)
  const pid_t child = fork();
  if (child == 0) {
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(1);
    std::raise(SIGSTOP);
    std::forward<Body>(body)();
    std::raise(SIGSTOP);
    _exit(0);
  }
  int status = 0;
  const auto stopped_by = [&](int signal) {
    return waitpid(child, &status, 0) == child && WIFSTOPPED(status) && WSTOPSIG(status) == signal;
  };
  double count = std::numeric_limits<double>::quiet_NaN();
  if (child > 0 && stopped_by(SIGSTOP)) {
    count = 0.0;
    while (ptrace(PTRACE_SINGLESTEP, child, nullptr, nullptr) == 0 && stopped_by(SIGTRAP)) ++count;
    const bool ended = WIFSTOPPED(status) && WSTOPSIG(status) == SIGSTOP;
    if (!ended) count = std::numeric_limits<double>::quiet_NaN();
  }
  if (child > 0 && !WIFEXITED(status) && !WIFSIGNALED(status)) {
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
  }
  return count;
#else
  return std::numeric_limits<double>::quiet_NaN();
#endif
}

}  // namespace limitcurve::godobject::bench
