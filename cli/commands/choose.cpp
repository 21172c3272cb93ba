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
     "the largest radial error in the normalised plane, which decides whether a contact holds (for how it moves, use "
     "--scene)"},
    {"nanoseconds", of<&Candidate::nanoseconds>,
     "the time to compute a wrench from its slip twist, on one machine (compare ratios only)"},
    {"chosen", of<&Candidate::chosen>, "true for the cheapest model within the tolerance"},
});

class Choose final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"choose", "Find the cheapest limit curve that is accurate enough",
            ColumnList(candidate_columns).help() +
                R"(With --patch instead of --law the contact is not round (see 'limitcurve patch'). Candidates are the
best disc (smallest maximum error; parameter: its radius; it drives a finger as a law does), the ellipsoid sqrt(v^2 +
m0^2 w^2) (parameter: m0) and the patch itself. error is the largest relative error of the friction power over all
slip twists.
With --scene the command chooses the whole step of the god-object. model is 'no torsion' or CURVE/PROJECTION; it uses
the contact radius of the mean load, or that of the current load if the name ends in '/a(P)'. Without --radius-law and
--mu-r, a is 5 mm. error is twice the largest change of the wrench, as a fraction of the friction limits, in a
thousand slides and twists (one after the other and together, with reversals and turns) within the loads, rates and
distances of the scene. nanoseconds is the time of one step of a slipping finger; a batch steps several at once.
Messages say whether the scene needs torsion, coupling, a load-dependent radius, the exact curve and the closest
point, and give the options of replay for the chosen step. Exit status 1 if no step is within the tolerance. A note
appears if k_r/k_l is more than ten times above or below (mu_r/mu_l)^2, the ratio that the radial projection assumes.)",
            "limitcurve choose --law hertz --tolerance 0.01 --scene --mu 0.6 --loads 0.5,2 --stiffness 1000 "
            "--twist-stiffness 0.036"};
  }

  void declare(Options& options) override {
    options.law(law_, Presence::optional);
    options.text("--patch", patch_, "PATCH", "A contact that is not round, instead of --law");
    options.number("--tolerance", tolerance_, positive,
                   "Largest relative error you accept (0.01 is 1 %), from 1e-10 to 1; with --scene from 1e-6",
                   Presence::required);
    options.flag("--explain", explain_, "Print the reason for each candidate");
    options.flag("--scene", scene_wanted_,
                 "Choose a whole simulation step: curve, projection, and whether torsion matters");
    options.number("--mu", scene_.mu, positive, "Friction coefficient of the scene");
    options.radius_law(radius_law_);
    options.number("--mu-r", scene_.mu_r, positive,
                   "mu_r [m] instead of --radius-law, so that the scene's moment limit is mu_r P");
    options.numbers("--loads", loads_, positive, "Smallest and largest load of the scene [N] (default 0.5,2)",
                    Presence::optional);
    options.number("--stiffness", scene_.stiffness, positive, "Contact stiffness k_l of the scene [N/m]");
    options.number("--twist-stiffness", scene_.twist_stiffness, positive,
                   "Torsional stiffness k_r of the scene [N m/rad]");
    options.number("--sample-time", scene_.sample_time, positive, "Sample time of the scene [s]");
    options.number("--slide-speed", scene_.slide_speed, non_negative, "Largest sliding speed of the scene [m/s]");
    options.number("--twist-rate", scene_.twist_rate, non_negative, "Largest twist rate of the scene [rad/s]");
    options.number("--slide", scene_.slide, non_negative, "Largest distance from the scene's first contact [m]");
    options.number("--twist", scene_.twist, non_negative, "Largest twist since the scene's first contact [rad]");
  }

  void run(const Results& results) override {
    if (patch_.empty() == (law_ == nullptr)) throw std::invalid_argument(what_contact(!patch_.empty()));
    if (!scene_wanted_) refuse_scene_options(results);
    if (!patch_.empty() && scene_wanted_)
      throw std::invalid_argument("--scene works with --law only, not with --patch: a scene needs a round contact");
    if (scene_wanted_) {
      take_own_radii(radius_law_, scene_.mu_r.has_value(), law_, *results.messages);
    } else if (law_ != nullptr) {
      results.messages->say(law_->remarks());
    }
    if (radius_law_ && scene_.mu_r) check_moment(true, true);
    if (!scene_.mu_r && !(radius_law_ && radius_law_->sets_moment())) note_profile_error(law_, *results.messages);
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

  static void refuse_scene_options(const Results& results) {
    std::string names;
    for (const char* const option : {"--mu", "--radius-law", "--mu-r", "--loads", "--stiffness", "--twist-stiffness",
                                     "--sample-time", "--slide-speed", "--twist-rate", "--slide", "--twist"}) {
      if (results.has(option)) names.append(names.empty() ? "" : ", ").append(option);
    }
    if (!names.empty()) throw std::invalid_argument(names + ": no effect without --scene; add it, or leave them out");
  }

  void choose_for_scene(const Results& results) {
    scene_.law = law_;
    if (radius_law_) scene_.radius_law = radius_law_->of(scene_.mu, law_);
    if (!loads_.empty()) {
      if (loads_.size() != 2 || loads_.front() > loads_.back()) {
        throw std::invalid_argument(
            "--loads: got " + (loads_.size() == 2 ? "the larger first" : std::to_string(loads_.size()) + " loads") +
            ", expected two, the smaller first, such as 0.5,2");
      }
      scene_.least_load = loads_.front();
      scene_.most_load = loads_.back();
    }
    results.messages->say(radius_warnings(scene_.radius_law, std::array{scene_.least_load, scene_.most_load}));
    const godobject::StepChoice choice = godobject::choose_step(scene_, tolerance_);
    write(results, choice.candidates);
    for (const std::string& line : choice.verdict) {
      if (!choice.chosen && line == choice.verdict.back())
        throw std::runtime_error(line + "; choose a larger --tolerance");
      results.messages->say("limitcurve: " + line);
    }
    if (!radius_law_ && !scene_.mu_r) {
      results.messages->say("limitcurve: without --radius-law and --mu-r the contact radius is taken as a = 5 mm");
    }
    results.messages->say("limitcurve: " + how_to_replay(results, *choice.chosen));
    godobject::FingerParameters finger;
    finger.mu = scene_.mu;
    finger.radius_law = scene_.radius_law;
    finger.mu_r = scene_.mu_r;
    finger.stiffness = scene_.stiffness;
    finger.twist_stiffness = scene_.twist_stiffness;
    note_stiffnesses(*results.messages, "the radial projection", finger, 0.0, law_->moment_ratio(),
                     std::array{scene_.least_load, scene_.most_load});
  }

  /// The options of replay that the scene's own options do not set.
  [[nodiscard]] std::string how_to_replay(const Results& results, const godobject::ReplayOptions& step) const {
    std::string text = "replay it with --curve " + std::string(to_string(step.curve)) + " --projection " +
                       std::string(to_string(step.projection));
    if (step.curve == godobject::CurveKind::table) text += " --tolerance " + format_number(step.tolerance, 6);
    if (!results.has("--mu")) text += " --mu " + format_number(scene_.mu);
    if (!results.has("--stiffness")) text += " --stiffness " + format_number(scene_.stiffness);
    if (!results.has("--twist-stiffness")) text += " --twist-stiffness " + format_number(scene_.twist_stiffness);
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
  std::optional<RadiusLawArgument> radius_law_;
  std::vector<double> loads_;
};

}  // namespace

std::unique_ptr<Subcommand> make_choose() {
  return std::make_unique<Choose>();
}

}  // namespace limitcurve::cli
