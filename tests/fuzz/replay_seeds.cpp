// SPDX-License-Identifier: MIT
#include "tests/fuzz/fuzz.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

/// Runs the target on every file of the folder given, and on no input at all. A finding aborts, after the file's name.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "expected the folder of the seeds\n";
    return 2;
  }
  LLVMFuzzerTestOneInput(nullptr, 0);
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
    std::cout << entry.path().filename().string() << std::endl;
    std::ifstream file(entry.path(), std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++count;
  }
  if (count == 0) std::cerr << "no seeds in " << argv[1] << '\n';
  return count > 0 ? 0 : 1;
}
