// SPDX-License-Identifier: MIT
#pragma once

#include "../contact_limits.hpp"
#include "../finger.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// Many contacts as a structure of arrays, each contact in its own tangent plane: position and depth of the finger
/// (in), the proxy (in and out), and the friction wrench on the user (out). All arrays have the same length, and must
/// not overlap.
///
/// A sample that is not plausible (`farthest`), a NaN among them, is a fault of the device. The contact's state is then
/// `invalid`, and nothing else of the contact changes, so that the last output is held. A proxy that is not finite, or
/// whose distance and angle from the finger add up to more than 4e6, is a fault until the contact ends.
///
/// A float takes half the memory of a double, but resolves 6e-8 of a coordinate. For example, that is 60 nm at 1 m from
/// the origin, while slips are micrometres. Therefore give positions relative to a point near the contact (the object's
/// origin, the touch-down), and angles within a few turns. A slip below the resolution does not move the proxy, and
/// counts as held.
///
/// If contacts twist, μ_d and mu_r_dynamic should not be 0. Otherwise the rounding of the component that has no limit
/// can let the other exceed its limit by up to the limit itself, and in floats the other can vanish. `SoftFinger` takes
/// any.
template <class Real>
struct BasicContactBatch {
  std::span<const Real> x;  ///< x_g [m]
  std::span<const Real> y;
  std::span<const Real> twist;  ///< α_g [rad], unwrapped
  std::span<const Real> depth;  ///< d [m]; ≤ 0: free, the proxy follows the finger
  std::span<Real> proxy_x;      ///< x_p [m]
  std::span<Real> proxy_y;
  std::span<Real> proxy_angle;    ///< α_p [rad]
  std::span<ContactState> state;  ///< in and out; initially `free`, `invalid` after a fault
  std::span<ContactState>
      force_slides;  ///< memory: `slip` while the sliding limit acts, else `stick`; initially `free`
  std::span<ContactState> moment_slides;  ///< on a box, `force_slides` of the moment; otherwise not used
  std::span<Real> search_start;           ///< warm start of the search (FrictionMemory); initially 0
  std::span<Real> search_rate;            ///< its rate; initially 0
  std::span<Real> fx;                     ///< friction on the user [N]
  std::span<Real> fy;
  std::span<Real> moment;  ///< [N m]

  /// The contacts with indices from `from` to from + length − 1, which must exist.
  [[nodiscard]] BasicContactBatch part(std::size_t from, std::size_t length) const noexcept {
    const auto cut = [&](auto array) { return array.subspan(from, length); };
    return {cut(x),           cut(y),     cut(twist),        cut(depth),         cut(proxy_x),      cut(proxy_y),
            cut(proxy_angle), cut(state), cut(force_slides), cut(moment_slides), cut(search_start), cut(search_rate),
            cut(fx),          cut(fy),    cut(moment)};
  }

  [[nodiscard]] std::size_t size() const noexcept { return x.size(); }
};

using ContactBatch = BasicContactBatch<double>;
using FloatContactBatch = BasicContactBatch<float>;

/// Allocates the arrays of a batch. Initially all contacts are free and at the origin.
template <class Real>
class BasicContactArrays {
 public:
  /// Throws std::bad_alloc or std::length_error.
  explicit BasicContactArrays(std::size_t count)
      : count_(count),
        stride_((count + page - 1) / page * page + shift),
        state_(count),
        sliding_(count),
        turning_(count) {
    numbers_.resize(stride_ * arrays);
  }

  [[nodiscard]] std::size_t size() const noexcept { return count_; }

  /// The input of a step, to which you should write. Units as in BasicContactBatch.
  [[nodiscard]] std::span<Real> x() noexcept { return array(0); }
  [[nodiscard]] std::span<Real> y() noexcept { return array(1); }
  [[nodiscard]] std::span<Real> twist() noexcept { return array(2); }
  [[nodiscard]] std::span<Real> depth() noexcept { return array(3); }

  /// The view for `BasicBatch::step`. Valid as long as this object.
  [[nodiscard]] BasicContactBatch<Real> batch() noexcept {
    return {array(0), array(1), array(2), array(3), array(4), array(5),  array(6), state_,
            sliding_, turning_, array(7), array(8), array(9), array(10), array(11)};
  }

 private:
  static constexpr std::size_t arrays = 12;
  // Arrays at a distance of whole pages would compete for the same cache lines: shift each a little.
  static constexpr std::size_t page = 4096 / sizeof(Real);
  static constexpr std::size_t shift = 320 / sizeof(Real);

  [[nodiscard]] std::span<Real> array(std::size_t i) noexcept { return {numbers_.data() + i * stride_, count_}; }

  std::size_t count_;
  std::size_t stride_;
  std::vector<Real> numbers_;
  std::vector<ContactState> state_;
  std::vector<ContactState> sliding_;
  std::vector<ContactState> turning_;
};

using ContactArrays = BasicContactArrays<double>;
using FloatContactArrays = BasicContactArrays<float>;

/// The friction step (step b) of many contacts that share a limit curve and parameters: every curve and projection, μ_d
/// < μ_s, a(P), Γ = 0, in double or float. Unlike SoftFinger it has no dampers, no fading output and no unwrapping of
/// angles.
///
///     const Batch batch(Table::build(hertz(), 1e-8), {.mu = 0.6});
///     ContactArrays arrays(10000);
///     batch.step(arrays.batch());  // every millisecond, after x, y, twist and depth are written
///
/// Results have the same bits on every instruction set. Immutable: any number of threads may share a batch, if each
/// thread has a part of the arrays. Allocates at construction only. Cost: docs/speed.md.
template <class Real>
class BasicBatch {
 public:
  /// Throws std::invalid_argument with parameter, value, unit and range. A box requires the closest point.
  BasicBatch(BasicFingerCurve<Real> curve, const FingerParameters& parameters,
             Projection projection = Projection::closest_point);

  /// Steps all contacts. The arrays must have the same length. Does not throw, allocate or lock.
  void step(const BasicContactBatch<Real>& contacts) const noexcept;

 private:
  BasicFingerCurve<Real> curve_;
  ContactLimits limits_;
  Projection projection_;
  Real stiffness_;
  Real twist_stiffness_;
};

extern template class BasicBatch<double>;
extern template class BasicBatch<float>;

using Batch = BasicBatch<double>;
using FloatBatch = BasicBatch<float>;

}  // namespace limitcurve::godobject
