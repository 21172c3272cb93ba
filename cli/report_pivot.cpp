// SPDX-License-Identifier: MIT
#include "cli/report_files.hpp"

#include <array>
#include <string_view>

namespace limitcurve::cli {

void write_pivot_file(const std::filesystem::path& output) {
  // The paper's two cases and the exact one: a grip that eases by itself, and an operator who regrips at 30°.
  constexpr std::array<std::string_view, 3> cases{"coupled", "uncoupled", "exact"};
  GatheredRows pivot(output / "pivot.csv");
  for (const std::string_view name : cases) {
    const std::string kind(name);
    const std::vector<std::string> call{"pivot", "--case", kind, "--material", "sandpaper", "--every", "10"};
    std::vector<std::string> released = call;
    released.insert(released.end(), {"--release", "from=0.5,to=0.25,over=10"});
    pivot.add(released, {{"case", kind}, {"grip", "release"}});
    std::vector<std::string> operated = call;
    operated.insert(operated.end(), {"--operator", "target=30deg"});
    pivot.add(operated, {{"case", kind}, {"grip", "operator"}});
  }
  pivot.finish();
}

void write_translate_file(const std::filesystem::path& output) {
  constexpr std::string_view radius_law = "power:c=0.00207,gamma=0.259";
  GatheredRows translate(output / "translate.csv");
  for (const std::string law : {"hertz", "uniform"}) {
    translate.add({"translate", "--law", law, "--radius-law", std::string(radius_law), "--mu", "0.6", "--load", "2"},
                  {{"law", law}, {"radius_law", std::string(radius_law)}, {"mu", "0.6"}, {"load", "2"}});
  }
  translate.finish();
}

}  // namespace limitcurve::cli
