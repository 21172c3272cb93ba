// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"

#include <cstddef>
#include <span>

namespace limitcurve::godobject {

/// Many contacts at once, as a structure of arrays of one length, each contact in its own tangent plane: where the finger
/// is, and how deep (in), where the proxy is (in and out), and what the user feels (out). The arrays must not overlap.
///
/// Of floats it takes half the memory, but they resolve 6e-8 of a coordinate: at 1 m from the origin 60 nm, against slips of
/// micrometres and springs deflected by a millimetre. So give positions relative to a place near the contact (the object's origin, the
/// touch-down), and angles within a few turns. What a position cannot resolve does not move a proxy: within that a contact
/// counts as held.
template <class Real>
struct BasicContactBatch {
  std::span<const Real> x;  ///< x_g [m], up to farthest
  std::span<const Real> y;
  std::span<const Real> angle;  ///< α_g [rad], unwrapped
  std::span<const Real> depth;  ///< d [m]; ≤ 0 (or NaN): free, the proxy goes with the finger
  std::span<Real> proxy_x;      ///< x_p [m]
  std::span<Real> proxy_y;
  std::span<Real> proxy_angle;    ///< α_p [rad]
  std::span<ContactState> state;  ///< in and out; `free` to begin with
  std::span<Real> parameter;      ///< memory of the search (FrictionMemory); 0 to begin with
  std::span<Real> rate;           ///< likewise
  std::span<Real> force_x;        ///< friction on the user [N]
  std::span<Real> force_y;
  std::span<Real> moment;  ///< [N m]

  /// A contact beyond this [m, rad], or NaN, is a fault of the device: nothing of it is touched, its last output is held.
  static constexpr Real farthest = Real(1e6);

  /// `length` contacts from the one of index `from` on; both within the size.
  [[nodiscard]] BasicContactBatch part(std::size_t from, std::size_t length) const noexcept {
    const auto cut = [&](auto array) { return array.subspan(from, length); };
    return {cut(x),     cut(y),         cut(angle), cut(depth),   cut(proxy_x), cut(proxy_y), cut(proxy_angle),
            cut(state), cut(parameter), cut(rate),  cut(force_x), cut(force_y), cut(moment)};
  }

  [[nodiscard]] std::size_t size() const noexcept { return x.size(); }
};

using ContactBatch = BasicContactBatch<double>;
using FloatContactBatch = BasicContactBatch<float>;

}  // namespace limitcurve::godobject
