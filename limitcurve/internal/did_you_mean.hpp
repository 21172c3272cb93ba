// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve {

/// Number of letters to change, add, remove or exchange with a neighbour that turns one word into the other, in upper
/// or lower case.
inline std::size_t edit_distance(std::string_view from, std::string_view to) {
  const std::size_t columns = to.size() + 1;
  std::vector<std::size_t> distance((from.size() + 1) * columns);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return distance[i * columns + j]; };
  const auto lower = [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  };
  for (std::size_t i = 0; i <= from.size(); ++i) at(i, 0) = i;
  for (std::size_t j = 0; j <= to.size(); ++j) at(0, j) = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const bool same = lower(from[i - 1]) == lower(to[j - 1]);
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + (same ? 0 : 1)});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  }
  return distance.back();
}

/// The end of an error message, "; did you mean 'WORD'?": WORD is the known word nearest to the unknown one, followed
/// by `rest`. Empty if none is near: at most one letter in three may differ, or the unknown word is the beginning of a
/// known one.
inline std::string did_you_mean(std::string_view unknown, const std::vector<std::string_view>& known,
                                std::string_view rest = {}) {
  constexpr std::size_t shortest_beginning = 3;
  constexpr std::size_t longest = 40;  // no known word is longer; the distance costs the product of lengths
  std::string_view nearest;
  std::size_t least = std::min(unknown.size(), longest) / 3 + 1;
  for (const std::string_view word : known) {
    const bool begins = unknown.size() >= shortest_beginning && word.substr(0, unknown.size()) == unknown;
    const std::size_t distance = unknown.size() > longest ? least : begins ? 1 : edit_distance(unknown, word);
    if (word == unknown) return {};
    if (distance >= least) continue;
    least = distance;
    nearest = word;
  }
  if (nearest.empty()) return {};
  return "; did you mean '" + std::string(nearest) + std::string(rest) + "'?";
}

}  // namespace limitcurve
