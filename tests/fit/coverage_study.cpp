// SPDX-License-Identifier: MIT
//
// fit_coverage_study [SEEDS]: bias and coverage of the sample fits over SEEDS (1000) noisy data sets a row, as CSV.
// The README of fit/ quotes its output. About 2 ms a seed and row.
#include "tests/fit/coverage.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  using namespace limitcurve;
  using namespace limitcurve::fit;
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 1000;
  if (seeds < 1) {
    std::fputs("usage: fit_coverage_study [SEEDS >= 1]\n", stderr);
    return 2;
  }
  std::puts("model,noise,sigmas,loss,outliers,parameter,relative_std_error,relative_rms_error,bias,coverage,blanks");
  const auto row = [seeds](const char* name, const ContactModel& model, const Law& law, double shape, double noise,
                           bool tell, const Loss& loss = {}, Outliers outliers = Outliers::none,
                           double moment_noise = 1.0) {
    int blanks = 0;
    for (const auto& [parameter, honesty] :
         study(model, law, shape, noise, tell, seeds, blanks, loss, outliers, moment_noise)) {
      const char* const which = outliers == Outliers::none     ? "none"
                                : outliers == Outliers::inside ? "inside"
                                                               : "both sides";
      std::printf("%s,%g,%s,%s,%s,%s,%.4f,%.4f,%+.3f,%.3f,%d\n", name, noise, tell ? "known" : "found",
                  to_string(loss.kind), which, parameter.c_str(), honesty.std_error, honesty.scatter, honesty.bias,
                  honesty.coverage, blanks);
    }
    std::fflush(stdout);
  };
  const ContactModel power_family{ContactModel::Kind::power};
  const ContactModel xydas_kao_family{ContactModel::Kind::xydas_kao};
  row("hertz", ContactModel::of(hertz()), hertz(), 0.5, 0.01, true);
  row("hertz", ContactModel::of(hertz()), hertz(), 0.5, 0.01, false);
  row("hertz", ContactModel::of(hertz()), hertz(), 0.5, 0.03, true);
  row("hertz", ContactModel::of(hertz()), hertz(), 0.5, 0.03, false);
  row("power n=0.5", power_family, hertz(), 0.5, 0.003, true);
  row("power n=0.5", power_family, hertz(), 0.5, 0.003, false);
  row("power n=0.5", power_family, hertz(), 0.5, 0.01, true);
  row("power n=0.5", power_family, hertz(), 0.5, 0.01, false);
  row("xydas-kao k=3", xydas_kao_family, xydas_kao(3.0), 3.0, 0.001, true);
  row("xydas-kao k=3", xydas_kao_family, xydas_kao(3.0), 3.0, 0.003, true);
  row("hertz (moments 10 %)", ContactModel::of(hertz()), hertz(), 0.5, 0.01, true, {}, Outliers::none, 10.0);
  row("ellipse to hertz", {ContactModel::Kind::ellipse}, hertz(), 0.5, 0.01, true);
  row("hertz to flat punch", ContactModel::of(hertz()), flat_punch(), 0.5, 0.01, true);
  for (const bool tell : {true, false}) {
    for (const Loss& loss : {Loss::squared(), Loss::huber(), Loss::cauchy()}) {
      for (const Outliers outliers : {Outliers::none, Outliers::inside, Outliers::both_sides}) {
        row("hertz", ContactModel::of(hertz()), hertz(), 0.5, 0.01, tell, loss, outliers);
      }
    }
  }
  return 0;
}
