// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/batch/step.hpp"
#include "limitcurve/kernel/pack.hpp"
#ifdef __x86_64__
#include "limitcurve/kernel/pack_x86.hpp"
#endif

#include <cstddef>

/// The step of a batch by packs. Powers, logarithms and the c-curve are computed lane by lane, by functions of other
/// sources: this one may be compiled for a processor that not every user has.
namespace limitcurve::kernel {

// Here because the step finds them by the type of its numbers.
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> radius_at(const RadiusLaw& law, Pack<Real, Isa> load) noexcept {
  Lanes<Real, Isa> lanes = lanes_of(load);
  for (Real& lane : lanes) lane = godobject::radius_at(law, lane);
  return pack_of<Isa>(lanes);
}

template <class Real, class Isa>
[[nodiscard]] godobject::Projected<Pack<Real, Isa>> project_along_c_curve(
    const CurveView<Real>& curve, const godobject::UnitTrial<Pack<Real, Isa>>& trial, Pack<Real, Isa> last,
    const RadiusLaw& radius_law, Pack<Real, Isa> load) noexcept {
  const auto force = lanes_of(trial.force), moment = lanes_of(trial.moment),
             compliance_ratio = lanes_of(trial.compliance_ratio), slip_from = lanes_of(trial.slip_from),
             parameter = lanes_of(last), loads = lanes_of(load);
  Lanes<Real, Isa> exceeds, force_fraction, moment_fraction, slide, spin, next;
  for (std::size_t i = 0; i < exceeds.size(); ++i) {
    const godobject::Projected<Real> lane = godobject::project_along_c_curve(
        curve, {force[i], moment[i], compliance_ratio[i], slip_from[i]}, parameter[i], radius_law, loads[i]);
    exceeds[i] = lane.exceeds ? Real(1) : Real(0);
    force_fraction[i] = lane.force_fraction;
    moment_fraction[i] = lane.moment_fraction;
    slide[i] = lane.slide;
    spin[i] = lane.spin;
    next[i] = lane.parameter;
  }
  return {pack_of<Isa>(exceeds) > Pack<Real, Isa>(Real(0)),
          pack_of<Isa>(force_fraction),
          pack_of<Isa>(moment_fraction),
          pack_of<Isa>(slide),
          pack_of<Isa>(spin),
          pack_of<Isa>(next)};
}

}  // namespace limitcurve::kernel

namespace limitcurve::godobject::kernel {

/// All functions of a step are inlined into one loop, so that numbers stay in registers.
template <class Isa, class Real>
[[gnu::flatten]] std::size_t step_packs(const Shared<Real>& shared, const BasicContactBatch<Real>& contacts,
                                        std::size_t count) noexcept {
  using Number = Pack<Real, Isa>;
  // Copies, so that they need not be read again after each number that is written.
  const BasicContactBatch<Real> arrays = contacts;
  const CurveView<Real> curve = shared.curve;
  const Shared<Real> same{curve, shared.projection, shared.limits, shared.stiffness, shared.twist_stiffness};
  std::size_t i = 0;
  for (; i + Number::size <= count; i += Number::size) step_contacts<Real, Number>(same, arrays, i);
  return i;
}

}  // namespace limitcurve::godobject::kernel
