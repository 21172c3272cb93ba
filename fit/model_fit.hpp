// SPDX-License-Identifier: MIT
#pragma once

#include "contact_fit.hpp"
#include "curve_fit.hpp"
#include "friction_fit.hpp"
#include "load_fit.hpp"
#include "ratio_fit.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// Every fit by one function, with the same defaults in each language and on the command line.
namespace limitcurve::fit {

/// What to fit, and the data that it takes.
enum class Kind {
  ellipse,  ///< the nearest ellipse, to slips or to the exact curve of a law
  ratio,    ///< mu, mu_r and the radius that they imply under the law, from slips or from published ratios
  law,      ///< as ratio, for the law of the options, otherwise for the law that explains the slips best
  load,     ///< a(P) or mu_r(P), from radii or moments at several loads
  friction  ///< mu of a patch, from pushes
};

/// In the order of Kind.
inline constexpr std::array<std::string_view, 5> kind_names{"ellipse", "ratio", "law", "load", "friction"};
/// Throws std::invalid_argument that lists the names.
Kind parse_kind(std::string_view text);

/// Pushes of a patch. The patch and the pushes must outlive this view.
struct Pushes {
  const Patch& patch;
  std::span<const Push> pushes;
  std::optional<double> load;  ///< P [N]; if absent, mu is mu P [N]
};

using Data = std::variant<Law, std::span<const Sample>, std::span<const RatioSample>, LoadSamples, Pushes>;

struct FitOptions : ContactFitOptions {
  Law law;                                         ///< for ratio (default Hertz) and law
  Criterion criterion = Criterion::least_squares;  ///< for ellipse, to the curve of a law
  LoadModel load_model = LoadModel::power;         ///< for load
};

/// The result of a fit of any kind: `report.estimates` are the rows parameter, value, std_error, unit.
struct ModelFit {
  std::string model;  ///< the fitted model, or the best model
  FitReport report;
  std::optional<CurveError> error;  ///< against the exact curve, for fits to a law
  /// For fits to slips: distance of each sample from the curve in standard deviations, positive outside.
  std::vector<double> residuals = {};
  /// The models that were compared, best first, and their AIC minus the AIC of the best; empty if nothing was compared.
  std::vector<std::pair<std::string, double>> candidates = {};
};

/// Fits any kind. The exponent of `load` is free unless `load_model` says otherwise. Options of other kinds or data
/// have no effect. Throws std::invalid_argument for data of another kind, and what the fit can throw.
ModelFit fit(Kind kind, const Data& data, const FitOptions& options = {});

}  // namespace limitcurve::fit
