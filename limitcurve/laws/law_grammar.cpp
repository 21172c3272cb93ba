// SPDX-License-Identifier: MIT
#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve {

namespace {

std::invalid_argument complaint(std::string_view text, const std::string& what) {
  return std::invalid_argument("law '" + std::string(text) + "': " + what);
}

/// The value in `key=value`, which must be all of `parameters`.
double parameter(std::string_view text, std::string_view parameters, std::string_view key) {
  const std::string expected = "expected " + std::string(key) + "=NUMBER after the colon";
  if (parameters.substr(0, key.size()) != key || parameters.size() <= key.size() || parameters[key.size()] != '=') {
    throw complaint(text,
                    expected + ", got '" + std::string(parameters) + "'" + did_you_mean(parameters.substr(0, parameters.find('=')), {key}));
  }
  const std::string_view number = parameters.substr(key.size() + 1);
  const auto value = parse_number(number);
  if (!value) throw complaint(text, expected + ", got '" + std::string(number) + "' for the number");
  return *value;
}

Law parse_mixture(std::string_view text, std::string_view parts) {
  std::vector<std::pair<double, Law>> mixed;
  std::size_t begin = 0;
  while (begin <= parts.size()) {
    // A plus after the e of an exponent belongs to the number: 1e+3*hertz.
    std::size_t end = parts.find('+', begin);
    const auto in_exponent = [&] {
      const bool after_e = end > begin + 1 && (parts[end - 1] == 'e' || parts[end - 1] == 'E');
      return after_e && ((parts[end - 2] >= '0' && parts[end - 2] <= '9') || parts[end - 2] == '.');
    };
    while (end != std::string_view::npos && in_exponent()) {
      end = parts.find('+', end + 1);
    }
    const std::string_view part = parts.substr(begin, end == std::string_view::npos ? end : end - begin);
    const std::size_t star = part.find('*');
    const auto weight = star == std::string_view::npos ? std::nullopt : parse_number(part.substr(0, star));
    if (!weight) throw complaint(text, "expected WEIGHT*LAW, got '" + std::string(part) + "'");
    const std::string_view name = part.substr(star + 1);
    if (name.substr(0, 4) == "mix:") throw complaint(text, "a mixture of mixtures: write it as one");
    mixed.emplace_back(*weight, parse_law(name));
    if (end == std::string_view::npos) break;
    begin = end + 1;
  }
  return mixture(mixed);
}

Law parse_unchecked(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view kind = text.substr(0, colon);
  const std::string_view parameters = colon == std::string_view::npos ? std::string_view{} : text.substr(colon + 1);
  if (colon == std::string_view::npos) {
    if (kind == "hertz") return hertz();
    if (kind == "uniform") return uniform();
    if (kind == "parabolic") return parabolic();
    if (kind == "flat-punch") return flat_punch();
    if (kind == "cone") return cone();
  }
  if (kind == "power") return power(parameter(text, parameters, "n"));
  if (kind == "xydas-kao") return xydas_kao(parameter(text, parameters, "k"));
  if (kind == "gaussian") return gaussian(parameter(text, parameters, "sigma"));
  if (kind == "mix") return parse_mixture(text, parameters);
  std::string expected = "expected one of";
  std::vector<std::string_view> kinds{"samples"};
  for (const std::string_view example : law_examples()) {
    expected += ' ' + std::string(example);
    kinds.push_back(example.substr(0, example.find(':')));
  }
  expected += "; on the command line also samples:FILE.csv (radius,pressure)";
  throw complaint(text, expected + did_you_mean(kind, kinds, text.substr(kind.size())));
}

}  // namespace

std::span<const std::string_view> law_examples() {
  static constexpr std::array examples =
      std::to_array<std::string_view>({"hertz", "uniform", "parabolic", "flat-punch", "cone", "power:n=2.3", "xydas-kao:k=3",
                                       "gaussian:sigma=0.4", "mix:0.7*hertz+0.3*uniform"});
  return examples;
}

Law parse_law(std::string_view text) {
  try {
    return parse_unchecked(text);
  } catch (const std::invalid_argument& error) {
    // Factories report parameters out of range, but do not know the string: add it.
    if (std::string_view(error.what()).substr(0, 5) == "law '") throw;
    throw complaint(text, error.what());
  }
}

}  // namespace limitcurve
