// SPDX-License-Identifier: MIT
#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/key_values.hpp"
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

/// A kind of law: an example of its text, with the parameter, if it has one; and how it is made.
struct Kind {
  std::string_view example;
  Law (*make)(double parameter);

  [[nodiscard]] constexpr std::string_view name() const { return example.substr(0, example.find(':')); }
  [[nodiscard]] constexpr std::string_view parameter() const {
    const std::size_t colon = example.find(':');
    return colon == std::string_view::npos ? std::string_view{}
                                           : example.substr(colon + 1, example.find('=') - colon - 1);
  }
};

constexpr std::array kinds = std::to_array<Kind>({
    {"hertz", [](double) { return hertz(); }},
    {"uniform", [](double) { return uniform(); }},
    {"parabolic", [](double) { return parabolic(); }},
    {"flat-punch", [](double) { return flat_punch(); }},
    {"cone", [](double) { return cone(); }},
    {"uniform-wear", [](double) { return uniform_wear(); }},
    {"power:n=2.3", power},
    {"xydas-kao:k=3", xydas_kao},
    {"gaussian:sigma=0.4", gaussian},
});

constexpr std::string_view mixture_example = "mix:0.7*hertz+0.3*uniform";

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
  const auto [name, rest] = split_description(text);
  if (name == "mix") return parse_mixture(text, rest.value_or(""));
  std::string expected = "expected one of";
  std::vector<std::string_view> names{"samples", "mix"};
  for (const Kind& kind : kinds) {
    expected.append(" ").append(kind.example);
    names.push_back(kind.name());
    if (kind.name() != name) continue;
    double value = 0.0;
    if (!kind.parameter().empty()) {
      read_key_values(rest.value_or(""), {number_key(kind.parameter(), value)});
    } else if (rest) {
      const std::string key(rest->substr(0, rest->find('=')));
      throw std::invalid_argument(std::string(name) + " has no parameter" + (key.empty() ? "" : " '" + key + "'") +
                                  ", expected " + std::string(name) + "; the contact radius is that of the radius law");
    }
    return kind.make(value);
  }
  expected.append(" ")
      .append(mixture_example)
      .append("; where files are read, also samples:FILE.csv (radius,pressure)");
  throw complaint(text, expected + did_you_mean(name, names, text.substr(name.size())));
}

}  // namespace

std::span<const std::string_view> law_examples() {
  static constexpr auto examples = [] {
    std::array<std::string_view, kinds.size() + 1> all{};
    for (std::size_t i = 0; i < kinds.size(); ++i) all[i] = kinds[i].example;
    all.back() = mixture_example;
    return all;
  }();
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
