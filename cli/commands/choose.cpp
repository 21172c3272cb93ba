// SPDX-License-Identifier: MIT

#include "cli/commands/stiffness_check.hpp"
#include "cli/commands/subcommands.hpp"
#include "cli/io/column_list.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/io/unit_checks.hpp"

#include "godobject/scene/choose_step.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/disc_models.hpp"
#include "limitcurve/validate/shipped_costs.hpp"

#include <array>
#include <limits>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

constexpr std::array candidate_columns = std::to_array<ListedColumn<Candidate>>({
    {"model", of<&Candidate::model>},
    {"parameter", of<&Candidate::parameter>, "as in validate (table: its tolerance; exact: nan)"},
    {"error", of<&Candidate::error>,
     "the largest, of the radius on a ray in the normalised plane: whether a contact holds; how it moves is a question "
     "for --scene"},
    {"nanoseconds", of<&Candidate::nanoseconds>,
     "time to compute one wrench from its slip twist on one machine (compare ratios only)"},
    {"chosen", of<&Candidate::chosen>, "true for the cheapest model whose error is at most the tolerance"},
});

class Choose final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {
        "choose", "Finds the cheapest limit curve that is good enough, and lists the others",
        ColumnList(candidate_columns).help() +
            "--explain gives the reasons on standard error.\n"
            "With --patch instead of --law the contact is not round (see 'limitcurve patch'). Candidates are the disc "
            "with the least\n"
            "largest error (parameter: its radius; it drives a finger as a law does), the ellipsoid sqrt(v^2 + m0^2 "
            "w^2) (parameter: m0)\n"
            "and the patch itself. error is the largest relative error of power over all sliding twists.\n"
            "With --scene the command chooses the whole step of the god-object: model is 'no torsion' or "
            "CURVE/PROJECTION, with the\n"
            "contact radius of the mean load, or with the load-dependent radius if the name ends in '/a(P)'. Without "
            "--radius-law and\n"
            "--mu-r a is 5 mm. error is the change of the rendered wrench as a fraction of the friction limits: twice "
            "the largest\n"
            "change in a thousand slides and twists (in turn and together, with reversals and turns, within the rates, "
            "distances and\n"
            "loads of the scene). nanoseconds is the time of a step of one finger that slips; a batch steps several "
            "contacts at once.\n"
            "Standard error says whether the scene needs torsion, coupling, a load-dependent radius, the exact curve "
            "and the closest\n"
            "point, and gives the replay options of the choice. Exit 1 if no step is within the tolerance. A note "
            "appears where k_r/k_l\n"
            "differs more than tenfold from (mu_r/mu_l)^2, the ratio that the radial projection assumes.",
        "limitcurve choose --law hertz --tolerance 0.01 --scene --mu 0.6 --loads 0.5,2 --stiffness 1000 "
        "--twist-stiffness 0.036"};
  }

  void declare(Options& options) override {
    options.law(law_, Presence::optional);
    options.text("--patch", patch_, "PATCH", "Instead of --law: a pressure patch of any shape");
    options.number("--tolerance", tolerance_, positive,
                   "Largest error, relative (0.01 is 1 %), from 1e-10 to 1; with --scene from 1e-6",
                   Presence::required);
    options.flag("--explain", explain_, "Give the reason for each candidate on standard error");
    options.flag("--scene", scene_wanted_,
                 "Choose the step of a scene: limit curve, projection, and whether torsion matters");
    options.number("--mu", mu_, positive, "Scene: coefficient of friction (default 0.5)");
    options.radius_law(radius_law_);
    options.number("--mu-r", scene_.mu_r, positive,
                   "Scene: mu_r [m]; the moment limit is mu_r P, instead of the radius law's");
    options.numbers("--loads", loads_, positive, "Scene: least and largest load [N] (default 0.5,2)",
                    Presence::optional);
    options.number("--stiffness", stiffness_, positive, "Scene: k_l [N/m] (default 1000)");
    options.number("--twist-stiffness", twist_stiffness_, positive, "Scene: k_r [N m/rad] (default 0.025)");
    options.number("--sample-time", scene_.sample_time, positive, "Scene: sample time [s]");
    options.number("--slide-speed", scene_.slide_speed, non_negative, "Scene: largest sliding speed [m/s]");
    options.number("--twist-rate", scene_.twist_rate, non_negative, "Scene: largest rate of the twist [rad/s]");
    options.number("--slide", slide_, non_negative,
                   "Scene: largest distance from the point of first contact [m] (default: no limit)");
    options.number("--twist", twist_, non_negative,
                   "Scene: largest twist since first contact [rad] (default: no limit)");
  }

  void run(const Results& results) override {
    if (patch_.empty() == (law_ == nullptr)) throw std::invalid_argument("expected one of --law and --patch");
    if (scene_wanted_) {
      take_own_radii(radius_law_, scene_.mu_r.has_value(), law_, *results.messages);
    } else if (law_ != nullptr) {
      results.messages->say(law_->remarks());
    }
    if (radius_law_ && scene_.mu_r) throw std::invalid_argument("--mu-r: not with --radius-law, expected one of them");
    note_profile_error(law_, *results.messages);
    if (!patch_.empty() && scene_wanted_) throw std::invalid_argument("--scene: goes with --law, got --patch");
    scene_wanted_ ? choose_for_scene(results) : choose_curve(results);
  }

 private:
  void choose_curve(const Results& results) const {
    if (patch_.empty()) {
      write(results, choose(law_, tolerance_));
    } else {
      const Patch patch = read_patch(patch_, *results.messages);
      note_factor(*results.messages, patch);
      write(results, choose(patch, tolerance_));
    }
    if (!explain_) return;
    if (law_) {
      results.messages->say(
          "error: of the radius on a ray, which says whether a contact holds; how it moves is a question for --scene");
    }
    results.messages->say("costs measured: " + std::string(shipped_costs::measured));
  }

  void write(const Results& results, const std::vector<Candidate>& candidates) const {
    const ColumnList list(candidate_columns);
    Rows rows(results, list.names());
    for (const Candidate& candidate : candidates) {
      list.write(rows, candidate);
      if (explain_) results.messages->say(candidate.model + ": " + candidate.reason);
    }
    rows.finish();
  }

  void choose_for_scene(const Results& results) {
    scene_.law = law_;
    if (mu_) scene_.mu = *mu_;
    if (stiffness_) scene_.stiffness = *stiffness_;
    if (twist_stiffness_) scene_.twist_stiffness = *twist_stiffness_;
    if (radius_law_) scene_.radius_law = radius_law_->of(scene_.mu, law_);
    if (slide_) scene_.slide = *slide_;
    if (twist_) scene_.twist = *twist_;
    if (!loads_.empty()) {
      if (loads_.size() > 2)
        throw std::invalid_argument("--loads: got " + std::to_string(loads_.size()) +
                                    " loads, expected the least and the largest");
      scene_.least_load = loads_.front();
      scene_.most_load = loads_.back();
    }
    results.messages->say(radius_warnings(scene_.radius_law, std::array{scene_.least_load, scene_.most_load}));
    const godobject::StepChoice choice = godobject::choose_step(scene_, tolerance_);
    write(results, choice.candidates);
    for (const std::string& line : choice.verdict) {
      if (!choice.chosen && line == choice.verdict.back())
        throw std::runtime_error(line + "; expected a larger --tolerance");
      results.messages->say("limitcurve: " + line);
    }
    if (!radius_law_ && !scene_.mu_r) {
      results.messages->say("limitcurve: without --radius-law and --mu-r the contact radius is taken as a = 5 mm");
    }
    results.messages->say("limitcurve: " + how_to_replay(*choice.chosen));
    godobject::FingerParameters finger;
    finger.mu = scene_.mu;
    finger.radius_law = scene_.radius_law;
    finger.mu_r = scene_.mu_r;
    finger.stiffness = scene_.stiffness;
    finger.twist_stiffness = scene_.twist_stiffness;
    note_stiffnesses(*results.messages, "the rows of the radial projection", finger, law_->moment_ratio(),
                     std::array{scene_.least_load, scene_.most_load});
  }

  /// The options of replay that the scene's own options do not set.
  [[nodiscard]] std::string how_to_replay(const godobject::ReplayOptions& step) const {
    std::string text = "replay it with --curve " + std::string(to_string(step.curve)) + " --projection " +
                       std::string(to_string(step.projection));
    if (step.curve == godobject::CurveKind::table) text += " --tolerance " + format_number(step.tolerance, 6);
    if (!mu_) text += " --mu " + format_number(scene_.mu);
    if (!stiffness_) text += " --stiffness " + format_number(scene_.stiffness);
    if (!twist_stiffness_) text += " --twist-stiffness " + format_number(scene_.twist_stiffness);
    if (step.finger.mu_r == 0.0) return text + " --mu-r 0" + (radius_law_ ? " instead of --radius-law" : "");
    const RadiusLaw& radius_law = step.finger.radius_law;
    if (!scene_.mu_r && (!radius_law_ || radius_law.depends_on_load() != scene_.radius_law.depends_on_load())) {
      text += " --radius-law constant:a=" + format_number(radius_law.radius(scene_.most_load), 6);
    }
    return text;
  }

  Law law_;
  std::string patch_;
  double tolerance_ = 0.0;
  bool explain_ = false;
  bool scene_wanted_ = false;
  godobject::Scene scene_;
  std::optional<double> mu_;
  std::optional<double> stiffness_;
  std::optional<double> twist_stiffness_;
  std::optional<RadiusLawArgument> radius_law_;
  std::vector<double> loads_;
  std::optional<double> slide_;
  std::optional<double> twist_;
};

}  // namespace

std::unique_ptr<Subcommand> make_choose() {
  return std::make_unique<Choose>();
}

}  // namespace limitcurve::cli
