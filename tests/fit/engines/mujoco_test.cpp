// SPDX-License-Identifier: MIT
//
// A finger in MuJoCo, given the translated coefficients and dragged about imposed centres of rotation.
#include "tests/fit/engines/dragged.hpp"

#include "limitcurve/ellipse.hpp"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace limitcurve::fit::engines {
namespace {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// A ball on a plane, pressed by its weight, on a slide and a hinge so inert that friction does not slow them.
std::string scene(const EngineContact& contact, bool elliptic) {
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

struct Measured {
  UnitWrench wrench;  ///< over μN and μNa, N being the normal force of the same step
  double normal = 0.0;
};

/// Contacts are soft: the friction of slow slip is viscous, and fast slip lifts the finger off until it hops. Where the ellipse
/// is fully reached and the finger still rests depends on the cone.
constexpr double elliptic_speed = 0.003;  // [m/s]
constexpr double pyramidal_speed = 0.03;  // hops now and then: the last step with a contact is taken

Measured drag(const EngineContact& contact, bool elliptic, SlipTwist twist) {
  const std::string xml = scene(contact, elliptic);
  const std::string file = testing::TempDir() + "limitcurve_mujoco_" + std::to_string(std::hash<std::string>{}(xml)) + ".xml";
  std::FILE* const out = std::fopen(file.c_str(), "w");
  if (out == nullptr) throw std::runtime_error("cannot write " + file);
  std::fputs(xml.c_str(), out);
  std::fclose(out);
  std::array<char, 1000> error{};
  const std::unique_ptr<mjModel, DeleteModel> model(mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  std::remove(file.c_str());
  if (!model) throw std::runtime_error(error.data());
  const std::unique_ptr<mjData, DeleteData> data(mj_makeData(model.get()));
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

TEST(MujocoElliptic, IsTheEllipseThroughTheExactIntercepts) {
  const EngineContact contact = translated("mujoco", "ellipse");
  const double moment_ratio = law()->moment_ratio();
  const Ellipse ellipse = Ellipse::through_intercepts(moment_ratio);
  for (const SlipTwist twist : twists) {
    const Measured measured = drag(contact, true, twist);
    EXPECT_NEAR(measured.normal, load, 1e-6 * load);
    const UnitWrench expected = ellipse.wrench(twist);
    EXPECT_NEAR(measured.wrench.force, expected.force, 1e-4) << "c/a = " << twist.cor();
    EXPECT_NEAR(measured.wrench.moment / moment_ratio, expected.moment / moment_ratio, 1e-4) << "c/a = " << twist.cor();
  }
}

TEST(MujocoPyramidal, IsADiamondThroughTheExactIntercepts) {
  const EngineContact contact = translated("mujoco", "diamond");
  const double moment_ratio = law()->moment_ratio();
  for (const SlipTwist twist : twists) {
    const Measured measured = drag(contact, false, twist);
    // On the face, or in a corner: the shares add up to the whole.
    EXPECT_NEAR(measured.wrench.force + measured.wrench.moment / moment_ratio, 1.0, 1e-4) << "c/a = " << twist.cor();
  }
  EXPECT_NEAR(drag(contact, false, {1.0, 0.0}).wrench.force, 1.0, 1e-4);
  EXPECT_NEAR(drag(contact, false, {0.0, 1.0}).wrench.moment / moment_ratio, 1.0, 1e-4);
}

}  // namespace
}  // namespace limitcurve::fit::engines
