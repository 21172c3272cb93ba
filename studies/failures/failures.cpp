// SPDX-License-Identifier: MIT
// stability_study DIR: measures every entry of docs/stability.md and writes summary.csv (a line for each finding) and a
// CSV for each figure (panel,series,x,value) into DIR. studies/failures/measure draws and documents them.
#include "failures.hpp"
#include "number_text.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace {

using namespace limitcurve;
using namespace limitcurve::stability;

/// Entries in the order of the document.
const std::vector<Entry> entries = {
    {"quadrature", {centre_under_the_finger, singular_rim, kinks_of_a_profile, moment_far_away, force_near_the_centre}},
    {"tables", {even_spacing, beyond_the_last_node, false_equilibria}},
    {"fits", {cor_near_the_axes, shape_and_radius}},
    {"projection", {stiffness_ratios, newton_without_bracket, order_of_limits}},
    {"time", {light_body, delayed_forces, encoder_steps}},
    {"geometry", {half_a_turn, thin_plate, normals_that_jump}},
    {"reality", {rates_and_jitter, collapsing_load}},
};

/// Quotes a text, which may have commas.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return result + '"';
}

void close(std::ofstream& file, const std::filesystem::path& path) {
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

void write(const Figure& figure, const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / (figure.name + ".csv");
  std::ofstream file(path);
  file << "panel,series,x,value\n";
  for (const Row& row : figure.rows) {
    file << quoted(row.panel) << ',' << quoted(row.series) << ',' << study::number_text(row.x) << ','
         << study::number_text(row.value) << '\n';
  }
  close(file, path);
}

void run(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const std::filesystem::path path = folder / "summary.csv";
  std::ofstream summary(path);
  summary << "entry,hazard,method,quantity,breaks,stands\n";
  for (const Entry& entry : entries) {
    for (Hazard (*const measure)() : entry.hazards) {
      const Hazard hazard = measure();
      for (const Finding& finding : hazard.findings) {
        summary << entry.name << ',' << quoted(finding.hazard) << ',' << quoted(finding.method) << ','
                << quoted(finding.quantity) << ',' << study::number_text(finding.breaks) << ','
                << study::number_text(finding.stands) << '\n';
      }
      for (const Figure& figure : hazard.figures) write(figure, folder);
    }
  }
  close(summary, path);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: stability_study DIR\n", stderr);
    return 2;
  }
  try {
    run(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stability_study: error: %s\n", error.what());
    return 1;
  }
}
