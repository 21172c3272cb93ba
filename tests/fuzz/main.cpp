// SPDX-License-Identifier: MIT
#include "tests/fuzz/fuzz.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

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
  body_of_target({reinterpret_cast<const char*>(data), size});
  return 0;
}

#ifndef LIMITCURVE_SEARCHES
/// Runs the target on every file of the folder given, or on every line of the file given, and on no input at all. A
/// finding aborts, after its name.
int main(int argc, char** argv) {
  LLVMFuzzerInitialize(&argc, &argv);
  if (argc != 2) {
    std::cerr << "expected the folder or the file of the seeds\n";
    return 2;
  }
  int count = 0;
  const auto run = [&count](const std::string& name, const std::string& bytes) {
    std::cout << name << std::endl;
    body_of_target(bytes);
    ++count;
  };
  body_of_target({});
  if (std::filesystem::is_directory(argv[1])) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
      std::ifstream file(entry.path(), std::ios::binary);
      run(entry.path().filename().string(), {std::istreambuf_iterator<char>(file), {}});
    }
  } else {
    std::ifstream file(argv[1]);
    for (std::string line; std::getline(file, line);) run(line, line);
  }
  if (count == 0) std::cerr << "no seeds in " << argv[1] << '\n';
  return count > 0 ? 0 : 1;
}
#endif
