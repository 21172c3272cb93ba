// SPDX-License-Identifier: MIT
#include "cli/io/law_argument.hpp"
#include "tests/fuzz/honest_law.hpp"

using namespace limitcurve;

/// Measured profiles, `samples:FILE` of a pressure law and of a radius law: a complaint that names the file, or an
/// honest law.
static const fuzz::Target samples_target("samples", [](std::string_view text) {
  static fuzz::TemporaryFile file;
  file.replace(text);
  const std::string argument = "samples:" + file.path();
  const auto is_refused = [&](const std::optional<std::string>& complaint) {
    fuzz::require(!complaint || complaint->find(file.path()) != std::string::npos,
                  "a complaint that does not name the file");
    return complaint.has_value();
  };

  Law law;
  if (!is_refused(fuzz::complaint_of([&] { law = cli::read_law(argument); }))) fuzz::require_honest(*law, text);

  std::optional<RadiusLaw> radius_law;
  if (is_refused(fuzz::complaint_of([&] { radius_law = cli::read_radius_law(argument).of(0.6, 0.59); }))) return;
  for (const double load : {1e-3, 1.0, 7.0, 1e3}) {
    fuzz::require(radius_law->radius(load) >= 0.0, "a radius below 0 or NaN");
    fuzz::require(radius_law->load_of_product(load) >= 0.0, "a load below 0 or NaN");
  }
});
