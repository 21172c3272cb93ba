// SPDX-License-Identifier: MIT
#include "limitcurve/contact/radius_law.hpp"

#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/key_values.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve {

namespace {

double checked(std::string_view name, double value, std::string_view unit) {
  if (!(value > 0.0 && value <= std::numeric_limits<double>::max()))
    throw out_of_range(name, value, unit, "> 0 and finite");
  return value;
}

/// A kind of radius law: an example of its text, with the one or two keys of its numbers, and how it is made of these.
struct RadiusKind {
  std::string_view example;
  RadiusLaw (*make)(double first, double second);
};

constexpr std::array radius_kinds = std::to_array<RadiusKind>({
    {"constant:a=0.005", [](double radius, double) { return RadiusLaw::constant(radius); }},
    {"hertz:R=0.008,E=2e5", RadiusLaw::hertz},
    {"power:c=0.00207,gamma=0.259", RadiusLaw::power},
});

}  // namespace

/// a = coefficient·P^exponent, for loads from `from_load` on.
struct RadiusLaw::Stretch {
  double from_load;
  double coefficient;
  double exponent;
};

RadiusLaw RadiusLaw::constant(double radius) {
  return {checked("a", radius, "m"), 0.0};
}

RadiusLaw RadiusLaw::hertz(double sphere_radius, double modulus) {
  // The quotient of two valid numbers may overflow or underflow.
  const double ratio = checked("R/E", checked("R", sphere_radius, "m") / checked("E", modulus, "Pa"), "m/Pa");
  return {std::cbrt(0.75 * ratio), 1.0 / 3.0};
}

RadiusLaw RadiusLaw::power(double coefficient, double exponent) {
  if (!(exponent >= 0.0 && exponent <= 1.0)) throw out_of_range("gamma", exponent, "1", "0 <= gamma <= 1");
  return {checked("c", coefficient, "m/N^gamma"), exponent};
}

RadiusLaw RadiusLaw::sampled(std::span<const LoadSample> radii) {
  if (radii.size() < 2)
    throw std::invalid_argument("radius law of " + std::to_string(radii.size()) + " samples: expected at least 2");
  auto stretches = std::make_shared<std::vector<Stretch>>();
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const std::string sample = " of sample " + std::to_string(i + 1);
    checked("load" + sample, radii[i].load, "N");
    checked("value" + sample, radii[i].value, "m or N m");
    if (i == 0) continue;
    const LoadSample& before = radii[i - 1];
    if (!(radii[i].load > before.load))
      throw out_of_range("load" + sample, radii[i].load, "N",
                         "greater than the one before (fit load takes repeated loads)");
    const double ratio = std::log(radii[i].load / before.load);
    double exponent = std::log(radii[i].value / before.value) / ratio;
    // Radii in proportion to the load, as decimals give them: 1 but for their rounding.
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * (1.0 + 1.0 / ratio);
    if (!(exponent > -1.0 && exponent <= 1.0 + rounding))
      throw out_of_range("exponent before sample " + std::to_string(i + 1), exponent, "1", "-1 < gamma <= 1");
    exponent = std::min(exponent, 1.0);
    stretches->push_back({before.load, before.value * std::pow(before.load, -exponent), exponent});
  }
  // The first stretch also holds for every smaller load.
  stretches->front().from_load = 0.0;
  RadiusLaw law(stretches->front().coefficient, stretches->front().exponent);
  law.stretches_ = std::move(stretches);
  law.sampled_loads_ = {radii.front().load, radii.back().load};
  return law;
}

RadiusLaw RadiusLaw::of_moments(std::span<const LoadSample> moments, double mu, double moment_ratio) {
  checked("mu", mu, "1");
  checked("moment_ratio", moment_ratio, "1");
  std::vector<LoadSample> radii;
  for (const LoadSample& sample : moments)
    radii.push_back({sample.load, sample.value / (moment_ratio * mu * sample.load)});
  RadiusLaw law = sampled(radii);
  law.is_of_moments_ = true;
  return law;
}

RadiusLaw RadiusLaw::of_mu_r(double mu_r, double gamma, double mu, double moment_ratio) {
  constexpr double almost_none = 1e-20;
  constexpr double most = 1e200;
  if (!(mu_r >= 0.0 && std::isfinite(mu_r))) throw out_of_range("mu_r", mu_r, "m", ">= 0 and finite");
  if (!(mu > 0.0) && mu_r > 0.0) throw out_of_range("mu_r", mu_r, "m", "0 where mu is 0");
  if (!(gamma >= -0.5 && gamma <= 1.0)) throw out_of_range("gamma", gamma, "1", "-0.5 <= gamma <= 1");
  checked("moment_ratio", moment_ratio, "1");
  RadiusLaw law(mu > 0.0 ? std::clamp(mu_r / (mu * moment_ratio), almost_none, most) : almost_none, gamma);
  law.is_of_moments_ = true;
  return law;
}

double RadiusLaw::sampled_radius(double load) const noexcept {
  const Stretch& stretch = stretch_at(load);
  return stretch.exponent == 0.0 ? stretch.coefficient : stretch.coefficient * std::pow(load, stretch.exponent);
}

double RadiusLaw::exponent(double load) const noexcept {
  return is_sampled() ? stretch_at(load).exponent : exponent_;
}

const RadiusLaw::Stretch& RadiusLaw::stretch_at(double load) const noexcept {
  const auto after = std::upper_bound(stretches_->begin() + 1, stretches_->end(), load,
                                      [](double value, const Stretch& stretch) { return value < stretch.from_load; });
  return *(after - 1);
}

double RadiusLaw::load_of_product(double product) const noexcept {
  const auto load_in = [&](const Stretch& stretch) {
    return std::pow(product / stretch.coefficient, 1.0 / (1.0 + stretch.exponent));
  };
  if (!stretches_) return load_in({0.0, coefficient_, exponent_});
  // P·a(P) rises throughout, because every exponent is above −1.
  const auto after =
      std::upper_bound(stretches_->begin() + 1, stretches_->end(), product, [&](double value, const Stretch& stretch) {
        return value < stretch.from_load * stretch.coefficient * std::pow(stretch.from_load, stretch.exponent);
      });
  return load_in(*(after - 1));
}

std::span<const std::string_view> RadiusLaw::examples() {
  static constexpr auto examples = [] {
    std::array<std::string_view, radius_kinds.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = radius_kinds[i].example;
    return all;
  }();
  return examples;
}

RadiusLaw RadiusLaw::parse(std::string_view text) {
  const auto [name, rest] = split_description(text);
  try {
    std::string expected;
    std::vector<std::string_view> names{"samples", "moments"};
    for (const RadiusKind& kind : radius_kinds) {
      expected.append(kind.example).append(", ");
      names.push_back(split_description(kind.example).kind);
      if (names.back() != name) continue;
      std::array<double, 2> values{};
      std::vector<KeyValue> keys;
      for (std::string_view items = *split_description(kind.example).rest; !items.empty();) {
        keys.push_back(number_key(items.substr(0, items.find('=')), values.at(keys.size())));
        const std::size_t comma = items.find(',');
        items.remove_prefix(comma == std::string_view::npos ? items.size() : comma + 1);
      }
      read_key_values(rest.value_or(""), keys);
      return kind.make(values[0], values[1]);
    }
    expected.resize(expected.size() - 2);
    throw std::invalid_argument(
        "expected " + expected +
        "; where files are read, also samples:FILE.csv (load,radius), moments:FILE.csv (load,moment)" +
        did_you_mean(name, names, text.substr(name.size())));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("radius law '" + std::string(text) + "': " + error.what());
  }
}

}  // namespace limitcurve
