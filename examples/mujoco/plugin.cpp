// SPDX-License-Identifier: MIT
// The MuJoCo engine plugin "limitcurve.finger": friction of soft fingers, force and moment together, from the exact
// limit curve. MuJoCo keeps the normal force of the finger's geoms (condim="1" priority="1"); the plugin gives the
// finger's body their friction, and the other body its reaction. All memory is in mjData.plugin_state. `compute` only
// reads it, so that mj_forward, Runge-Kutta, copies and rollouts are safe; `advance`, once a step, writes it. Loads are
// those of the last step.
#include <mujoco/mujoco.h>
#include <algorithm>
#include <godobject/godobject.hpp>
#include <limitcurve/limitcurve.hpp>
#include <limitcurve/patch/patch.hpp>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <vector>
namespace {
using namespace limitcurve;
using namespace limitcurve::godobject;
using Eigen::Quaterniond, Eigen::Vector3d;
using Rows = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>;
constexpr int most_objects = 4;  // that one finger touches at a time
constexpr const char* keys[] = {"law",  "tolerance", "patch",     "radius_law",      "mu",      "mu_dynamic",
                                "mu_r", "contacts",  "stiffness", "twist_stiffness", "damping", "twist_damping"};

// What a finger remembers of an object that it touches. Places are in the object's frame: there the proxy rides on it.
struct Pair {
  double object = 0;  // its body plus one; 0: an empty slot
  double load = 0;    // normal force of the last step [N]
  double slide_weight = 1,
         twist_weight = 1;            // inverse mass and inverse moment of inertia that the contact met at touch-down
  Vector3d lever = Vector3d::Zero();  // centre of pressure less the mean of the contact points, in the last step
  Vector3d finger_at = Vector3d::Zero();  // the finger's body in the last step
  FingerState finger;
};
template <class Visit>
void each_number(Pair& p, Visit&& visit) {  // the numbers that make a pair, on their way into plugin_state and back
  FingerState& f = p.finger;
  const auto all = [&](auto& array) { std::for_each(array.begin(), array.end(), visit); };
  visit(p.object), visit(p.load), visit(p.slide_weight), visit(p.twist_weight), all(p.lever), all(p.finger_at);
  all(f.output.proxy), visit(f.output.angle), visit(f.in_contact), visit(f.faults.seen);
  all(f.sample.goal), all(f.sample.normal), all(f.held_normal), visit(f.sample.angle);
  all(f.spin.axis), visit(f.spin.scalar), visit(f.spin.started);
  visit(f.friction.force_slides), visit(f.friction.search_start), visit(f.friction.search_rate);
  all(f.patch.zero_axis), all(f.patch.axis), all(f.patch.slip);
}
const int pair_size = [count = 0, pair = Pair()]() mutable {
  return each_number(pair, [&](auto&) { ++count; }), count;
}();
Pair load(const mjtNum* from) {
  Pair pair;
  each_number(pair, [&](auto& x) { x = static_cast<std::decay_t<decltype(x)>>(*from++); });
  pair.finger.spin.angle = pair.finger.sample.angle,
  pair.finger.spin.normal = plain::numbers(pair.finger.sample.normal);
  pair.finger.output.depth = std::numeric_limits<double>::quiet_NaN();  // as every step under a given load
  return pair;
}
void save(Pair pair, mjtNum* to) {
  each_number(pair, [&](auto& x) { *to++ = static_cast<mjtNum>(x); });
}
Quaterniond turn_of(const mjData* d, int b) {
  return {d->xquat[4 * b], d->xquat[4 * b + 1], d->xquat[4 * b + 2], d->xquat[4 * b + 3]};
}
FingerCurve shared_curve(const std::string& law,
                         double tolerance) {  // a table takes milliseconds, and there may be thousands of mjData
  static std::mutex mutex;
  static std::map<std::pair<std::string, double>, std::optional<FingerCurve>> curves;
  const std::lock_guard lock(mutex);
  auto& curve = curves[{law, tolerance}];
  if (!curve) curve = Table::build(parse_law(law), tolerance);
  return *curve;
}
struct Touch {  // sums over all contacts of a finger with one object
  int object, count = 0;
  double load = 0;
  Vector3d at = Vector3d::Zero(), normal = Vector3d::Zero(), pressed = Vector3d::Zero();
};
struct Skin {  // what the bodies of one plugin instance share: plugin_data of one mjData. No memory between steps
  Skin(const mjModel* m, int instance) : model_(m), instance_(instance), finger_of_(m->nbody, -1) {
    const auto text = [&](const char* key, const char* otherwise = "") {
      const char* value = mj_getPluginConfig(m, instance, key);
      return std::string(value && *value ? value : otherwise);
    };
    const auto number = [&](const char* key) {
      const std::string value = text(key);
      char* end;
      const double x = std::strtod(value.c_str(), &end);
      if (*end) throw std::invalid_argument(std::string(key) + ": '" + value + "' is not a number");
      return value.empty() ? std::optional<double>() : x;
    };
    given_.mu = number("mu").value_or(0.5), given_.mu_dynamic = number("mu_dynamic"), given_.mu_r = number("mu_r");
    given_.radius_law = RadiusLaw::parse(text("radius_law", "constant:a=0.005")), given_.max_speed = mjMAXVAL;
    stiffness_ = number("stiffness"), twist_stiffness_ = number("twist_stiffness");
    damping_ = number("damping"), twist_damping_ = number("twist_damping"),
    contacts_ = std::max(1.0, number("contacts").value_or(8.0));
    double x = 0, y = 0;
    char rest;
    const std::string patch = text("patch");
    if (patch.empty())
      curve_ = shared_curve(text("law", "hertz"), number("tolerance").value_or(Table::default_tolerance));
    if (std::sscanf(patch.c_str(), "rectangle:x=%lf,y=%lf%c", &x, &y, &rest) == 2) patch_ = Patch::rectangle(x, y);
    if (!curve_ && !patch_)
      throw std::invalid_argument("patch: got '" + patch + "', expected rectangle:x=LENGTH,y=LENGTH");
    for (int body = 1; body < m->nbody; ++body)
      if (m->body_plugin[body] == instance) finger_of_[body] = static_cast<int>(bodies.size()), bodies.push_back(body);
    for (int geom = 0; geom < m->ngeom; ++geom)
      if (finger_of_[m->geom_bodyid[geom]] >= 0 && (m->geom_condim[geom] != 1 || m->geom_priority[geom] < 1))
        throw std::invalid_argument(
            "a geom of a finger needs condim=\"1\" priority=\"1\": else MuJoCo adds friction of its own");
    touches.resize(bodies.size()), make_finger(Pair{});  // throws if a parameter is out of range
  }
  Skin& gather(const mjModel* m, const mjData* d, bool with_loads) {
    model_ = m;  // another one may step the same data
    for (auto& of_body : touches) of_body.clear();
    for (int i = 0; i < d->ncon; ++i) {
      const mjContact& c = d->contact[i];
      if (c.geom[0] < 0 || c.geom[1] < 0 || c.dim != 1 || c.efc_address < 0) continue;
      const int one = m->geom_bodyid[c.geom[0]], two = m->geom_bodyid[c.geom[1]];
      const bool first = finger_of_[one] >= 0;  // of two fingers the first gives the friction
      if (!first && finger_of_[two] < 0) continue;
      const int object = first ? two : one, other = m->body_plugin[object];
      if (other >= 0 && other < instance_ && m->plugin[other] == m->plugin[instance_])
        continue;  // a finger of another instance gives it
      auto& all = touches[finger_of_[first ? one : two]];
      auto touch = std::find_if(all.begin(), all.end(), [&](const Touch& t) { return t.object == object; });
      if (touch == all.end()) touch = all.insert(all.end(), Touch{object});
      mjtNum force[6] = {};
      if (with_loads) mj_contactForce(m, d, i, force);
      const Vector3d at(c.pos),
          normal = (first ? -1.0 : 1.0) * Vector3d(c.frame);  // MuJoCo's points from the first geom to the second
      touch->at += at, touch->normal += normal, touch->load += force[0], touch->pressed += force[0] * at,
          ++touch->count;
    }
    return *this;
  }
  // The finger after this step, from what the pair remembers. Changes `pair.finger_at`.
  SoftFinger& step(const mjData* d, int body, const Touch& touch, Pair& pair) {
    const Vector3d origin(d->xpos + 3 * touch.object);
    outward_ = turn_of(d, touch.object);
    const Quaterniond inward = outward_.conjugate(), turn = inward * turn_of(d, body);
    const Vector3d at = inward * (Vector3d(d->xpos + 3 * body) - origin), normal = inward * touch.normal.normalized();
    const Vector3d point = inward * (touch.at / touch.count - origin) + pair.lever;
    // The way of the finger's material over the object since the last step, so that a ball may roll: where was what is
    // at the point now?
    const FingerState& state = pair.finger;
    Vector3d goal = point;
    if (state.spin.started) {
      const Quaterniond last(state.spin.scalar, state.spin.axis[0], state.spin.axis[1], state.spin.axis[2]);
      const Vector3d way = point - (pair.finger_at + last * (turn.conjugate() * (point - at)));
      const Vector3d n = (normal + state.sample.normal).normalized();
      goal = state.sample.goal + way - n * n.dot(way);  // by its steps a ball that rolls would sink
    }
    SoftFinger& soft = make_finger(pair);
    soft.restore(state);
    soft.update_under_load(goal, normal, pair.load, Orientation(turn), model_->opt.timestep);
    pair.finger_at = at, point_ = outward_ * point + origin;
    return soft;
  }
  // Friction on the finger, and its reaction, after `step`.
  void apply(mjData* d, int body, int object, const FingerOutput& out) const {
    const Vector3d force = outward_ * out.force, moment = outward_ * out.moment_vector(), back = -force,
                   turn_back = -moment;
    mj_applyFT(model_, d, force.data(), moment.data(), point_.data(), body, d->qfrc_passive);
    mj_applyFT(model_, d, back.data(), turn_back.data(), point_.data(), object, d->qfrc_passive);
  }
  // What a force along the contact, or a moment about its normal, accelerates.
  void weigh(mjData* d, int body, const Touch& touch, Pair& pair) const {
    const Vector3d at = touch.at / touch.count, n = touch.normal.normalized();
    Rows rows(6, model_->nv), of_object(6, model_->nv), moved(6, model_->nv);
    mj_jac(model_, d, rows.data(), rows.row(3).data(), at.data(), body);
    mj_jac(model_, d, of_object.data(), of_object.row(3).data(), at.data(), touch.object);
    rows -= of_object;
    mj_solveM(model_, d, moved.data(), rows.data(), 6);
    const Eigen::Matrix<double, 6, 6> weights = moved * rows.transpose();
    const Eigen::Matrix3d along = Eigen::Matrix3d::Identity() - n * n.transpose();
    pair.slide_weight = (along * weights.topLeftCorner<3, 3>() * along).norm();
    pair.twist_weight = n.dot(weights.bottomRightCorner<3, 3>() * n);
  }
  // Springs that MuJoCo's explicit steps bear, unless the user gives them: k T² w = q², b T w = q, w the weight that a
  // contact meets. n such contacts are stable while n (q² + 2q)/4, of slide and twist together, is below 1; with n =
  // `contacts` these are 0.55 and 0.35.
  SoftFinger& make_finger(const Pair& pair) {
    FingerParameters p = given_;
    const double q = std::sqrt(1 + 2.2 / contacts_) - 1, q_twist = std::sqrt(1 + 1.4 / contacts_) - 1,
                 T = model_->opt.timestep;
    const double slide = std::max(pair.slide_weight, 1e-9), twist = std::max(pair.twist_weight, 1e-9);
    p.stiffness = stiffness_.value_or(q * q / (T * T * slide));
    p.twist_stiffness = twist_stiffness_.value_or(q_twist * q_twist / (T * T * twist));
    p.damping = damping_.value_or(std::sqrt(p.stiffness / slide));
    p.twist_damping = twist_damping_.value_or(std::sqrt(p.twist_stiffness / twist));
    return soft_.emplace(curve_ ? SoftFinger(*curve_, p) : SoftFinger(*patch_, p));
  }
  const mjModel* model_;
  int instance_;
  std::vector<int> finger_of_, bodies;      // body -> index of `bodies`, or -1; and back
  std::vector<std::vector<Touch>> touches;  // of each of `bodies`
  FingerParameters given_;
  std::optional<double> stiffness_, twist_stiffness_, damping_, twist_damping_;
  double contacts_;  // on one object, at most
  std::optional<FingerCurve> curve_;
  std::optional<Patch> patch_;
  std::optional<SoftFinger> soft_;  // of the present step, as are the next two
  Vector3d point_;
  Quaterniond outward_;
};
Skin& skin(const mjData* d, int instance) {
  return *reinterpret_cast<Skin*>(d->plugin_data[instance]);
}
// visit(slot, pair, its touch or null, body, all touches of the body)
template <class Visit>
void each_pair(const mjModel* m, mjData* d, int instance, Skin& s, Visit&& visit) {
  mjtNum* slot = d->plugin_state + m->plugin_stateadr[instance];
  for (std::size_t b = 0; b < s.bodies.size(); ++b)
    for (int i = 0; i < most_objects; ++i, slot += pair_size) {
      Pair pair = load(slot);
      Touch* found = nullptr;
      for (auto& touch : s.touches[b])
        if (touch.count > 0 && touch.object + 1 == pair.object) found = &touch;
      visit(slot, pair, found, s.bodies[b], s.touches[b]);
    }
}
int init(const mjModel* m, mjData* d, int instance) try {
  return d->plugin_data[instance] = reinterpret_cast<uintptr_t>(new Skin(m, instance)), 0;
} catch (const std::exception& error) {
  return mju_warning("limitcurve.finger: %s", error.what()), -1;
}
void compute(const mjModel* m, mjData* d, int instance, int) {
  Skin& s = skin(d, instance);
  each_pair(m, d, instance, s.gather(m, d, false), [&](mjtNum*, Pair& pair, Touch* touch, int body, auto&) {
    if (touch) s.apply(d, body, touch->object, s.step(d, body, *touch, pair).output());
  });
}
void advance(const mjModel* m, mjData* d, int instance) {
  Skin& s = skin(d, instance).gather(m, d, true);
  const auto keep = [&](mjtNum* slot, Pair& pair, Touch& touch) {
    pair.load = touch.load, pair.lever = {0, 0, 0};
    if (pair.load > 0)
      pair.lever = turn_of(d, touch.object).conjugate() * (touch.pressed / touch.load - touch.at / touch.count);
    touch.count = 0, save(pair, slot);  // done
  };
  each_pair(m, d, instance, s, [&](mjtNum* slot, Pair& pair, Touch* touch, int body, auto&) {
    if (touch)
      pair.finger = s.step(d, body, *touch, pair).state(), keep(slot, pair, *touch);
    else if (pair.object != 0)
      save(Pair{}, slot);
  });
  each_pair(m, d, instance, s, [&](mjtNum* slot, Pair& pair, Touch*, int body, auto& touches) {
    const auto touch = std::find_if(touches.begin(), touches.end(), [](const auto& t) { return t.count > 0; });
    if (pair.object != 0 || touch == touches.end()) return;
    pair.object = touch->object + 1, s.weigh(d, body, *touch, pair), keep(slot, pair, *touch);
  });
}
// MuJoCo's structs change with every release: this library serves the one that it was compiled for.
[[gnu::constructor]] void register_plugin() {
  if (mj_version() != mjVERSION_HEADER)
    return mju_warning("limitcurve.finger is for MuJoCo %d, not %d", mjVERSION_HEADER, mj_version());
  mjpPlugin plugin;
  mjp_defaultPlugin(&plugin);
  plugin.name = "limitcurve.finger", plugin.attributes = keys, plugin.nattribute = std::size(keys);
  plugin.capabilityflags = mjPLUGIN_PASSIVE;
  plugin.nstate = [](const mjModel* m, int i) {
    return int(std::count(m->body_plugin, m->body_plugin + m->nbody, i)) * most_objects * pair_size;
  };
  plugin.init = init, plugin.compute = compute, plugin.advance = advance;
  plugin.destroy = [](mjData* d, int instance) { delete &skin(d, instance); };
  plugin.reset = [](const mjModel* m, mjtNum* state, void*, int instance) {
    mju_zero(state, m->plugin_statenum[instance]);
  };
  mjp_registerPlugin(&plugin);
}
}  // namespace
extern "C" [[gnu::visibility("default")]] int limitcurve_mujoco_version() {
  return mjVERSION_HEADER;
}
