// SPDX-License-Identifier: MIT
#include "cli/commands/stiffness_check.hpp"
#include "cli/commands/subcommands.hpp"
#include "cli/io/body_argument.hpp"
#include "cli/io/column_list.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/io/surface_argument.hpp"
#include "cli/io/trace_reader.hpp"
#include "cli/io/unit_checks.hpp"
#include "limitcurve/internal/key_values.hpp"

#include "godobject/scene/passivity.hpp"
#include "godobject/scene/replay.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace limitcurve::cli {

namespace {

using godobject::BodyMotion;
using godobject::CurveKind;
using godobject::Projection;

using godobject::SceneContact;

template <auto vector, int axis>
Cell along(const SceneContact& contact) {
  return (contact.*vector)(axis);
}

constexpr std::array plane_columns = std::to_array<ListedColumn<SceneContact>>({
    {"px", along<&SceneContact::proxy, 0>},
    {"py", along<&SceneContact::proxy, 1>},
    {"angle", of<&SceneContact::angle>},
    {"depth", of<&SceneContact::depth>},
    {"load", of<&SceneContact::load>},
    {"fx", along<&SceneContact::force, 0>},
    {"fy", along<&SceneContact::force, 1>},
    {"moment", of<&SceneContact::moment>},
    {"cor", of<&SceneContact::cor>},
});
constexpr std::array space_columns = std::to_array<ListedColumn<SceneContact>>({
    {"pz", along<&SceneContact::proxy, 2>},
    {"fz", along<&SceneContact::force, 2>},
    {"nx", along<&SceneContact::normal, 0>},
    {"ny", along<&SceneContact::normal, 1>},
    {"nz", along<&SceneContact::normal, 2>},
});
constexpr std::array detail_columns = std::to_array<ListedColumn<SceneContact>>({
    {"margin", of<&SceneContact::margin>, "1 uses no friction, 0 slips"},
    {"hold_load", of<&SceneContact::load_to_hold>, "smallest load that holds the friction [N]"},
    {"corx", along<&SceneContact::centre_of_rotation, 0>, "centre of rotation of the slip [m]"},
    {"cory", along<&SceneContact::centre_of_rotation, 1>},
    {"corz", along<&SceneContact::centre_of_rotation, 2>},
    {"dissipated", of<&SceneContact::dissipated>, "energy lost to slip so far [J]"},
});

/// The columns of one finger.
ColumnList<SceneContact> columns_of_finger(bool in_space, bool details) {
  ColumnList list(plane_columns);
  if (in_space) list.add(space_columns);
  if (details) list.add(detail_columns);
  return list;
}

/// What --details adds, as in --help.
std::string details_text() {
  std::string text;
  for (const ListedColumn<SceneContact>& column : detail_columns) {
    text.append(text.empty() ? "" : column.text.empty() ? "," : "; ").append(column.name);
    if (!column.text.empty()) text.append(" (").append(column.text).append(")");
  }
  return text;
}

/// The samples that are invalid for one reason.
struct Refused {
  std::size_t count = 0;
  double since = 0.0;  ///< time of the first [s] …
  double after = 0.0;  ///< … and of the sample before it
};

/// Whether a fault is one of all fingers.
bool is_of_all(godobject::Fault fault) {
  return fault == godobject::Fault::time_step || fault == godobject::Fault::body || fault == godobject::Fault::force;
}

/// A row of the trace.
struct Sample {
  double time;
  std::vector<godobject::DevicePose> fingers;
  godobject::BodyPose body;
};

class Replay final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"replay", "Run a soft finger (the paper's god-object) over a recorded motion on a surface",
            R"(Trace: columns time,x,y,z,twist [s, m, m, m, rad]. Instead of twist, qw,qx,qy,qz may give the
orientation (unit quaternion, finger to world). Without both the finger does not twist. The plane is z = 0, its
outward normal +z; the finger touches at z < 0.
Columns: time, state (free|stick|slip|invalid; a note gives the reason, first time and count), px and py [m] and angle
[rad] of the proxy, depth [m], load [N], fx and fy [N] and moment [N m] (the friction on the user), and cor [m] (the
distance of the slip's centre of rotation, nan without slip).
Another surface, a moving body or several fingers add pz, fz and nx,ny,nz (the outward normal), in world coordinates;
angle is then relative to the body. The user feels the load along the normal, and the moment about it.
--body trace moves the body by the columns bx,by,bz [m] and bqw,bqx,bqy,bqz (body to world). A planar or free body
starts at the origin, and the fingers push it; columns of these names give its pose after each sample.
Finger N reads x2,y2,z2,twist2 (or qw2,...) and so on, and writes state2,px2,py2,...
A patch is fixed to the finger and turns with angle; cor is measured from its centre of pressure, the contact point.)",
            "limitcurve replay --trace data/traces/slide_twist_load.csv --law hertz --radius-law constant:a=0.006 --mu "
            "0.6\n"
            "    --stiffness 1000 --twist-stiffness 0.036 --curve table --projection closest-point"};
  }

  void declare(Options& options) override {
    options.text("--trace", trace_, "FILE", "Motion: CSV with columns time,x,y,z,twist, or - for standard input",
                 Presence::required);
    options.law(replay_.law, Presence::optional);
    options.text("--patch", patch_, "PATCH",
                 "A contact that is not round, instead of --law and --radius-law; needs closest-point");
    options.radius_law(radius_law_);
    options.finger(replay_.finger, {"mu", "stiffness", "twist_stiffness"}, false);
    options.named("--curve", replay_.curve, godobject::curve_kind_names(), godobject::parse_curve_kind,
                  "Limit curve: {}");
    options.named("--projection", replay_.projection, godobject::projection_names, godobject::parse_projection,
                  "How slip returns to the curve: {}; radial and c-curve assume k_r/k_l = b_r/b_l = (mu_r/mu_l)^2");
    options.number("--tolerance", replay_.tolerance, positive, "Error of the table, in unit wrenches");
    options.value(
        "--surface", "SURFACE",
        [this](const std::string& text) {
          surface_ = read_surface(text);
          on_plane_ = text == "plane";
        },
        "Surface [m]: plane (default), sphere:radius=0.05, capsule:radius=0.01,length=0.1, "
        "cylinder:radius=0.02,length=0.1, box:x=0.12,y=0.04,z=0.04",
        Presence::optional);
    options.text("--body", body_text_, "BODY",
                 "Touched body: fixed (default), trace, planar:mass=0.1[,inertia=1e-4] (in x-y, frictionless), "
                 "free:mass=0.1[,inertia=1e-4][,gravity=9.81] [kg, kg m^2, m/s^2]");
    options.count("--fingers", fingers_, 1, godobject::Replay::most_fingers, "Number of fingers in the trace");
    options.value(
        "--check-gains", "LIST", [this](const std::string& text) { read_device(text); },
        "b=NUMBER[,b_r=NUMBER][,T=SECONDS][,delay=SAMPLES]: reject gains that are not passive on a device with this "
        "damping [N s/m, "
        "N m s/rad], sample time (default: each step of the trace up to 1 s) and delay (default 0; most devices: 1)",
        Presence::optional);
    options.flag("--details", details_, "Add columns for a controller: " + details_text());
    options.rare();
    options.file_columns(columns_);
    options.finger(replay_.finger, {}, true);
    options.number(
        "--point-radius", point_radius_, positive,
        "Radius given to the points of a patch [m] (default and minimum 1e-3 m0, m0: moment of a pure spin over mu P)");
  }

  void run(const Results& results) override {
    check_patch();
    take_own_radii(radius_law_, replay_.finger.mu_r.has_value(), replay_.law, *results.messages);
    if (patch_.empty()) check_moment(radius_law_.has_value(), replay_.finger.mu_r.has_value());
    if (radius_law_) replay_.finger.radius_law = radius_law_->of(replay_.finger.mu, replay_.law);
    columns_.messages = results.messages;
    const bool is_round = patch_.empty();
    results.warn_idle({{"--law", is_round && law_if_needed(nullptr, replay_.curve, !radius_law_) != nullptr},
                       {"--tolerance", !is_round || replay_.curve != CurveKind::table}},
                      is_round ? "replay with this --curve" : "replay with --patch");
    if (device_ && !reads_ahead()) require_passive(std::array{sample_time_}, *results.messages);
    const BodyArgument body = body_argument();
    const bool in_space = !on_plane_ || body.motion != BodyMotion::fixed || fingers_ > 1;
    replay_.surface = surface_.surface;
    replay_.fingers = fingers_;
    replay_.motion = body.motion;
    replay_.body = body.parameters;
    if (!patch_.empty()) {
      replay_.patch = read_patch(patch_, *results.messages);
      const auto spin = [&](double radius) { return replay_.patch->smoothed(radius).power({0.0, 0.0, 1.0}); };
      results.warn_idle({{"--point-radius", spin(1e-3) == spin(2e-3)}}, "a patch without points");
    }
    replay_.point_radius = point_radius_.value_or(0.0);
    run_replay(results, columns_of_finger(in_space, details_));
  }

 private:
  void check_patch() {
    if (patch_.empty()) replay_.law = law_if_needed(replay_.law, replay_.curve, replay_.finger.mu_r.has_value());
    if (patch_.empty() == (replay_.law == nullptr)) throw std::invalid_argument(what_contact(!patch_.empty(), true));
    if (patch_.empty()) {
      if (point_radius_) throw std::invalid_argument("--point-radius needs --patch");
      return;
    }
    const auto refuse = [](const char* option, bool given) {
      if (given)
        throw std::invalid_argument(std::string(option) +
                                    " has no effect with --patch, which has its own size and moments: leave it out");
    };
    refuse("--radius-law", radius_law_.has_value());
    refuse("--mu-r", replay_.finger.mu_r.has_value());
    refuse("--mu-r-dynamic", replay_.finger.mu_r_dynamic.has_value());
    if (replay_.projection != Projection::closest_point)
      throw std::invalid_argument("--patch works only with --projection closest-point, the default");
    if (replay_.curve != CurveKind::table && replay_.curve != CurveKind::exact) {
      throw std::invalid_argument("--curve has no effect with --patch, which is its own limit surface: leave it out");
    }
  }

  [[nodiscard]] BodyArgument body_argument() const {
    try {
      return read_body(body_text_, surface_);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(std::string("--body: ") + error.what());
    }
  }

  void read_device(const std::string& text) {
    godobject::DeviceDamping device{0.0, std::numeric_limits<double>::infinity()};
    const auto take_delay = [this](std::string_view number) {
      const std::optional<double> samples = parse_number(number);
      if (!(samples && *samples >= 0.0 && *samples <= godobject::most_delay && *samples == std::floor(*samples))) {
        throw std::invalid_argument("got '" + std::string(number) + "', expected whole samples, 0 to 1000");
      }
      delay_ = static_cast<int>(*samples);
    };
    read_key_values(
        text, {number_key("b", device.sliding, non_negative), number_key("b_r", device.twist, non_negative, false),
               number_key("T", sample_time_, positive, false), KeyValue{"delay", take_delay, false}});
    device_ = device;
  }

  /// Whether the gains must be checked against the steps of the trace, which is read in advance then.
  [[nodiscard]] bool reads_ahead() const { return device_ && sample_time_ == 0.0; }

  void require_passive(std::span<const double> steps, Messages& messages) const {
    godobject::require_passive(replay_.finger, steps, *device_, delay_);
    const auto [sliding, twist] = device_damping_needed(replay_.finger, steps, delay_);
    messages.say("limitcurve: note: --check-gains: passed; the gains need b = " + format_number(sliding, 3) +
                 " N s/m and b_r = " + format_number(twist, 3) + " N m s/rad");
  }

  /// Names the step that needs most, unless all are even but for their rounding: a long one, or one that holds the
  /// damper's force of a shorter one.
  [[nodiscard]] std::string worst_step(const std::vector<double>& steps, const std::vector<double>& ends) const {
    const godobject::FingerParameters& finger = replay_.finger;
    const bool slides = device_->sliding <= device_damping_needed(finger, steps, delay_).sliding;
    const double stiffness = slides ? finger.stiffness : finger.twist_stiffness;
    const double damping = slides ? finger.damping : finger.twist_damping;
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0.0;
    double most = 0.0;
    std::string text;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (std::isinf(steps[i])) continue;
      shortest = std::min(shortest, steps[i]);
      longest = std::max(longest, steps[i]);
      const double times = i > 0 ? steps[i] / steps[i - 1] : 1.0;
      const double needed = (delay_ + 0.5) * stiffness * steps[i] + damping * std::sqrt(times);
      if (needed <= most) continue;
      most = needed;
      text = "; the step that needs most ends at " + format_number(ends[i]) + " s";
      if (damping > 0.0 && times > 1.01)
        text += " and is " + format_number(times, 3) + " times as long as the one before it";
    }
    return longest < 1.01 * shortest ? "" : text;
  }

  /// Checks the steps that the replay makes. The finger's parameters are good.
  void check_gains(const std::vector<Sample>& samples, Messages& messages) const {
    godobject::SampleClock clock;
    std::vector<double> steps;
    std::vector<double> ends;
    std::size_t gaps = 0;
    for (const Sample& sample : samples) {
      const double step = clock.step(sample.time);
      if (!(step >= godobject::shortest_time_step)) continue;  // the first sample, a refused one, or no damper acts
      const bool is_gap = step > godobject::Replay::longest_step;
      steps.push_back(is_gap ? std::numeric_limits<double>::infinity() : step);
      ends.push_back(sample.time);
      gaps += is_gap;
    }
    if (gaps == steps.size())
      throw std::invalid_argument("--check-gains: the trace has no time steps up to 1 s: add T=SECONDS");
    try {
      require_passive(steps, messages);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(error.what() + worst_step(steps, ends));
    }
    if (gaps > 0) {
      messages.say("limitcurve: note: --check-gains: " + std::to_string(gaps) +
                   (gaps == 1 ? " step of more than 1 s is" : " steps of more than 1 s are") + " not checked");
    }
  }

  static void note_columns(Messages& messages, const TraceReader& trace) {
    if (const std::string unread = trace.unread(); !unread.empty())
      messages.say("limitcurve: note: columns of the trace that are not read: " + unread);
    for (const std::string& column : trace.missing_twists()) {
      messages.say("limitcurve: note: the trace has no column '" + column + "': this finger does not twist");
    }
  }

  void run_replay(const Results& results, const ColumnList<SceneContact>& columns) const {
    TraceReader trace(trace_, fingers_, replay_.motion == BodyMotion::prescribed, columns_);
    note_columns(*results.messages, trace);
    results.messages->say(surface_.notes);
    const bool is_free = replay_.motion == BodyMotion::free;
    godobject::Replay replay(replay_);
    godobject::SampleClock clock;
    std::vector<Sample> ahead;
    // The usual step is the geometric mean of those with dampers, which neither gaps nor near-duplicates decide.
    double logarithms = 0.0;
    std::size_t damped = 0;
    const auto next = [&] {
      if (!trace.next()) return false;
      const double step = clock.step(trace.time());
      if (step >= godobject::shortest_time_step) {
        logarithms += std::log(step);
        ++damped;
      }
      if (is_free && step > godobject::Replay::longest_step) {
        throw trace.complaint("a gap of " + format_number(step) + " s, expected at most " +
                              format_number(godobject::Replay::longest_step) + " s for a free body");
      }
      if (!ahead.empty() && step == 0.0)
        throw trace.complaint(
            "--check-gains: the time of the last sample again: add T=SECONDS, the device's sample time");
      return true;
    };
    while (reads_ahead() && next()) ahead.push_back({trace.time(), trace.fingers(), trace.body()});
    if (reads_ahead()) check_gains(ahead, *results.messages);
    if (device_ && std::isinf(device_->twist))
      results.messages->say("limitcurve: note: --check-gains: without b_r the twist is not checked");
    if (replay_.curve == CurveKind::exact && !replay_.patch) {
      std::string text = "limitcurve: exact: a table with an error of at most " +
                         format_number(replay.curve_error(), 3) + " in unit wrenches";
      if (const double profile = replay_.law->profile_error(); profile > 0.0) {
        text += ", of which " + format_number(profile, 3) + " because the pressure is known only at samples";
      }
      results.messages->say(text);
    }
    std::vector<std::string> names{"time"};
    for (std::size_t i = 0; i < fingers_; ++i) {
      const std::string suffix = i == 0 ? "" : std::to_string(i + 1);
      names.push_back("state" + suffix);
      for (const std::string& name : columns.names()) names.push_back(name + suffix);
    }
    if (is_free) names.insert(names.end(), {"bx", "by", "bz", "bqw", "bqx", "bqy", "bqz"});
    Rows rows(results, names);
    std::array loads{std::numeric_limits<double>::infinity(), 0.0};
    std::map<std::pair<godobject::Fault, std::size_t>, Refused> refused;
    double before = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; reads_ahead() ? i < ahead.size() : next(); ++i) {
      if (trace.share()) results.messages->progress(*trace.share());
      const Sample sample = reads_ahead() ? std::move(ahead[i]) : Sample{trace.time(), trace.fingers(), trace.body()};
      const std::size_t unsolved = replay.unsolved();
      replay.step(sample.time, sample.fingers, sample.body);
      if (replay.unsolved() > unsolved) {
        results.messages->say("limitcurve: time " + format_number(sample.time) +
                              " s: the step of the body was not solved; its momentum is right, its position "
                              "approximate: a smaller time step may help");
      }
      rows.row_by([&](const auto& cell) {
        cell(sample.time);
        for (std::size_t finger = 0; finger < fingers_; ++finger) {
          const SceneContact& contact = replay.contacts()[finger];
          cell(godobject::to_string(contact.state));
          columns.cells(contact, cell);
          if (contact.load > 0.0) loads = {std::min(loads[0], contact.load), std::max(loads[1], contact.load)};
          if (contact.fault == godobject::Fault::none || (finger > 0 && is_of_all(contact.fault))) continue;
          if (Refused& reason = refused[{contact.fault, finger}]; reason.count++ == 0)
            reason = {1, sample.time, before};
        }
        if (!is_free) return;
        for (const double place : replay.body().position) cell(place);
        const Eigen::Quaterniond& turn = replay.body().orientation;
        for (const double part : {turn.w(), turn.x(), turn.y(), turn.z()}) cell(part);
      });
      before = sample.time;
    }
    rows.finish();
    for (const auto& [reason, samples] : refused) {
      const auto [fault, finger] = reason;
      results.messages->say(
          "limitcurve: note: " +
          (fingers_ == 1 || is_of_all(fault) ? "" : "finger " + std::to_string(finger + 1) + ": ") +
          std::to_string(samples.count) + (samples.count == 1 ? " sample" : " samples") +
          (samples.count == 1 ? " is" : " are") + " invalid, the first at " + format_number(samples.since) +
          " s: " + std::string(to_string(fault)) +
          (fault == godobject::Fault::time_step ? ", after " + format_number(samples.after) + " s" : ""));
    }
    // Without any contact, check at 1 N, or at the nearest load that the radius was measured at.
    const auto [first, last] = replay_.finger.radius_law.sampled_loads();
    if (loads[1] == 0.0) loads.fill(std::clamp(1.0, first, last));
    if (replay_.projection != Projection::closest_point) {
      note_stiffnesses(*results.messages, "--projection " + std::string(to_string(replay_.projection)), replay_.finger,
                       damped > 0 ? std::exp(logarithms / static_cast<double>(damped)) : 0.0,
                       replay_.law->moment_ratio(), std::span(&loads[1], 1));
    }
    UnitChecks questions = trace.questions();
    questions.source = "it is --stiffness times the depth, and --units length=mm converts millimetres";
    questions.load(loads[1]);
    if (radius_law_) questions.radii(replay_.finger.radius_law, loads);
    results.messages->say(questions.lines());
  }

  std::string trace_;
  FileColumns columns_;
  std::string patch_;
  std::optional<double> point_radius_;
  std::optional<RadiusLawArgument> radius_law_;
  SurfaceArgument surface_ = read_surface("plane");
  bool on_plane_ = true;
  std::string body_text_ = "fixed";
  std::size_t fingers_ = 1;
  bool details_ = false;
  std::optional<godobject::DeviceDamping> device_;
  double sample_time_ = 0.0;  // of the device; 0: the trace's
  int delay_ = 0;
  godobject::ReplayOptions replay_;
};

}  // namespace

std::unique_ptr<Subcommand> make_replay() {
  return std::make_unique<Replay>();
}

}  // namespace limitcurve::cli
