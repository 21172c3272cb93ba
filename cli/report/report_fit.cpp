// SPDX-License-Identifier: MIT
#include "cli/io/slip_samples.hpp"
#include "cli/report/report_files.hpp"

#include "fit/contact_fit.hpp"
#include "limitcurve/laws.hpp"

namespace limitcurve::cli {

namespace {

/// The parameters that the measurements in data/ give.
void write_parameters(const std::filesystem::path& output, const std::filesystem::path& data) {
  GatheredRows fits(output / "fits.csv");
  const auto add = [&](const std::string& name, const std::string& model, const std::vector<std::string>& options) {
    std::vector<std::string> call{"fit", model, "--data", (data / "fit" / (name + ".csv")).string()};
    call.insert(call.end(), options.begin(), options.end());
    fits.add(call, {{"data", name}, {"model", model}});
  };
  fits.add({"fit", "ratio", "--data", (data / "materials.csv").string()}, {{"data", "materials"}, {"model", "ratio"}});
  add("slips", "law", {"--law", "hertz", "--loss", "cauchy", "--fit-gamma"});
  add("radii", "load", {});
  fits.finish();
}

/// What a chart of the fit to the synthetic sensor log shows.
void write_chart(const std::filesystem::path& output, const std::filesystem::path& data) {
  const std::vector<fit::Sample> samples = read_slip_samples((data / "fit" / "slips.csv").string());
  fit::ContactFitOptions options;
  options.loss = fit::Loss::cauchy();
  options.fit_gamma = true;
  const fit::ContactFit found = fit::fit_contact(samples, fit::ContactModel::of(hertz()), options);
  AtomicFile band_file(output / "fit_band.csv");
  Rows band({band_file.output()}, {"force", "moment", "inner_force", "inner_moment", "outer_force", "outer_moment"});
  for (const fit::ContactFit::BandPoint& point : found.band) {
    band.row(point.force, point.moment, point.inner_force, point.inner_moment, point.outer_force, point.outer_moment);
  }
  band.finish();
  band_file.commit();
  AtomicFile residual_file(output / "fit_residuals.csv");
  Rows residuals({residual_file.output()}, {"load", "force", "moment", "sigma_force", "sigma_moment", "residual"});
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const fit::Sample& sample = samples[i];
    residuals.row(sample.load, sample.force, sample.moment, sample.sigma_force, sample.sigma_moment, found.residuals.at(i));
  }
  residuals.finish();
  residual_file.commit();
}

}  // namespace

void write_fit_files(const std::filesystem::path& output, const std::filesystem::path& data) {
  write_parameters(output, data);
  write_chart(output, data);
  // Measured once in the engines themselves, which a reader need not have.
  std::filesystem::copy_file(data / "engines" / "drag.csv", output / "engine_drag.csv", std::filesystem::copy_options::overwrite_existing);
}

}  // namespace limitcurve::cli
