// SPDX-License-Identifier: MIT
#include "cli/io/law_argument.hpp"

#include "cli/io/csv_reader.hpp"

#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace limitcurve::cli {

namespace {

/// FILE of a text KIND:FILE; nothing if the text is of another kind.
std::optional<std::string> measured_file(const std::string& text, const std::string& kind) {
  if (text == kind || text == kind + ":") throw std::invalid_argument("'" + text + "': no file, expected " + kind + ":FILE.csv");
  if (!text.starts_with(kind + ":")) return std::nullopt;
  return text.substr(kind.size() + 1);
}

/// Reads samples from a file with the columns load and `value`.
std::vector<LoadSample> read_load_samples(const std::string& file, const char* value) {
  std::vector<LoadSample> samples;
  CsvReader reader(file, {"load", value});
  while (reader.next()) samples.push_back({reader.number(0, positive), reader.number(1, positive)});
  return samples;
}

/// Calls `make` and adds the file's name to its errors.
template <class Make>
auto made_of(const std::string& file, const Make& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(file + ": " + error.what());
  }
}

}  // namespace

Law read_law(const std::string& text) {
  std::vector<PressureSample> profile;
  return read_law(text, profile);
}

Law read_law(const std::string& text, std::vector<PressureSample>& profile) {
  if (const auto file = measured_file(text, "samples")) {
    CsvReader reader(*file, {"radius", "pressure"});
    while (reader.next()) profile.push_back({reader.number(0, non_negative), reader.number(1, finite)});
  }
  return law_of(text, profile);
}

Law law_of(const std::string& text, const std::vector<PressureSample>& profile) {
  const auto file = measured_file(text, "samples");
  return file ? made_of(*file, [&] { return samples(profile, *file); }) : parse_law(text);
}

RadiusLawArgument::RadiusLawArgument(std::string text, std::vector<LoadSample> rows) : text_(std::move(text)), rows_(std::move(rows)) {
  if (measured_file(text_, "moments")) return;
  const auto file = measured_file(text_, "samples");
  law_ = file ? made_of(*file, [&] { return RadiusLaw::sampled(rows_); }) : RadiusLaw::parse(text_);
}

RadiusLaw RadiusLawArgument::of(double mu, const Law& law) const {
  return law_ ? *law_ : of(mu, law->moment_ratio());
}

RadiusLaw RadiusLawArgument::of(double mu, double moment_ratio) const {
  if (law_) return *law_;
  return made_of(*measured_file(text_, "moments") + ": as radii, a = moment/(m0 mu load)",
                 [&] { return RadiusLaw::of_moments(rows_, mu, moment_ratio); });
}

RadiusLawArgument read_radius_law(const std::string& text) {
  if (const auto file = measured_file(text, "moments")) return {text, read_load_samples(*file, "moment")};
  if (const auto file = measured_file(text, "samples")) return {text, read_load_samples(*file, "radius")};
  return {text, {}};
}

void MomentArgument::check() const {
  if (radius_law && mu_r) throw std::invalid_argument("--mu-r: not with --radius-law, expected one of them");
  if (!radius_law && !mu_r) throw std::invalid_argument("--radius-law is required, or --mu-r in its place");
  if (gamma && !mu_r) throw std::invalid_argument("--gamma: goes with --mu-r");
}

ContactFriction MomentArgument::with(double mu, const Law& law) const {
  check();
  ContactFriction contact{.mu = mu, .mu_r = mu_r, .gamma = gamma.value_or(0.0)};
  if (radius_law) contact.radius_law = radius_law->of(mu, law);
  return contact;
}

}  // namespace limitcurve::cli
