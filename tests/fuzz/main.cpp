// SPDX-License-Identifier: MIT
#include "tests/fuzz/fuzz.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

namespace {

limitcurve::fuzz::Target::Body body_of_target = nullptr;

}  // namespace

/// libFuzzer calls these. The first argument names the target; libFuzzer gets the others.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const auto& targets = limitcurve::fuzz::Target::all();
  const auto found = *argc > 1 ? targets.find((*argv)[1]) : targets.end();
  if (found == targets.end()) {
    std::cerr << "expected a target, one of:";
    for (const auto& [name, body] : targets) std::cerr << ' ' << name;
    std::cerr << '\n';
    std::exit(2);
  }
  body_of_target = found->second;
  (*argv)[1] = (*argv)[0];
  ++*argv;
  --*argc;
  return 0;
}
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  body_of_target(data, size);
  return 0;
}

#ifndef LIMITCURVE_SEARCHES
/// Runs the target on every file of the folder given, and on no input at all. A finding aborts, after the file's name.
int main(int argc, char** argv) {
  LLVMFuzzerInitialize(&argc, &argv);
  if (argc != 2) {
    std::cerr << "expected the folder of the seeds\n";
    return 2;
  }
  body_of_target(nullptr, 0);
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
    std::cout << entry.path().filename().string() << std::endl;
    std::ifstream file(entry.path(), std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    body_of_target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++count;
  }
  if (count == 0) std::cerr << "no seeds in " << argv[1] << '\n';
  return count > 0 ? 0 : 1;
}
#endif
