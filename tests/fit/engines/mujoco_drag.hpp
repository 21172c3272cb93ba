// SPDX-License-Identifier: MIT
#pragma once

#include "tests/fit/engines/dragged.hpp"

#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace limitcurve::fit::engines {

struct DeleteMujocoModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteMujocoData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// A ball on a plane, pressed by its weight, on a slide and a hinge so inert that friction does not slow them.
inline std::string mujoco_scene(const EngineContact& contact, bool elliptic) {
  const auto number = [&](const char* parameter) { return std::to_string(coefficient(contact, parameter)); };
  std::array<char, 200> rubbing{};
  std::snprintf(rubbing.data(), rubbing.size(), "condim=\"%.0f\" friction=\"%.12g %.12g 0\"", coefficient(contact, "geom.condim"),
                coefficient(contact, "geom.friction[0]"), coefficient(contact, "geom.friction[1]"));
  const std::string impratio = elliptic ? number("option.impratio") : "1";
  return "<mujoco><option timestep=\"0.0005\" cone=\"" + std::string(elliptic ? "elliptic" : "pyramidal") + "\" impratio=\"" + impratio +
         "\" gravity=\"0 0 -10\" tolerance=\"0\" iterations=\"200\"/><worldbody>"
         "<geom type=\"plane\" size=\"0 0 1\" " +
         rubbing.data() +
         "/>"
         "<body pos=\"0 0 0.02\"><joint name=\"press\" type=\"slide\" axis=\"0 0 1\"/>"
         "<joint name=\"drag\" type=\"slide\" axis=\"1 0 0\" armature=\"1e6\"/>"
         "<joint name=\"turn\" type=\"hinge\" axis=\"0 0 1\" armature=\"1e3\"/>"
         "<geom type=\"sphere\" size=\"0.02\" mass=\"" +
         std::to_string(load / 10.0) + "\" " + rubbing.data() + "/></body></worldbody></mujoco>";
}

/// Contacts are soft: the friction of slow slip is viscous, and fast slip lifts the finger off until it hops. Where the ellipse
/// is fully reached and the finger still rests depends on the cone.
inline constexpr double elliptic_speed = 0.003;  // [m/s]
inline constexpr double pyramidal_speed = 0.03;  // hops now and then: the last step with a contact is taken

/// A finger in MuJoCo.
inline Measured drag_in_mujoco(const EngineContact& contact, bool elliptic, SlipTwist twist) {
  const std::string xml = mujoco_scene(contact, elliptic);
  const std::string file =
      (std::filesystem::temp_directory_path() / "limitcurve_mujoco_").string() + std::to_string(std::hash<std::string>{}(xml)) + ".xml";
  std::FILE* const out = std::fopen(file.c_str(), "w");
  if (out == nullptr) throw std::runtime_error("cannot write " + file);
  std::fputs(xml.c_str(), out);
  std::fclose(out);
  std::array<char, 1000> error{};
  const std::unique_ptr<mjModel, DeleteMujocoModel> model(mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  std::remove(file.c_str());
  if (!model) throw std::runtime_error(error.data());
  const std::unique_ptr<mjData, DeleteMujocoData> data(mj_makeData(model.get()));
  const double radius = radius_law().radius(load);
  const double speed = elliptic ? elliptic_speed : pyramidal_speed;
  Measured measured;
  for (int step = 0; step < 2000; ++step) {
    data->qvel[1] = speed * twist.slide;
    data->qvel[2] = speed * twist.spin / radius;
    mj_forward(model.get(), data.get());
    if (data->ncon == 1) {
      std::array<mjtNum, 6> force{};
      mj_contactForce(model.get(), data.get(), 0, force.data());
      const double limit = friction * force[0];
      if (limit > 0.0) measured = {{std::hypot(force[1], force[2]) / limit, std::fabs(force[3]) / (limit * radius)}, force[0]};
    }
    mj_step(model.get(), data.get());
  }
  return measured;
}

}  // namespace limitcurve::fit::engines
