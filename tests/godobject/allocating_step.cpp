// SPDX-License-Identifier: MIT
// What a servo loop must not do: check_symbols.cmake has to find it.
#include <vector>

double allocating_step(double value) {
  std::vector<double> copies(static_cast<std::size_t>(value), value);
  return copies.back();
}
