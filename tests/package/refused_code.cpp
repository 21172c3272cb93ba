// SPDX-License-Identifier: MIT
// What a user may write by mistake: with WRONG every marked line must not compile, and the compiler must say the words
// after the mark; without it the file compiles (refused_code.py).
#include "godobject/batch/batch.hpp"
#include "godobject/body/grasp.hpp"
#include "godobject/godobject.hpp"
#include "godobject/scene/replay.hpp"
#include "limitcurve/limitcurve.hpp"
#include "limitcurve/patch/patch.hpp"

#include <array>
#include <vector>

using namespace limitcurve;
using namespace limitcurve::godobject;

Table table() {
  return Table::build(hertz(), 1e-6);
}
SoftFinger finger() {
  return SoftFinger(table(), {.mu = 0.6});
}
Grasp grasp() {
  return Grasp({}, {}, AnySurface(PlaneSurface{}), std::vector<SoftFinger>{finger()});
}
Replay replay() {
  return Replay({.law = hertz()});
}

#ifdef WRONG
SoftFinger of_law = SoftFinger(hertz(), {.mu = 0.6});    // wrong: not a pressure law: write Table::build(law)
const Law law = parse_law("power:n=2");                  //
FloatBatch float_of_law = FloatBatch(law, {.mu = 0.6});  // wrong: not a pressure law: write Table::build(law)
const auto& state = finger().state();                    // wrong: deleted
const auto& curve = finger().curve();                    // wrong: deleted
const auto& parameters = finger().parameters();          // wrong: deleted
const auto& view = FingerCurve(table()).view();          // wrong: deleted
const auto& of_grasp = grasp().finger(0);                // wrong: deleted
const auto& body = grasp().body();                       // wrong: deleted
const auto contacts = replay().contacts();               // wrong: deleted
const auto& of_replay = replay().body();                 // wrong: deleted
const auto& moved = std::move(finger()).state();         // wrong: deleted
#else
int main() {
  const SoftFinger named = finger();
  const auto& state = named.state();
  const FingerOutput output = finger().output();
  const Grasp held = grasp();
  const auto& first = held.finger(0).state();
  const Batch batch(table(), {.mu = 0.6});
  return state.in_contact || first.in_contact || output.state == ContactState::slip;
}
#endif
