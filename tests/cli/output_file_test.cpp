// SPDX-License-Identifier: MIT
#undef _FORTIFY_SOURCE  // which would define open in its header
#include "cli/io/output_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

std::atomic<bool> has_nameless_files{true};

}  // namespace

/// In place of the C library's, so that a file system may be without nameless files.
extern "C" int open(const char* path, int flags, ...) {
  if ((flags & O_TMPFILE) == O_TMPFILE && !has_nameless_files) {
    errno = EOPNOTSUPP;
    return -1;
  }
  va_list arguments;
  va_start(arguments, flags);
  const int mode = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(arguments, int) : 0;
  va_end(arguments);
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

namespace limitcurve::cli {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  AtomicFile file(path);
  file.output().write(text);
  file.commit();
}

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// With and without nameless files.
class OutputFiles : public testing::TestWithParam<bool> {
 protected:
  OutputFiles() {
    has_nameless_files = GetParam();
    std::string name = testing::TempDir() + "output-XXXXXX";
    folder_ = ::mkdtemp(name.data());
    fs::permissions(folder_, fs::perms::all);
  }
  ~OutputFiles() override {
    fs::remove_all(folder_);
    has_nameless_files = true;
  }
  /// A file beside those that were asked for is one left behind.
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};
INSTANTIATE_TEST_SUITE_P(, OutputFiles, testing::Bool());

TEST_P(OutputFiles, OfSeveralThreadsAreWholeAtAnyTime) {
  const fs::path path = folder_ / "table.csv";
  const auto text_of = [](int writer) { return std::string(100000, static_cast<char>('a' + writer)); };
  write(path, text_of(0));
  std::atomic<int> lost{0};
  std::atomic<bool> done{false};
  std::vector<std::thread> writers;
  for (int writer = 0; writer < 4; ++writer) {
    writers.emplace_back([&, text = text_of(writer)] {
      for (int i = 0; i < 100; ++i) {
        try {
          write(path, text);
        } catch (const std::exception&) {
          ++lost;
        }
      }
    });
  }
  std::thread reader([&] {
    while (!done) {
      const std::string text = read(path);
      if (text.size() != 100000 || text.find_first_not_of(text.front()) != std::string::npos) ++lost;
    }
  });
  for (std::thread& writer : writers) writer.join();
  done = true;
  reader.join();
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(count(), 1U);
}

TEST_P(OutputFiles, BehindLinksAreWrittenWhereTheLinksLead) {
  fs::create_directory(folder_ / "data");
  fs::create_symlink("data/link.csv", folder_ / "first.csv");
  fs::create_symlink("target.csv", folder_ / "data/link.csv");
  for (const char* const text : {"new", "newer"}) {  // first the target is not there
    write(folder_ / "first.csv", text);
    EXPECT_TRUE(fs::is_symlink(folder_ / "first.csv") && fs::is_symlink(folder_ / "data/link.csv"));
    EXPECT_FALSE(fs::is_symlink(folder_ / "data/target.csv"));
    EXPECT_EQ(read(folder_ / "data/target.csv"), text);
  }
  EXPECT_EQ(count(), 2U);
  fs::create_symlink("circle.csv", folder_ / "circle.csv");
  EXPECT_THROW(write(folder_ / "circle.csv", "text"), std::runtime_error);
}

TEST_P(OutputFiles, ThatArePipesOrDevicesAreWrittenNotReplaced) {
  const fs::path pipe = folder_ / "pipe.csv";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0666), 0);
  std::string got;
  std::thread reader([&] { got = read(pipe); });
  write(pipe, std::string(200000, 'x'));
  reader.join();
  EXPECT_EQ(got.size(), 200000U);
  EXPECT_TRUE(fs::is_fifo(pipe));
  fs::create_symlink("/dev/null", folder_ / "null.csv");
  write(folder_ / "null.csv", "text");
  EXPECT_TRUE(fs::is_character_file("/dev/null") && fs::is_symlink(folder_ / "null.csv"));
  EXPECT_EQ(count(), 2U);
}

TEST_P(OutputFiles, KeepTheirPermissions) {
  const fs::path path = folder_ / "table.csv";
  write(path, "old");
  const ::mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0666 & ~mask));
  for (const int mode : {0600, 0646, 0755}) {
    fs::permissions(path, fs::perms(mode));
    write(path, "new");
    EXPECT_EQ(fs::status(path).permissions(), fs::perms(mode));
  }
  fs::permissions(path, fs::perms(0444));
  const bool is_root = ::geteuid() == 0;  // for whom nothing is read-only
  if (is_root) {
    ASSERT_EQ(::seteuid(65534), 0);
  }
  EXPECT_THROW(write(path, "newer"), std::runtime_error);
  if (is_root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  EXPECT_EQ(read(path), "new");
  EXPECT_EQ(count(), 1U);
}

TEST_P(OutputFiles, MayHaveTheLongestNames) {
  const fs::path path = folder_ / (std::string(251, 'n') + ".csv");
  write(path, "old");
  write(path, "new");
  EXPECT_EQ(read(path), "new");
}

}  // namespace
}  // namespace limitcurve::cli
