// SPDX-License-Identifier: MIT
//
// fit_coverage_study [SEEDS]: bias and coverage of the sample fits over SEEDS (1000) noisy data sets a row, as CSV.
// The README of fit/ quotes its output. About 2 ms a seed and row.
#include "tests/fit/coverage.hpp"

#include "limitcurve/laws.hpp"

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
  struct Row {
    const char* name;
    ContactModel model;
    Law law;
    double shape;
    double noise;
    bool tell;
  };
  const Row rows[] = {
      {"hertz", ContactModel::of(hertz()), hertz(), 0.5, 0.01, true},
      {"hertz", ContactModel::of(hertz()), hertz(), 0.5, 0.01, false},
      {"hertz", ContactModel::of(hertz()), hertz(), 0.5, 0.03, true},
      {"hertz", ContactModel::of(hertz()), hertz(), 0.5, 0.03, false},
      {"power n=0.5", {ContactModel::Kind::power}, hertz(), 0.5, 0.003, true},
      {"power n=0.5", {ContactModel::Kind::power}, hertz(), 0.5, 0.003, false},
      {"power n=0.5", {ContactModel::Kind::power}, hertz(), 0.5, 0.01, true},
      {"xydas-kao k=3", {ContactModel::Kind::xydas_kao}, xydas_kao(3.0), 3.0, 0.001, true},
      {"xydas-kao k=3", {ContactModel::Kind::xydas_kao}, xydas_kao(3.0), 3.0, 0.003, true},
  };
  std::puts("model,noise,sigmas,parameter,relative_std_error,bias,coverage,blanks");
  for (const Row& row : rows) {
    int blanks = 0;
    for (const auto& [name, honesty] : synthetic::study(row.model, row.law, row.shape, row.noise, row.tell, seeds, blanks)) {
      std::printf("%s,%g,%s,%s,%.4f,%+.3f,%.3f,%d\n", row.name, row.noise, row.tell ? "known" : "found", name.c_str(), honesty.std_error,
                  honesty.bias, honesty.coverage, blanks);
    }
    std::fflush(stdout);
  }
  return 0;
}
