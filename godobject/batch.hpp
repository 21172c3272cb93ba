// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_limits.hpp"
#include "godobject/finger.hpp"

#include <cstddef>
#include <span>
#include <vector>

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
  std::span<Real> proxy_angle;      ///< α_p [rad]
  std::span<ContactState> state;    ///< in and out; `free` to begin with
  std::span<ContactState> sliding;  ///< memory: `slip` while the sliding limit acts (FrictionMemory::slides); `free` to begin with
  std::span<ContactState> turning;  ///< likewise of the moment on a box (FrictionMemory::turns); else not touched
  std::span<Real> parameter;        ///< memory of the search (FrictionMemory); 0 to begin with
  std::span<Real> rate;             ///< likewise
  std::span<Real> force_x;          ///< friction on the user [N]
  std::span<Real> force_y;
  std::span<Real> moment;  ///< [N m]

  /// A contact beyond this [m, rad], or NaN, is a fault of the device: nothing of it is touched, its last output is held.
  static constexpr Real farthest = Real(1e6);

  /// `length` contacts from the one of index `from` on; both within the size.
  [[nodiscard]] BasicContactBatch part(std::size_t from, std::size_t length) const noexcept {
    const auto cut = [&](auto array) { return array.subspan(from, length); };
    return {cut(x),       cut(y),       cut(angle),     cut(depth), cut(proxy_x), cut(proxy_y), cut(proxy_angle), cut(state),
            cut(sliding), cut(turning), cut(parameter), cut(rate),  cut(force_x), cut(force_y), cut(moment)};
  }

  [[nodiscard]] std::size_t size() const noexcept { return x.size(); }
};

using ContactBatch = BasicContactBatch<double>;
using FloatContactBatch = BasicContactBatch<float>;

/// The arrays of a batch, allocated: contacts at the origin, free.
template <class Real>
class BasicContactArrays {
 public:
  /// Throws std::bad_alloc or std::length_error.
  explicit BasicContactArrays(std::size_t count)
      : count_(count), stride_((count + page - 1) / page * page + shift), state_(count), sliding_(count), turning_(count) {
    numbers_.resize(stride_ * arrays);
  }

  [[nodiscard]] std::size_t size() const noexcept { return count_; }

  /// What a step is to be given, to write to: units as in BasicContactBatch.
  [[nodiscard]] std::span<Real> x() noexcept { return array(0); }
  [[nodiscard]] std::span<Real> y() noexcept { return array(1); }
  [[nodiscard]] std::span<Real> angle() noexcept { return array(2); }
  [[nodiscard]] std::span<Real> depth() noexcept { return array(3); }

  /// For `BasicBatch::step`, as long as these arrays live.
  [[nodiscard]] BasicContactBatch<Real> batch() noexcept {
    return {array(0), array(1), array(2), array(3), array(4), array(5),  array(6), state_,
            sliding_, turning_, array(7), array(8), array(9), array(10), array(11)};
  }

 private:
  static constexpr std::size_t arrays = 12;
  // Arrays whole pages apart would share lines of the cache: each begins a little farther.
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

/// Step b for many contacts that share a limit curve and parameters: every curve and projection, μ_d < μ_s, a(P), Γ = 0, in double or
/// float. Dampers, faults, faded forces and unwrapped angles are a SoftFinger's.
///
///     const Batch batch(Table::build(hertz(), 1e-8), {.mu = 0.6});
///     ContactArrays arrays(10000);
///     batch.step(arrays.batch());  // every millisecond, after x, y, angle and depth are written
///
/// The results are those of one contact at a time, whatever the processor's vectors (README, "Batches"). Immutable; one may serve any
/// number of threads, each with a part of the arrays. Allocates at construction only.
template <class Real>
class BasicBatch {
 public:
  /// Throws std::invalid_argument naming parameter, value, unit and range. A box goes with the closest point only.
  BasicBatch(BasicFingerCurve<Real> curve, const FingerParameters& parameters, Projection projection = Projection::closest_point);

  /// Steps all contacts; the arrays must be of one length.
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
