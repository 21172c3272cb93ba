// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/messages.hpp"

#include "limitcurve/contact/contact_friction.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/measured/samples.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve::cli {

/// Reads a law from a command line: the library's grammar, or `samples:FILE.csv[,rim=RADIUS]`, a measured profile with
/// the columns radius,pressure, and the radius in the file's unit that the contact radius stands for. Throws
/// std::invalid_argument with the place of the error in the text or in the file.
Law read_law(const std::string& text);
/// The same, and the rows of a measured profile; `profile` stays empty for other laws.
Law read_law(const std::string& text, std::vector<PressureSample>& profile);

/// The law that such a text means, with the rows of its profile instead of the file's.
Law law_of(const std::string& text, const std::vector<PressureSample>& profile);

/// A radius law on a command line. Measured moment limits become a radius law once friction and pressure law are known:
/// Γ(P) = m₀ μ P a(P).
class RadiusLawArgument {
 public:
  /// The radius law that a text means, with the rows of its file, if it names one.
  RadiusLawArgument(std::string text, std::vector<LoadSample> rows);

  /// Throws std::invalid_argument with the file's name if its moments give no radius law.
  [[nodiscard]] RadiusLaw of(double mu, const Law& law) const;
  /// The same from the law's m₀.
  [[nodiscard]] RadiusLaw of(double mu, double moment_ratio) const;
  /// Whether it is of measured moments.
  [[nodiscard]] bool sets_moment() const noexcept { return !law_; }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  [[nodiscard]] const std::vector<LoadSample>& rows() const noexcept { return rows_; }

 private:
  std::string text_;
  std::vector<LoadSample> rows_;
  std::optional<RadiusLaw> law_;  ///< nothing for measured moments
};

/// Reads a radius law from a command line: the library's grammar; `samples:FILE.csv`, measured radii with the columns
/// load,radius [N, m]; or `moments:FILE.csv`, measured moment limits with the columns load,moment [N, N m]. Throws like
/// `read_law`.
RadiusLawArgument read_radius_law(const std::string& text);

/// Says a law's remarks. Without radius law and mu_r the radii of a measured profile become the contact's own, in
/// metres, at every load.
void take_own_radii(std::optional<RadiusLawArgument>& radius_law, bool has_mu_r, Law& law, Messages& messages);

/// Notes the error of the largest moment of a law whose pressure is known only at samples.
void note_profile_error(const Law& law, Messages& messages);

/// What to say unless just one of --law and --patch is given.
inline std::string what_contact(bool has_patch, bool takes_curve = false) {
  if (has_patch) return "give --law or --patch, not both: each is the contact";
  return std::string("say which contact: --law, or --patch if it is not round") +
         (takes_curve ? " (--curve ellipse or box with --mu-r needs neither)" : "");
}

/// Throws std::invalid_argument unless just one of --radius-law and --mu-r is given.
void check_moment(bool has_radius_law, bool has_mu_r);

/// The options of a contact's moment: --radius-law, or --mu-r with --gamma in its place.
struct MomentArgument {
  std::optional<RadiusLawArgument> radius_law;
  std::optional<double> mu_r;
  std::optional<double> gamma;

  /// Takes a measured profile's own radii where no option gives a size, and says the law's remarks. Throws
  /// std::invalid_argument with the options, of which one is expected.
  void check(Law& law, Messages& messages);
  [[nodiscard]] bool given() const { return radius_law || mu_r || gamma; }
  /// After `check`.
  [[nodiscard]] ContactFriction with(double mu, const Law& law) const;
};

}  // namespace limitcurve::cli
