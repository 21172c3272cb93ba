// SPDX-License-Identifier: MIT
// What `error_margin` of choose_step.hpp was calibrated with: how far random motions exceed the errors that choose_step states.
//     choice_study [SCENES [FIRST_SEED [MOTIONS]]]
// Prints a row a scene as CSV, and on standard error the worst and the quantiles of found over stated error, and in how many of the scenes in
// which a cheaper step would do one is chosen. The test suite has seeds 1 to 200; calibrate on others. About 1.5 s a scene of 20 motions.
#include "tests/godobject/scene/choice_study.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  using namespace limitcurve::godobject::test;
  const int scenes = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int first = argc > 2 ? std::atoi(argv[2]) : 1001;
  const int motions = argc > 3 ? std::atoi(argv[3]) : 20;
  if (scenes < 1 || first < 1 || motions < 1) {
    std::fputs("usage: choice_study [SCENES >= 1 [FIRST_SEED >= 1 [MOTIONS >= 1]]]\n", stderr);
    return 2;
  }
  std::vector<double> all;
  double chosen = 0.0;
  int cheaper = 0;
  int given = 0;
  std::puts("seed,chosen,worst_of_chosen,worst_model,worst_of_all,cheaper_would_do,cheaper_is_chosen");
  for (int seed = first; seed < first + scenes; ++seed) {
    const StudyResult result = study_scene(static_cast<std::uint64_t>(seed), motions);
    std::printf("%d,%s,%.4f,%s,%.4f,%d,%d\n", seed, result.chosen.c_str(), result.worst_of_chosen, result.worst_model.c_str(),
                result.worst_of_all, result.cheaper_would_do, result.cheaper_is_chosen);
    std::fflush(stdout);
    all.push_back(result.worst_of_all);
    chosen = std::max(chosen, result.worst_of_chosen);
    cheaper += result.cheaper_would_do ? 1 : 0;
    given += result.cheaper_would_do && result.cheaper_is_chosen ? 1 : 0;
  }
  std::sort(all.begin(), all.end());
  const auto quantile = [&](double share) { return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))]; };
  std::fprintf(stderr, "found over stated: of the chosen at most %.3f; of any candidate at most %.3f, 99 %% of scenes %.3f, half %.3f\n",
               chosen, all.back(), quantile(0.99), quantile(0.5));
  std::fprintf(stderr, "a cheaper step would do in %d scenes, is chosen in %d of them\n", cheaper, given);
  return 0;
}
