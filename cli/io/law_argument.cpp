// SPDX-License-Identifier: MIT
#include "cli/io/law_argument.hpp"

#include "cli/io/argument_parts.hpp"
#include "cli/io/csv_reader.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/measured/own_radii.hpp"
#include "limitcurve/pressure_law.hpp"

#include <stdexcept>
#include <string_view>

namespace limitcurve::cli {

namespace {

/// FILE of a text KIND:FILE; nothing if the text is of another kind.
std::optional<std::string> measured_file(const std::string& text, const std::string& kind) {
  if (text == kind || text == kind + ":")
    throw std::invalid_argument("'" + text + "': no file, expected " + kind + ":FILE.csv");
  if (!text.starts_with(kind + ":")) return std::nullopt;
  return text.substr(kind.size() + 1);
}

/// The file of a law `samples:FILE.csv[,rim=RADIUS]`, and the rim, 0 if it names none; nothing for a law of another
/// kind.
std::optional<std::pair<std::string, double>> measured_profile(const std::string& text) {
  const auto rest = measured_file(text, "samples");
  if (!rest) return std::nullopt;
  std::string_view items;
  std::string file = split_file("samples", *rest, items);
  double rim = 0.0;
  read_key_values(items, {number_key("rim", rim, positive, false)});
  return std::pair(std::move(file), rim);
}

/// Reads samples from a file with the columns load and `value`.
std::vector<LoadSample> read_load_samples(const std::string& file, const char* value) {
  std::vector<LoadSample> samples;
  CsvReader reader(file, {"load", value});
  while (reader.next()) samples.push_back({reader.number(0, positive), reader.number(1, positive)});
  return samples;
}

/// Calls `make` and adds the place in the file to its errors.
template <class Make>
auto made_of(const std::string& file, const std::vector<std::string>& columns, const Make& make,
             const std::string& how = {}) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(place_of(file, columns, error.what()) + how + error.what());
  }
}

}  // namespace

Law read_law(const std::string& text) {
  std::vector<PressureSample> profile;
  return read_law(text, profile);
}

Law read_law(const std::string& text, std::vector<PressureSample>& profile) {
  if (const auto measured = measured_profile(text)) {
    CsvReader reader(measured->first, {"radius", "pressure"});
    while (reader.next()) profile.push_back({reader.number(0, non_negative), reader.number(1, finite)});
  }
  return law_of(text, profile);
}

Law law_of(const std::string& text, const std::vector<PressureSample>& profile) {
  const auto measured = measured_profile(text);
  if (!measured) return parse_law(text);
  const auto& [file, rim] = *measured;
  return made_of(file, {"radius", "pressure"},
                 [&, &name = file, &radius = rim] { return samples(profile, name, radius); });
}

RadiusLawArgument::RadiusLawArgument(std::string text, std::vector<LoadSample> rows)
    : text_(std::move(text)), rows_(std::move(rows)) {
  if (measured_file(text_, "moments")) return;
  const auto file = measured_file(text_, "samples");
  law_ = file ? made_of(*file, {"load", "radius"}, [&] { return RadiusLaw::sampled(rows_); }) : RadiusLaw::parse(text_);
}

RadiusLaw RadiusLawArgument::of(double mu, const Law& law) const {
  return law_ ? *law_ : of(mu, law->moment_ratio());
}

RadiusLaw RadiusLawArgument::of(double mu, double moment_ratio) const {
  if (law_) return *law_;
  return made_of(
      *measured_file(text_, "moments"), {"load", "moment"},
      [&] { return RadiusLaw::of_moments(rows_, mu, moment_ratio); }, "as radii, a = moment/(m0 mu load): ");
}

RadiusLawArgument read_radius_law(const std::string& text) {
  if (const auto file = measured_file(text, "moments")) return {text, read_load_samples(*file, "moment")};
  if (const auto file = measured_file(text, "samples")) return {text, read_load_samples(*file, "radius")};
  return {text, {}};
}

void take_own_radii(std::optional<RadiusLawArgument>& radius_law, bool has_mu_r, Law& law, Messages& messages) {
  if (law == nullptr) return;
  std::vector<std::string> remarks;
  if (!radius_law && !has_mu_r && law->rim() > 0.0) {
    remarks.push_back("note: without --radius-law and --mu-r the radii of " + law->name() +
                      " are the contact's, in metres, at every load");
    law = with_own_radii(law);
    radius_law.emplace("constant:a=" + format_number(law->rim()), std::vector<LoadSample>{});
  }
  messages.say(law->remarks());
  messages.say(remarks);
}

void note_profile_error(const Law& law, Messages& messages) {
  if (law == nullptr || law->profile_error() == 0.0) return;
  const WrenchEstimate spin = law->evaluate(0.0);
  messages.say("limitcurve: note: " + law->name() + ": its largest moment may be off by " +
               format_number(100.0 * spin.error.moment / spin.wrench.moment, 2) +
               " %, because the pressure is known only at samples");
}

void check_moment(bool has_radius_law, bool has_mu_r) {
  if (has_radius_law && has_mu_r)
    throw std::invalid_argument("give --radius-law or --mu-r, not both: each sets the moment limit");
  if (!has_radius_law && !has_mu_r)
    throw std::invalid_argument("the contact needs a size: give --radius-law, such as constant:a=0.006, or --mu-r");
}

void MomentArgument::check(Law& law, Messages& messages) {
  if (law != nullptr) take_own_radii(radius_law, mu_r.has_value(), law, messages);
  check_moment(radius_law.has_value(), mu_r.has_value());
  if (gamma && !mu_r)
    throw std::invalid_argument(
        "--gamma needs --mu-r, of which it is the exponent; for a radius that grows use "
        "--radius-law power:c=0.00207,gamma=0.259");
}

ContactFriction MomentArgument::with(double mu, const Law& law) const {
  ContactFriction contact{.mu = mu, .mu_r = mu_r, .gamma = gamma.value_or(0.0)};
  if (radius_law) contact.radius_law = radius_law->of(mu, law);
  return contact;
}

}  // namespace limitcurve::cli
