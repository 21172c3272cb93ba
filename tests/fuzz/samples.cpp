// SPDX-License-Identifier: MIT
#include "cli/io/law_argument.hpp"
#include "tests/fuzz/honest_law.hpp"

using namespace limitcurve;

/// Measured profiles, `samples:FILE` of a pressure law and of a radius law: a complaint that names the file, or an
/// honest law.
static const fuzz::Target samples_target("samples", [](const std::uint8_t* data, std::size_t size) {
  static fuzz::TemporaryFile file;
  file.replace(fuzz::as_text(data, size));
  const std::string argument = "samples:" + file.path();
  const auto names_file = [&](const std::string& complaint) {
    return complaint.find(file.path()) != std::string::npos;
  };

  Law law;
  const auto refused = fuzz::complaint_of([&] { law = cli::read_law(argument); });
  if (refused) {
    fuzz::require(names_file(*refused), "a complaint that does not name the file");
  } else {
    fuzz::require_honest(*law, fuzz::as_text(data, size));
  }

  std::optional<RadiusLaw> radius_law;
  const auto radius_refused = fuzz::complaint_of([&] { radius_law = cli::read_radius_law(argument).of(0.6, 0.59); });
  if (radius_refused) {
    fuzz::require(names_file(*radius_refused), "a complaint that does not name the file");
  } else {
    for (const double load : {1e-3, 1.0, 7.0, 1e3}) {
      fuzz::require(radius_law->radius(load) >= 0.0, "a radius below 0 or NaN");
      fuzz::require(radius_law->load_of_product(load) >= 0.0, "a load below 0 or NaN");
    }
  }
});
