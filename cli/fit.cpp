// SPDX-License-Identifier: MIT
#include "fit/model_fit.hpp"

#include "cli/csv_reader.hpp"
#include "cli/subcommands.hpp"

#include "limitcurve/number.hpp"

#include <cstdio>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

const std::vector<std::string> models{"ellipse", "superellipse", "quartic", "ratio", "law", "load"};
constexpr std::size_t last_of_a_curve = 2;
const std::vector<std::string> criteria{"intercepts", "least-squares", "minimax", "inner", "outer"};
const std::vector<std::string> losses{"squared", "huber", "cauchy"};
const std::vector<std::string> load_models{"linear", "hertz", "power", "best"};

std::vector<fit::Sample> read_samples(const std::string& file) {
  CsvReader reader(file, {"load", "force", "moment"}, {"sigma_force", "sigma_moment"});
  if (reader.has(3) != reader.has(4)) {
    throw std::invalid_argument(file + ": got one of the columns sigma_force and sigma_moment, expected both or none");
  }
  std::vector<fit::Sample> samples;
  while (reader.next()) {
    fit::Sample sample{reader.number(0, positive), reader.number(1, finite), reader.number(2, finite)};
    if (reader.has(3)) {
      sample.sigma_force = reader.number(3, positive);
      sample.sigma_moment = reader.number(4, positive);
    }
    samples.push_back(sample);
  }
  return samples;
}

fit::LoadSamples read_load_samples(const std::string& file) {
  CsvReader reader(file, {"load"}, {"radius", "moment", "sigma_radius", "sigma_moment"});
  if (reader.has(1) == reader.has(2)) throw std::invalid_argument(file + ": expected one of the columns radius and moment beside load");
  const std::size_t value = reader.has(1) ? 1 : 2;
  const std::size_t sigma = value + 2;
  fit::LoadSamples samples{value == 1 ? fit::LoadSamples::Quantity::radius : fit::LoadSamples::Quantity::moment, {}};
  while (reader.next()) {
    samples.samples.push_back(
        {reader.number(0, positive), reader.number(value, positive), reader.has(sigma) ? reader.number(sigma, positive) : 0.0});
  }
  return samples;
}

/// What a reader must know before using the numbers.
void say(const char* kind, const std::string& text) {
  std::fprintf(stderr, "limitcurve: %s: %s\n", kind, text.c_str());
}

class Fit final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"fit", "Fits a friction model to measured slips, or an approximation to the exact curve",
            "With --data, a CSV of slips: load,force,moment[,sigma_force,sigma_moment] [N, N, N m]. With --law and no data,\n"
            "ellipse, superellipse and quartic are laid over the exact unit curve instead.\n"
            "ratio gives mu, mu_r and the contact radius they imply under --law (hertz if left out); law gives those of the\n"
            "pressure law that explains the data best, or of --law; load fits a(P) or mu_r(P) = c P^gamma to a CSV of\n"
            "load,radius[,sigma_radius] or load,moment[,sigma_moment]. What to beware of is told on standard error.\n"
            "Columns: parameter, value, std_error, unit.",
            "limitcurve fit ellipse --law hertz"};
  }

  void declare(Options& options) override {
    options.choice("MODEL", model_, models, "What to fit", Presence::required);
    options.text("--data", data_, "FILE", "CSV of measurements, or - for standard input");
    options.law(law_, Presence::optional);
    options.choice("--criterion", criterion_, criteria, "Of an approximation to the exact curve: what is least");
    options.choice("--loss", loss_, losses, "How hard outliers of the data pull");
    options.choice("--load-model", load_model_, load_models,
                   "For load: how the radius grows, c P^gamma with gamma 0, 1/3, free; or the best");
    options.number("--gamma", settings_.gamma, non_negative, "Exponent of the contact radius a = c P^gamma");
    options.flag("--fit-gamma", settings_.fit_gamma, "Find gamma from the data too");
    options.number("--largest-radius", settings_.largest_radius, positive, "Warn of a contact radius beyond this [m]");
  }

  void run(const Results& results) override {
    const fit::ModelFit found = data_.empty() ? curve_fit() : data_fit();
    if (found.model != models[model_]) say("note", "the model is " + found.model);
    for (const std::string& warning : found.report.warnings) say("warning", warning);
    if (!found.report.converged) throw std::runtime_error("the fit did not converge: " + found.report.message);
    Rows rows(results, {"parameter", "value", "std_error", "unit"});
    for (const fit::Estimate& estimate : found.report.estimates) {
      rows.row(estimate.name, estimate.value, estimate.std_error, estimate.unit);
    }
    rows.finish();
  }

 private:
  [[nodiscard]] fit::ModelFit curve_fit() const {
    if (model_ > last_of_a_curve) throw std::invalid_argument("--data is required to fit '" + models[model_] + "'");
    if (law_ == nullptr) throw std::invalid_argument("--data or --law is required, to fit to measurements or to the exact curve");
    return fit::fit_model(models[model_], law_, static_cast<fit::Criterion>(criterion_));
  }

  [[nodiscard]] fit::ModelFit data_fit() {
    settings_.loss = loss_ == 0 ? fit::Loss::squared() : loss_ == 1 ? fit::Loss::huber() : fit::Loss::cauchy();
    if (models[model_] != "load") return fit::fit_model(models[model_], read_samples(data_), law_, settings_);
    return load_fit(read_load_samples(data_));
  }

  [[nodiscard]] fit::ModelFit load_fit(const fit::LoadSamples& samples) const {
    const std::string& wanted = load_models[load_model_];
    if (wanted == "linear" || wanted == "hertz") {
      const auto model = wanted == "linear" ? fit::LoadModel::linear : fit::LoadModel::hertz;
      return {"load", fit::fit_load(samples, model, settings_.loss).report, std::nullopt};
    }
    const fit::LoadSelection selection = fit::select_load(samples, settings_.loss);
    for (std::size_t i = 0; i < selection.candidates.size(); ++i) {
      say("note", std::string(fit::to_string(selection.candidates[i].model)) + ": AICc " + format_number(selection.aic_difference[i]) +
                      " above the best");
    }
    for (const fit::LoadFit& candidate : selection.candidates) {
      if (wanted == "best" || candidate.model == fit::LoadModel::power) return {"load", candidate.report, std::nullopt};
    }
    throw std::logic_error("no power law among the fits to loads");
  }

  std::size_t model_ = 0;
  std::string data_;
  Law law_;
  std::size_t criterion_ = 1;
  std::size_t loss_ = 0;
  std::size_t load_model_ = 2;
  fit::ContactFitOptions settings_;
};

}  // namespace

std::unique_ptr<Subcommand> make_fit() {
  return std::make_unique<Fit>();
}

}  // namespace limitcurve::cli
