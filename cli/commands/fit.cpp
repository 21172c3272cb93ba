// SPDX-License-Identifier: MIT
#include "fit/model_fit.hpp"

#include "cli/commands/subcommands.hpp"
#include "cli/io/argument_parts.hpp"
#include "cli/io/column_list.hpp"
#include "cli/io/descriptor.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/io/slip_samples.hpp"
#include "cli/io/unit_checks.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

namespace limitcurve::cli {

namespace {

struct Fitted {
  fit::Estimate estimate;
  std::string note;
};

constexpr std::array estimate_columns = std::to_array<ListedColumn<Fitted>>({
    {"parameter", of<&Fitted::estimate, &fit::Estimate::name>, "its name"},
    {"value", of<&Fitted::estimate, &fit::Estimate::value>, "the estimate"},
    {"std_error",
     [](const Fitted& row) -> Cell {
       return std::isnan(row.estimate.std_error) ? std::nullopt : std::optional(row.estimate.std_error);
     },
     "standard error; empty without data, because a curve has no noise"},
    {"unit", of<&Fitted::estimate, &fit::Estimate::unit>, "of value and std_error"},
    {"note", of<&Fitted::note>, "model and assumptions"},
});

class Fit final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"fit", "Fit a friction model to measured slips, or an approximation to the exact curve",
            R"(Models, and the columns that --data must have:
ellipse: the best ellipse, for slips load,force,moment[,sigma_force,sigma_moment] [N, N, N m], or for the exact unit
curve if you give --law without --data.
ratio: mu, mu_r, and the contact radius they imply under --law (default hertz), from slips. Or, from published values
ratio,ratio_sd[,n] of several materials (mean and standard deviation [m] of n measurements), their weighted mean, and
a test whether one ratio explains them all: chi_squared, degrees_of_freedom, p_value (the chance of more scatter).
Without n: chi_squared_per_n, and n_for_p_0.05, the n from which one ratio would be rejected.
law: the same for --law, or for the law that explains the slips best.
load: a(P) or mu_r(P) = c P^gamma, from load,radius[,sigma_radius] or load,moment[,sigma_moment].
friction: mu of a contact that is not round (--patch, see 'limitcurve patch'), from pushes that slid:
force_x,force_y,moment,dx,dy,dtheta about the patch's origin [N, N m, m, rad]. mu is the mean of power/H; H is the
power for mu P = 1. drift is its slope against the rotation share |w| m0/sqrt(v^2 + w^2 m0^2), over the mean: 0 if the
patch explains the pushes. Direction errors bias mu low: 20 % cost 1 %. mu_ellipsoid and drift_ellipsoid use the
ellipsoid sqrt(v^2 + m0^2 w^2) instead of H.
)" + ColumnList(estimate_columns).help() +
                "The last message lists options for replay and fields for FingerParameters, unless the data reject the "
                "model.",
            "limitcurve fit ellipse --law hertz"};
  }

  void declare(Options& options) override {
    options.choice("MODEL", kind_, fit::kind_names, "What to fit: {}", Presence::required);
    options.text("--data", data_, "FILE", "CSV file of measurements, or - for standard input");
    options.file_columns(file_columns_);
    options.least_load(file_columns_);
    options.law(settings_.law, Presence::optional);
    options.text("--patch", patch_, "PATCH", "For friction: the contact that was pushed");
    options.number("--load", load_, positive, "For friction: normal load P [N]; without it the result mu is mu P [N]");
    options.choice("--criterion", settings_.criterion, fit::criterion_names, "For ellipse --law, what to minimise: {}");
    options.choice(
        "--loss", settings_.loss.kind, fit::loss_names,
        "Loss function: {}; huber and cauchy resist outliers. edge is for a log without marks, under a law: rows "
        "may also lie below the limit, so it finds the limits that the wrench reaches and never exceeds");
    options.choice("--load-model", settings_.load_model, fit::load_model_names,
                   "For load: {}; gamma of c P^gamma is 0, 1/3 or free");
    options.number("--gamma", settings_.gamma, finite, "Exponent of the contact radius a = c P^gamma, from -0.5 to 1");
    options.flag("--fit-gamma", settings_.fit_gamma, "Fit gamma to the data as well");
    options.flag("--covariance", covariance_, "With --data: add a column covariance_NAME for each parameter");
    options.flag("--residuals", residuals_,
                 "Print for each slip how many standard deviations it lies outside the curve, and its row in the data, "
                 "instead of the parameters");
    options.number("--largest-radius", settings_.largest_radius, positive,
                   "Warn if the contact radius is larger than this [m]");
  }

  void run(const Results& results) override {
    messages_ = results.messages;
    file_columns_.messages = messages_;
    if (settings_.law != nullptr) messages_->say(settings_.law->remarks());
    settings_.loss = fit::Loss::of(settings_.loss.kind);
    if (data_.empty() && (file_columns_.given() || file_columns_.least_load))
      throw std::invalid_argument("--columns, --units, --least-load need --data");
    file_columns_.check_zero();
    if (covariance_ && (data_.empty() || kind_ == fit::Kind::friction))
      throw std::invalid_argument("--covariance needs --data, and a model other than friction");
    if (residuals_ && (data_.empty() || (kind_ != fit::Kind::law && kind_ != fit::Kind::ellipse)))
      throw std::invalid_argument("--residuals needs --data and the model ellipse or law, got fit " + name());
    const bool is_friction = kind_ == fit::Kind::friction;
    if (!is_friction && !patch_.empty())
      throw std::invalid_argument("--patch needs the model friction, got fit " + name());
    if (!is_friction && load_) throw std::invalid_argument("--load needs the model friction, got fit " + name());
    const fit::ModelFit found = this->found();
    warn_idle(results, kind_ == fit::Kind::ratio && found.report.find(fit::Estimate::Role::force) == nullptr);
    for (const auto& [model, difference] : found.candidates)
      say("note", difference > 0.0 ? model + " explains the data worse than the best (AIC " +
                                         format_number(difference, 3) + " higher)"
                                   : model + " explains the data best");
    if (settings_.law == nullptr && kind_ != fit::Kind::load && found.model != name())
      say("note", kind_ == fit::Kind::law
                      ? "the best law is " + found.model
                      : "the fit assumes the pressure law " + found.model + "; for another, add --law");
    if (!is_friction) describe(found);
    for (const std::string& warning : found.report.warnings) say("warning", warning);
    if (is_friction) return write(results, found.report.estimates, patch_ + found.report.note);
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
    const ColumnList list(estimate_columns);
    std::vector<std::string> names = list.names();
    if (correlation != nullptr) {
      for (const fit::Estimate& estimate : estimates) names.push_back("covariance_" + estimate.name);
    }
    Rows rows(results, names);
    for (std::size_t i = 0; i < estimates.size(); ++i) {
      const fit::Estimate& estimate = estimates[i];
      rows.row_by([&](const auto& cell) {
        list.cells({estimate, note}, cell);
        for (std::size_t j = 0; correlation != nullptr && j < estimates.size(); ++j)
          cell((*correlation)[i * estimates.size() + j] * (estimate.std_error * estimates[j].std_error));
      });
    }
    rows.finish();
  }

  void write_residuals(const Results& results, const std::vector<double>& residuals) const {
    Rows rows(results, {"residual", "row"});
    for (std::size_t i = 0; i < residuals.size(); ++i) rows.row(residuals[i], rows_of_data_.at(i));
    rows.finish();
  }

  [[nodiscard]] std::string name() const { return std::string(fit::kind_names[static_cast<std::size_t>(kind_)]); }

  [[nodiscard]] fit::ModelFit friction() {
    if (patch_.empty()) throw std::invalid_argument("--patch is required to fit 'friction'");
    const Patch patch = read_patch(patch_, *messages_);
    if (load_) {
      *load_ *= file_columns_.scale("force");
      UnitChecks questions;
      questions.load(*load_);
      messages_->say(questions.lines());
    }
    const std::vector<fit::Push> pushes = read_pushes(data_, file_columns_);
    try {
      return fit::fit(kind_, fit::Pushes{patch, pushes, load_}, settings_);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument((data_ == "-" ? "standard input" : data_) + ": " + error.what());
    }
  }

  void warn_idle(const Results& results, bool has_ratios) const {
    using fit::Kind;
    const bool has_data = !data_.empty();
    const bool of_slips = has_data && kind_ != Kind::load && kind_ != Kind::friction && !has_ratios;
    results.warn_idle({{"--law", has_data && kind_ != Kind::law && kind_ != Kind::ratio},
                       {"--criterion", has_data},
                       {"--loss", !has_data || kind_ == Kind::friction},
                       {"--gamma", !of_slips},
                       {"--fit-gamma", !of_slips},
                       {"--load-model", kind_ != Kind::load},
                       {"--largest-radius", !of_slips || kind_ == Kind::ellipse}},
                      "fit " + name() + (has_data ? has_ratios ? " of published ratios" : "" : " without --data"));
    const bool grows = settings_.fit_gamma || settings_.gamma != 0.0;
    results.warn_idle({{"--largest-radius", of_slips && kind_ != Kind::ellipse && grows}},
                      "a radius that grows with the load (--gamma, --fit-gamma)");
  }

  /// A note or warning that the user must know before using the numbers.
  void say(const char* kind, std::string text) const {
    const auto put = [&](std::string_view words, std::string_view own) {
      const std::size_t place = text.find(words);
      if (place != std::string::npos) text.replace(place, words.size(), own);
    };
    // Of a file the rows are named by their lines, and the library's advice by the options that follow it.
    if (!data_.empty() && MemoryColumns::find(data_) == nullptr) put("(the first is 1)", "(by line of the file)");
    put("use the loss cauchy", "add --loss cauchy");
    put("fit gamma as well", kind_ == fit::Kind::load ? "add --load-model power" : "add --fit-gamma");
    messages_->say("limitcurve: " + std::string(kind) + ": " + text);
  }

  /// A radius above 0.1 m (c is the radius at 1 N) suggests data in millimetres.
  void warn_of_units(const fit::FitReport& report) const {
    constexpr double largest_radius = 0.1;
    for (const fit::Estimate& estimate : report.estimates) {
      if (estimate.role != fit::Estimate::Role::radius || !(estimate.value > largest_radius)) continue;
      say("warning", estimate.name + " = " + format_number(estimate.value, 3) + " " + estimate.unit +
                         " is a contact radius of more than 0.1 m at 1 N: are the data in millimetres? Then add "
                         "--units length=mm, or moment=Nmm for moments");
    }
  }

  /// Quality of the fit.
  void describe(const fit::ModelFit& found) const {
    const fit::FitReport& report = found.report;
    std::string text = "fitted " + std::to_string(report.free_parameters) + " parameters to " +
                       std::to_string(report.residuals) + " residuals, rms " + format_number(report.rms, 3) + " (" +
                       report.message + ")";
    const auto percent = [](double fraction) { return format_number(100.0 * fraction, 3) + " %"; };
    if (found.error) {
      text += "; the model overestimates by up to " + percent(found.error->max_over_estimate) +
              ", underestimates by up to " + percent(found.error->max_under_estimate) +
              ", and misplaces the centre of rotation by up to " + percent(found.error->max_cor_error);
    }
    say("note", text);
  }

  static constexpr int digits = 6;  ///< of a suggested parameter

  /// The fitted finger as options of replay and as fields of FingerParameters.
  void suggest_parameters(const fit::ModelFit& found) const {
    using Role = fit::Estimate::Role;
    const fit::Estimate* const mu = found.report.find(Role::force);
    const fit::Estimate* const mu_r = found.report.find(Role::moment);
    if (kind_ == fit::Kind::ratio && mu == nullptr) return;  // without mu there is no finger
    using Loss = fit::Loss::Kind;
    std::string retry;
    if (found.report.gamma_refused) retry += kind_ == fit::Kind::load ? " --load-model power" : " --fit-gamma";
    if (found.report.scatter_refused && settings_.loss.kind == Loss::squared) retry += " --loss cauchy";
    if (!retry.empty() || (found.report.scatter_refused && settings_.loss.kind == Loss::edge)) {
      return say("note", "the data reject this model, so no parameters are suggested" +
                             (retry.empty() ? "" : "; try again with" + retry));
    }
    const fit::Estimate* const fitted = found.report.find(Role::gamma);
    const double gamma = fitted != nullptr ? fitted->value : settings_.gamma;
    const std::string growth = format_number(gamma, digits);
    // FingerParameters accepts no other exponent.
    if (!(gamma >= -0.5 && gamma <= 1.0)) return;
    if (mu_r == nullptr) {
      const std::string c = format_number(found.report.find(Role::radius)->value, digits);
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
    const bool is_ellipse = kind_ == fit::Kind::ellipse;
    if (is_ellipse) options = " --curve ellipse";
    if (mu != nullptr) add("mu", "mu", format_number(mu->value, digits));
    add("mu-r", "mu_r", format_number(mu_r->value, digits));
    if (gamma != 0.0) add("gamma", "gamma", growth);
    if (mu != nullptr && (!law.empty() || is_ellipse) && std::filesystem::exists(descriptor::path_of(data_))) {
      say("note", "for the load that would hold each row: limitcurve hold" + options + " --data " + shell_word(data_) +
                      file_columns_.options_of({"load", "force", "moment"}) +
                      (file_columns_.least_load ? " --least-load " + format_number(*file_columns_.least_load) : "") +
                      (file_columns_.zero ? " --zero" : ""));
    }
    say("note", "for replay:" + options + "; for FingerParameters: " + fields);
  }

  /// The law as a value of --law; "" if the curve belongs to no law or its shape is unknown.
  [[nodiscard]] std::string law_of(const fit::ModelFit& found) const {
    if (kind_ == fit::Kind::ellipse || kind_ == fit::Kind::load) return "";
    const fit::Estimate* const shape = found.report.find(fit::Estimate::Role::shape);
    if (shape == nullptr) return found.model;
    return std::isfinite(shape->value) ? found.model + ":" + shape->name + "=" + format_number(shape->value, digits)
                                       : "";
  }

  [[nodiscard]] fit::ModelFit found() {
    using fit::Kind;
    if (data_.empty()) {
      if (kind_ != Kind::ellipse) throw std::invalid_argument("--data is required to fit '" + name() + "'");
      if (settings_.law == nullptr)
        throw std::invalid_argument("give --data to fit measurements, or --law to fit the exact curve");
      return fit::fit(kind_, settings_.law, settings_);
    }
    switch (kind_) {
      case Kind::ellipse:
      case Kind::law:
        return fit::fit(kind_, asked(read_slip_samples(data_, file_columns_)), settings_);
      case Kind::ratio:
        return std::visit([this](const auto& data) { return fit::fit(kind_, asked(data), settings_); },
                          read_ratio_data(data_, file_columns_));
      case Kind::load:
        return fit::fit(kind_, asked(read_load_samples(data_, file_columns_)), settings_);
      case Kind::friction:
        return friction();
    }
    return {};
  }

  /// The same data, after the questions about their units: the fit itself may fail.
  [[nodiscard]] const std::vector<fit::Sample>& asked(const std::vector<fit::Sample>& slips) const {
    UnitChecks questions;
    for (const fit::Sample& slip : slips) {
      questions.load(slip.load);
      questions.wrench(slip.force, slip.moment);
      questions.force_under(slip.load, slip.force);
      rows_of_data_.push_back(static_cast<double>(slip.row));
    }
    messages_->say(questions.lines());
    return slips;
  }

  [[nodiscard]] const std::vector<fit::RatioSample>& asked(const std::vector<fit::RatioSample>& ratios) const {
    if (settings_.loss.kind != fit::Loss::Kind::squared) {
      throw std::invalid_argument(std::string("--loss: published ratios are averaged, expected squared, got ") +
                                  fit::to_string(settings_.loss.kind));
    }
    return ratios;
  }

  [[nodiscard]] const fit::LoadSamples& asked(const fit::LoadSamples& samples) const {
    UnitChecks questions;
    for (const auto& sample : samples.samples) questions.load(sample.load);
    messages_->say(questions.lines());
    return samples;
  }

  fit::Kind kind_ = fit::Kind::ellipse;
  std::string data_;
  FileColumns file_columns_;
  std::string patch_;
  std::optional<double> load_;
  Messages* messages_ = nullptr;
  mutable std::vector<double> rows_of_data_;  ///< the line of each slip
  bool covariance_ = false;
  bool residuals_ = false;
  fit::FitOptions settings_;
};

}  // namespace

std::unique_ptr<Subcommand> make_fit() {
  return std::make_unique<Fit>();
}

}  // namespace limitcurve::cli
