// SPDX-License-Identifier: MIT
#include "fit/model_fit.hpp"

#include "cli/commands/subcommands.hpp"
#include "cli/io/descriptor.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/io/slip_samples.hpp"
#include "cli/io/unit_checks.hpp"

#include "limitcurve/internal/number.hpp"
#include "limitcurve/internal/shell_word.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace limitcurve::cli {

namespace {

const std::vector<std::string> models{"ellipse", "ratio", "law", "load", "friction"};
const std::vector<std::string> criteria{"intercepts", "least-squares", "minimax", "inner"};
const std::vector<std::string> losses{"squared", "huber", "cauchy"};
const std::vector<std::string> load_models{"linear", "hertz", "power", "best"};

class Fit final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {
        "fit", "Fits a friction model to measured slips, or an approximation to the exact curve",
        "Models, and the CSV columns that --data must have:\n"
        "ellipse: the nearest ellipse, to slips load,force,moment[,sigma_force,sigma_moment] [N, N, N m] or, with "
        "--law and no data,\n"
        "to the exact unit curve.\n"
        "ratio: mu, mu_r and the contact radius that they imply under --law (default hertz), from slips; or, from "
        "published\n"
        "ratio,ratio_sd[,n] of several materials (mean and standard deviation [m] of n measurements), their weighted "
        "mean and a test\n"
        "whether one ratio explains them: chi_squared, degrees_of_freedom, p_value (the probability of more scatter). "
        "Without n:\n"
        "chi_squared_per_n, and n_for_p_0.05, the n from which one ratio is rejected.\n"
        "law: the same for --law, or for whichever law explains the slips best.\n"
        "load: a(P) or mu_r(P) = c P^gamma, from load,radius[,sigma_radius] or load,moment[,sigma_moment].\n"
        "friction: the coefficient of a contact that is not round (--patch, see 'limitcurve patch'), from pushes that "
        "slid:\n"
        "force_x,force_y,moment,dx,dy,dtheta about the patch's origin [N, N m, m, rad]. mu is the mean of power over "
        "H; drift is the\n"
        "slope of power over H against the rotation share |w| m0/sqrt(v^2 + w^2 m0^2), divided by the mean: 0 if the "
        "patch explains\n"
        "the pushes. Direction errors bias mu low: 20 % cost 1 %. mu_ellipsoid and drift_ellipsoid use the ellipsoid\n"
        "sqrt(v^2 + m0^2 w^2) instead of H.\n"
        "Columns: parameter, value, std_error (empty without data: a curve has no noise), unit, note (model and "
        "assumptions).\n"
        "Warnings go to standard error; its last line has the replay options and FingerParameters fields to use, "
        "unless the data\n"
        "reject the model.",
        "limitcurve fit ellipse --law hertz"};
  }

  void declare(Options& options) override {
    options.choice("MODEL", model_, models, "What to fit", Presence::required);
    options.text("--data", data_, "FILE", "CSV of measurements, or - for standard input");
    options.file_columns(file_columns_);
    options.least_load(file_columns_);
    options.law(law_, Presence::optional);
    options.text("--patch", patch_, "PATCH", "For friction: the pressure patch");
    options.number("--load", load_, positive, "For friction: normal load P [N]; without it mu is mu P [N]");
    options.choice("--criterion", criterion_, criteria, "What an approximation of the exact curve minimises");
    options.choice("--loss", loss_, losses, "Loss function: the weight of outliers");
    options.choice("--load-model", load_model_, load_models,
                   "For load: growth of the radius, c P^gamma with gamma 0, 1/3 or free; or the best of them");
    options.number("--gamma", settings_.gamma, finite, "Exponent of the contact radius a = c P^gamma, from -0.5 to 1");
    options.flag("--fit-gamma", settings_.fit_gamma, "Fit gamma to the data, too");
    options.flag("--covariance", covariance_, "With --data: add a column covariance_NAME for each parameter");
    options.flag("--residuals", residuals_,
                 "Write, instead of the parameters, one column: by how many standard deviations each slip lies outside "
                 "the fitted curve");
    options.number("--largest-radius", settings_.largest_radius, positive, "Warn of a contact radius above this [m]");
  }

  void run(const Results& results) override {
    messages_ = results.messages;
    file_columns_.messages = messages_;
    if (law_ != nullptr) messages_->say(law_->remarks());
    if (data_.empty() && (file_columns_.given() || file_columns_.least_load))
      throw std::invalid_argument("--columns, --units, --least-load: go with --data");
    if (covariance_ && (data_.empty() || models[model_] == "friction"))
      throw std::invalid_argument("--covariance: only with --data, and not for fit friction");
    if (residuals_ && (data_.empty() || (models[model_] != "law" && models[model_] != "ellipse")))
      throw std::invalid_argument("--residuals: only for a curve that is fitted to the slips of --data, got fit " +
                                  models[model_]);
    tell_idle();
    if (models[model_] == "friction") {
      const fit::FrictionFit found = friction();
      return write(results, found.estimates, patch_ + found.note);
    }
    if (!patch_.empty()) throw std::invalid_argument("--patch: only for fit friction, got fit " + models[model_]);
    if (load_) throw std::invalid_argument("--load: only for fit friction, got fit " + models[model_]);
    const fit::ModelFit found = data_.empty() ? curve_fit() : data_fit();
    if (found.model != models[model_]) say("note", "the model is " + found.model);
    describe(found);
    for (const std::string& warning : found.report.warnings) say("warning", warning);
    warn_of_units(found.report);
    if (!found.report.converged) throw std::runtime_error("the fit did not converge: " + found.report.message);
    if (residuals_) {
      write_residuals(results, found.residuals);
    } else {
      write(results, found.report.estimates, found.report.note, covariance_ ? &found.report.correlation : nullptr);
    }
    if (!data_.empty()) suggest_parameters(found);
  }

 private:
  /// With correlations also the covariances.
  static void write(const Results& results, const std::vector<fit::Estimate>& estimates, const std::string& note,
                    const std::vector<double>* correlation = nullptr) {
    std::vector<std::string> columns{"parameter", "value", "std_error", "unit", "note"};
    if (correlation != nullptr) {
      for (const fit::Estimate& estimate : estimates) columns.push_back("covariance_" + estimate.name);
    }
    Rows rows(results, columns);
    for (std::size_t i = 0; i < estimates.size(); ++i) {
      const fit::Estimate& estimate = estimates[i];
      rows.row_by([&](const auto& cell) {
        cell(estimate.name);
        cell(estimate.value);
        cell(std::isnan(estimate.std_error) ? std::nullopt : std::optional(estimate.std_error));
        cell(estimate.unit);
        cell(note);
        for (std::size_t j = 0; correlation != nullptr && j < estimates.size(); ++j)
          cell((*correlation)[i * estimates.size() + j] * (estimate.std_error * estimates[j].std_error));
      });
    }
    rows.finish();
  }

  static void write_residuals(const Results& results, const std::vector<double>& residuals) {
    Rows rows(results, {"residual"});
    for (const double residual : residuals) rows.row(residual);
    rows.finish();
  }

  [[nodiscard]] fit::FrictionFit friction() {
    if (patch_.empty()) throw std::invalid_argument("--patch is required to fit 'friction'");
    if (data_.empty()) throw std::invalid_argument("--data is required to fit 'friction'");
    const Patch patch = read_patch(patch_, *messages_);
    if (load_) {
      *load_ *= file_columns_.force;
      UnitChecks questions;
      questions.load(*load_);
      messages_->say(questions.lines());
    }
    const std::vector<fit::Push> pushes = read_pushes(data_, file_columns_);
    try {
      fit::FrictionFit found = fit::fit_friction(patch, pushes, load_.value_or(1.0), load_ ? "1" : "N");
      for (const std::string& warning : found.warnings) say("warning", warning);
      return found;
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument((data_ == "-" ? "standard input" : data_) + ": " + error.what());
    }
  }

  /// Says which options change nothing.
  void tell_idle() const {
    const std::string& model = models[model_];
    const bool has_data = !data_.empty();
    const bool of_slips = has_data && model != "load" && model != "friction";
    std::string idle;
    const auto ask = [&](const char* option, bool given, bool used) {
      if (given && !used) idle += (idle.empty() ? "" : ", ") + std::string(option);
    };
    ask("--law", law_ != nullptr, !has_data || model == "law" || model == "ratio");
    ask("--criterion", criterion_ != 1, !has_data);
    ask("--loss", loss_ != 0, has_data && model != "friction");
    ask("--gamma", settings_.gamma != 0.0, of_slips);
    ask("--fit-gamma", settings_.fit_gamma, of_slips);
    ask("--load-model", load_model_ != 2, model == "load");
    ask("--largest-radius", settings_.largest_radius != fit::ContactFitOptions{}.largest_radius,
        of_slips && model != "ellipse");
    if (!idle.empty()) say("warning", idle + ": without effect on fit " + model + (has_data ? "" : " without --data"));
  }

  /// A note or warning that the user must know before using the numbers.
  void say(const char* kind, const std::string& text) const {
    messages_->say("limitcurve: " + std::string(kind) + ": " + text);
  }

  /// A radius above 0.1 m (c is the radius at 1 N) suggests data in millimetres.
  void warn_of_units(const fit::FitReport& report) const {
    constexpr double largest_radius = 0.1;
    for (const fit::Estimate& estimate : report.estimates) {
      if ((estimate.name != "radius" && estimate.name != "c") || !(estimate.value > largest_radius)) continue;
      say("warning",
          estimate.name + " = " + format_number(estimate.value, 3) + " " + estimate.unit + ": are the data in metres?");
    }
  }

  /// Quality of the fit.
  void describe(const fit::ModelFit& found) const {
    const fit::FitReport& report = found.report;
    std::string text = std::to_string(report.residuals) + " residuals, " + std::to_string(report.free_parameters) +
                       " free parameters, rms " + format_number(report.rms, 3) + "; ";
    if (found.error) {
      text += "too strong by up to " + format_number(found.error->max_over_estimate, 3) + ", too weak by up to " +
              format_number(found.error->max_under_estimate, 3) + ", its centre of rotation off by up to " +
              format_number(found.error->max_cor_error, 3) + "; ";
    }
    say("note", text + report.message);
  }

  static constexpr int digits = 6;  ///< of a suggested parameter

  /// The fitted finger as options of replay and as fields of FingerParameters.
  void suggest_parameters(const fit::ModelFit& found) const {
    const std::vector<fit::Estimate>& estimates = found.report.estimates;
    const auto value = [&](const std::string& name, double otherwise) {
      for (const fit::Estimate& estimate : estimates) {
        if (estimate.name == name) return estimate.value;
      }
      return otherwise;
    };
    if (estimates.front().name == "ratio") return;  // without mu there is no finger
    const bool follows_outliers = found.report.scatter_refused && loss_ == 0;
    if (models[model_] == "law" && (found.report.gamma_refused || follows_outliers)) {
      return say("note", std::string("no parameters suggested: the data reject this model; add") +
                             (found.report.gamma_refused ? " --fit-gamma" : "") +
                             (follows_outliers ? " --loss cauchy" : ""));
    }
    const double gamma = value("gamma", settings_.gamma);
    const std::string growth = format_number(gamma, digits);
    // FingerParameters accepts no other exponent.
    if (!(gamma >= -0.5 && gamma <= 1.0)) return;
    if (estimates.front().name == "c") {
      const std::string c = format_number(estimates.front().value, digits);
      if (gamma >= 0.0) {
        say("note", "for replay: --radius-law power:c=" + c + ",gamma=" + growth +
                        "; for FingerParameters: .radius_law = RadiusLaw::power(" + c + ", " + growth + ")");
      }
      return;
    }
    std::string options;
    std::string fields;
    const auto add = [&](const char* option, const char* field, const std::string& text) {
      options += std::string(" --") + option + " " + text;
      fields += (fields.empty() ? "." : ", .") + std::string(field) + " = " + text;
    };
    const std::string law = law_of(found);
    if (!law.empty()) options = " --law " + shell_word(law);
    if (found.model == "ellipse") options = " --curve ellipse";
    const bool of_load = estimates.front().name == "mu_r";
    if (!of_load) add("mu", "mu", format_number(estimates[0].value, digits));
    add("mu-r", "mu_r", format_number(estimates[of_load ? 0 : 1].value, digits));
    if (gamma != 0.0) add("gamma", "gamma", growth);
    if (!of_load && (!law.empty() || found.model == "ellipse") && std::filesystem::exists(descriptor::path_of(data_))) {
      say("note", "for the load that would hold each row: limitcurve hold" + options + " --data " + shell_word(data_) +
                      file_columns_.options +
                      (file_columns_.least_load ? " --least-load " + format_number(*file_columns_.least_load) : ""));
    }
    say("note", "for replay:" + options + "; for FingerParameters: " + fields);
  }

  /// The law as a value of --law; "" if the curve belongs to no law or its shape is unknown.
  [[nodiscard]] static std::string law_of(const fit::ModelFit& found) {
    for (const fit::Estimate& estimate : found.report.estimates) {
      if (estimate.name == "n" || estimate.name == "k") {
        return std::isfinite(estimate.value)
                   ? found.model + ":" + estimate.name + "=" + format_number(estimate.value, digits)
                   : "";
      }
    }
    return found.report.estimates.front().name == "mu" ? found.model : "";
  }

  [[nodiscard]] fit::ModelFit curve_fit() const {
    if (models[model_] != "ellipse") throw std::invalid_argument("--data is required to fit '" + models[model_] + "'");
    if (law_ == nullptr)
      throw std::invalid_argument("--data or --law is required, to fit to measurements or to the exact curve");
    return fit::fit_model(models[model_], law_, static_cast<fit::Criterion>(criterion_));
  }

  [[nodiscard]] fit::ModelFit data_fit() {
    settings_.loss = loss_ == 0 ? fit::Loss::squared() : loss_ == 1 ? fit::Loss::huber() : fit::Loss::cauchy();
    if (models[model_] == "ratio") return ratio_fit();
    if (models[model_] == "law" && law_ == nullptr) return law_fit(asked(read_slip_samples(data_, file_columns_)));
    if (models[model_] != "load")
      return fit::fit_model(models[model_], asked(read_slip_samples(data_, file_columns_)), law_, settings_);
    return load_fit(read_load_samples(data_, file_columns_));
  }

  /// The same slips, after the questions about their units: the fit itself may fail.
  [[nodiscard]] const std::vector<fit::Sample>& asked(const std::vector<fit::Sample>& slips) const {
    UnitChecks questions;
    for (const fit::Sample& slip : slips) {
      questions.load(slip.load);
      questions.wrench(slip.force, slip.moment);
      questions.force_under(slip.load, slip.force);
    }
    messages_->say(questions.lines());
    return slips;
  }

  [[nodiscard]] fit::ModelFit ratio_fit() const {
    const auto data = read_ratio_data(data_, file_columns_);
    if (const auto* slips = std::get_if<std::vector<fit::Sample>>(&data))
      return fit::fit_model("ratio", asked(*slips), law_, settings_);
    if (loss_ != 0)
      throw std::invalid_argument("--loss: published ratios are averaged, expected squared, got " + losses[loss_]);
    return fit::fit_model("ratio", std::get<std::vector<fit::RatioSample>>(data), law_);
  }

  [[nodiscard]] fit::ModelFit law_fit(const std::vector<fit::Sample>& samples) const {
    fit::LawSelection selection = fit::select_law(samples, settings_);
    for (std::size_t i = 0; i < selection.candidates.size(); ++i) {
      say("note",
          selection.candidates[i].model + ": AIC " + format_number(selection.aic_difference[i], 3) + " above the best");
    }
    fit::ContactFit& best = selection.candidates.front();
    return {best.model, std::move(best.report), std::nullopt, std::move(best.residuals)};
  }

  [[nodiscard]] fit::ModelFit load_fit(const fit::LoadSamples& samples) const {
    UnitChecks questions;
    for (const auto& sample : samples.samples) questions.load(sample.load);
    messages_->say(questions.lines());
    const std::string& wanted = load_models[load_model_];
    if (wanted == "linear" || wanted == "hertz") {
      const auto model = wanted == "linear" ? fit::LoadModel::linear : fit::LoadModel::hertz;
      return {"load", fit::fit_load(samples, model, settings_.loss).report, std::nullopt};
    }
    const fit::LoadSelection selection = fit::select_load(samples, settings_.loss);
    for (std::size_t i = 0; i < selection.candidates.size(); ++i) {
      say("note", std::string(fit::to_string(selection.candidates[i].model)) + ": AIC " +
                      format_number(selection.aic_difference[i], 3) + " above the best");
    }
    if (wanted == "best") return {"load", selection.candidates.front().report, std::nullopt};
    return {"load", fit::fit_load(samples, fit::LoadModel::power, settings_.loss).report, std::nullopt};
  }

  std::size_t model_ = 0;
  std::string data_;
  FileColumns file_columns_;
  std::string patch_;
  std::optional<double> load_;
  Law law_;
  std::size_t criterion_ = 1;
  std::size_t loss_ = 0;
  std::size_t load_model_ = 2;
  Messages* messages_ = nullptr;
  bool covariance_ = false;
  bool residuals_ = false;
  fit::ContactFitOptions settings_;
};

}  // namespace

std::unique_ptr<Subcommand> make_fit() {
  return std::make_unique<Fit>();
}

}  // namespace limitcurve::cli
