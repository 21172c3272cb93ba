// SPDX-License-Identifier: MIT
#include "cli/report/share.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#ifdef _WIN32
#include <array>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#endif

namespace limitcurve::cli {

namespace {

/// Where this executable lies; empty if that cannot be known.
std::filesystem::path own_path() {
#ifdef _WIN32
  std::array<wchar_t, 4096> path{};
  return std::wstring(path.data(), ::GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size())));
#else
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown);
#endif
}

std::filesystem::path package_share;

}  // namespace

void set_package_share(std::filesystem::path folder) {
  package_share = std::move(folder);
}

std::filesystem::path find_share() {
  std::vector<std::filesystem::path> candidates;
  if (const char* const given = std::getenv("LIMITCURVE_SHARE"); given != nullptr && *given != '\0') {
    candidates.emplace_back(given);
  } else {
    if (!package_share.empty()) candidates.push_back(package_share);
    const std::filesystem::path executable = own_path();
    if (!executable.empty()) candidates.push_back(executable.parent_path().parent_path() / "share" / "limitcurve");
    candidates.emplace_back(LIMITCURVE_SOURCE_DIRECTORY);
  }
  std::string tried;
  for (const auto& candidate : candidates) {
    std::error_code absent;
    if (std::filesystem::exists(candidate / "scripts" / "figures" / "report.py", absent)) return candidate;
    tried += ' ' + (candidate / "scripts" / "figures" / "report.py").string();
  }
  throw std::runtime_error("the report's script was not found, tried" + tried + "; LIMITCURVE_SHARE may name the folder above scripts/");
}

}  // namespace limitcurve::cli
