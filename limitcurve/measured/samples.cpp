// SPDX-License-Identifier: MIT
// Notation:
//   ρ, g(ρ)    radius over rim, and pressure of load 1, ∫ 2ρ g dρ = 1: a cubic from sample to sample (Piece)
//   run        the samples between two jumps of the pressure
//   g′         the same through fewer samples (`coarser`), from which the error is estimated
//   Λ, Λ′      the load within ρ of g and of g′
//   δⱼ         change of the load of the gap j between samples, from g to g′
//   Dᵢ         bound on |Λ − Λ′| in the cell i between the radii `edges_`: `differences_`
//   K_f, K_m   force and moment of a ring of load 1 at ρ
#include "limitcurve/measured/samples.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/measured/cubic_pieces.hpp"
#include "limitcurve/measured/monotone_cubic.hpp"
#include "limitcurve/measured/own_radii.hpp"
#include "limitcurve/measured/signed_noise.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/quadrature/evaluators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve {

namespace {

using Piece = CubicPieces::Piece;

/// Indices in `rows` of the samples, without rows that repeat the one before.
std::vector<std::size_t> places_of_samples(std::span<const PressureSample> rows) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows[i].radius != rows[i - 1].radius || rows[i].pressure != rows[i - 1].pressure) places.push_back(i);
  }
  return places;
}

/// The profile with an estimate of its interpolation error, from the change of the wrench if samples are left out
/// (`coarser`). Let Λ(ρ) be the load within ρ, Λ′ that of the samples that stay, and K(ρ) the force or the moment of a
/// ring of load 1, which is monotone: then the change is ∫ (Λ − Λ′) dK. In cells between radii ρᵢ, with Dᵢ a safety
/// factor times the largest change in the cell and its neighbours, but ≤ 1:
///   |Δf| ≤ min(Σ Dᵢ (K_f(ρᵢ) − K_f(ρᵢ₊₁)), s ∫ 2|g − g′| dρ),  |Δm| ≤ Σ Dᵢ (K_m(ρᵢ₊₁) − K_m(ρᵢ)).
/// This is 0 for pure sliding, and never more than profiles on the disc can differ. The difference of both wrenches
/// would be no estimate: it changes sign, and is 0 at some s. The largest change is that of |Λ − Λ′| and of √((1 − Λ)²
/// Σ_in δⱼ² + Λ² Σ_out δⱼ²), δⱼ the change of the load of the gap j: Λ − Λ′ sums them with signs, (1 − Λ) Σ_in δⱼ − Λ
/// Σ_out δⱼ, and if they happen to cancel, then errors of other orders do not; of independent signs the sum is about
/// the root of the squares.
class SamplesLaw final : public PressureLawOf<SamplesLaw> {
 public:
  /// `named_rim` 0: the last radius is the rim. `notes` are remarks on the data. `is_rim_told`: by the user.
  SamplesLaw(std::span<const PressureSample> profile, std::string_view source, double named_rim,
             std::vector<std::string> notes, bool is_rim_told)
      : source_(source),
        named_rim_(named_rim),
        rim_(named_rim > 0.0 ? named_rim : profile.back().radius),
        is_rim_told_(is_rim_told),
        notes_(std::move(notes)),
        profile_(profile.begin(), profile.end()),
        pieces_(cubics(profile, source, rim_, named_rim > 0.0)) {
    for (const Piece& piece : pieces_.pieces()) breaks_.push_back(piece.left);
    breaks_.push_back(named_rim > 0.0 ? pieces_.pieces().back().left + pieces_.pieces().back().width : 1);
    double highest = 0.0;
    for (const PressureSample& sample : profile) highest = std::max(highest, sample.pressure);
    // If gaps double, an error of order p changes by 2ᵖ − 1 times itself: p ≥ 1, but 1/2 if the pressure is unbounded
    // at the rim.
    const std::size_t last = profile.size() - 1;
    const bool ends_in_jump = profile[last].radius == profile[last - 1].radius;
    const bool high_rim = profile[ends_in_jump ? last - 1 : last].pressure > 0.5 * highest;
    const double safety = high_rim ? 6.0 : 3.0;
    const CubicPieces coarse =
        cubics(coarser(profile, high_rim ? 1.0 / 6.0 : 1.0 / 3.0), source, rim_, named_rim > 0.0);
    constexpr std::size_t most_cells = 64;
    const std::size_t pieces =
        breaks_.size() - (profile.back().radius < rim_ ? 2 : 1);  // without the last, which is empty
    const std::size_t pieces_per_cell = (pieces + most_cells - 1) / most_cells;
    struct Within {
      double load;     ///< Λ at the outer end of a piece
      double squares;  ///< Σ δⱼ² of the gaps before
      double largest;  ///< |Λ − Λ′| in the piece
    };
    std::vector<Within> within;
    double difference = 0.0;  // Λ − Λ′
    double load = 0.0;
    double squares = 0.0;
    double before_gap = 0.0;
    const auto end_gap = [&] {
      squares += (difference - before_gap) * (difference - before_gap);
      before_gap = difference;
    };
    auto gap = coarse.pieces().begin();
    for (std::size_t i = 0; i < pieces; ++i) {
      if (gap != coarse.pieces().end() && gap->left == breaks_[i]) {
        end_gap();
        ++gap;
      }
      double largest = std::fabs(difference);
      // The midpoint rule suffices: an estimate needs few digits.
      constexpr int parts = 32;
      const double width = static_cast<double>(breaks_[i + 1] - breaks_[i]) / parts;
      for (int k = 0; k < parts; ++k) {
        const double rho = static_cast<double>(breaks_[i]) + (k + 0.5) * width;
        const double change = 2.0 * width * (pieces_(rho) - coarse(rho));
        distance_ += std::fabs(change);
        difference += rho * change;
        load += 2.0 * width * rho * pieces_(rho);
        largest = std::max(largest, std::fabs(difference));
      }
      within.push_back({load, squares, largest});
    }
    end_gap();
    std::vector<double> largest;
    for (std::size_t i = 0; i < pieces; ++i) {
      if (i % pieces_per_cell == 0) largest.push_back(0.0);
      const auto [inside, squares_inside, change] = within[i];
      const double by_chance =
          std::sqrt((1.0 - inside) * (1.0 - inside) * squares_inside + inside * inside * (squares - squares_inside));
      largest.back() = std::max({largest.back(), change, by_chance});
      if ((i + 1) % pieces_per_cell == 0 || i + 1 == pieces) edges_.push_back(static_cast<double>(breaks_[i + 1]));
    }
    largest.push_back(0.0);
    // Λ − Λ′ passes through 0: neighbours count, too.
    for (std::size_t i = 0; i < edges_.size(); ++i)
      differences_.push_back(
          std::min(1.0, safety * std::max({largest[i > 0 ? i - 1 : 0], largest[i], largest[i + 1]})));
    // Between the last sample and a rim farther out the pressure may go on as high as there.
    if (const double unknown = unknown_load(); unknown > 0.0) {
      for (double& cell : differences_) cell = std::min(1.0, cell + unknown);
      edges_.push_back(1.0);
      differences_.push_back(unknown);
      distance_ = std::numeric_limits<double>::max();
    }
  }

  std::string name() const override {
    return "samples:" + source_ + (named_rim_ > 0.0 ? ",rim=" + format_number(named_rim_) : "");
  }
  double rim() const noexcept override { return rim_; }
  [[nodiscard]] Law with_own_radii() const {
    return std::make_shared<SamplesLaw>(profile_, source_, named_rim_ > 0.0 ? named_rim_ : profile_.back().radius,
                                        notes_, is_rim_told_);
  }
  std::vector<std::string> remarks() const override {
    constexpr double least_moment_ratio =
        0.45;  // Hertz 0.59, a Gaussian of sigma 0.4 0.47; noise and offsets beyond the contact less
    std::vector<std::string> lines = notes_;
    const double ratio = moment_ratio();
    const double tail = flat_tail();
    if (!is_rim_told_ && tail > 0.0) {
      lines.push_back("warning: " + source_ + ": a flat pressure in the outer tenth carries " +
                      format_number(100.0 * tail, 2) +
                      " % of the moment of a pure twist; if that is noise or an offset of the sensor, subtract it and "
                      "name the contact's rim=RADIUS");
    } else if (!is_rim_told_ && ratio < least_moment_ratio) {
      lines.push_back("warning: " + source_ + ": the mean radius of its load is " + format_number(ratio * rim_, 3) +
                      ", but the contact radius stands for the last radius with pressure, " + format_number(rim_, 3) +
                      ": is that noise or an offset of the sensor? rim=RADIUS names the radius that it stands for");
    }
    const auto [load, moment] = beyond_rim();
    if (load > 0.0) {
      lines.push_back("note: " + source_ + ": " + format_number(100.0 * load, 3) + " % of the load and " +
                      format_number(100.0 * moment / ratio, 3) + " % of the moment of a pure twist lie beyond rim=" +
                      format_number(named_rim_) + ": is that an offset of the sensor, or the rim in another unit?");
    }
    const double first = profile_.front().radius;
    const double last = profile_.back().radius;
    const double unknown = unknown_load();
    if (unknown > 0.01 || last < 0.5 * rim_) {
      lines.push_back("warning: " + source_ + ": from the last sample, at " + format_number(last) +
                      ", to rim=" + format_number(rim_) + " the pressure counts as 0" +
                      (unknown > 0.0 ? ", but may be another " + format_number(100.0 * unknown, 2) + " % of the load"
                                     : std::string()) +
                      ": is the profile cut off, or the rim in another unit?");
    }
    const double inside = static_cast<double>(pieces_(Extended(0))) * (first / rim_) * (first / rim_);
    if (inside > 0.01 && first > 1.5 * (profile_[1].radius - first)) {
      lines.push_back("warning: " + source_ + ": from the centre to the first sample, at " + format_number(first) +
                      ", the pressure counts as that of the first sample, " + format_number(100.0 * inside, 2) +
                      " % of the load: a contact with a hole needs samples of pressure 0");
    }
    return lines;
  }
  /// The moment's share of the outer tenth of the radius if the pressure there is small and as in the tenth before,
  /// more than a hundredth; else 0. The pressure of a contact falls.
  [[nodiscard]] double flat_tail() const {
    constexpr int points = 400;
    std::array<double, 10> pressures{};
    std::array<double, 10> moments{};
    double most = 0.0;
    double moment = 0.0;
    for (int i = 0; i < points; ++i) {
      const double radius = (i + 0.5) / points;
      const auto pressure = static_cast<double>(pieces_(Extended(radius)));
      const auto tenth = static_cast<std::size_t>(10.0 * radius);
      pressures.at(tenth) += 10.0 * pressure / points;
      moments.at(tenth) += pressure * radius * radius;
      moment += pressure * radius * radius;
      most = std::max(most, pressure);
    }
    const bool is_flat = pressures[9] < 0.1 * most && std::fabs(pressures[9] - pressures[8]) < 0.25 * pressures[8];
    return is_flat && moments[9] > 0.01 * moment ? moments[9] / moment : 0.0;
  }
  const std::vector<Extended>& breaks() const noexcept override { return breaks_; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    return pieces_(at.radius);
  }

  UnitForces<double> forces(double s, Slope slope) const noexcept override {
    return evaluators::ring(pieces_, s, slope).forces;
  }
  Quadrature<Extended> unrounded(Extended s, Slope slope) const noexcept override {
    return evaluators::ring(pieces_, s, slope);
  }
  Quadrature<double> line_profile(double t) const noexcept override { return evaluators::line_profile(pieces_, t); }
  WrenchEstimate evaluate(double s, Method method) const noexcept override {
    s = std::fabs(s);
    WrenchEstimate estimate = method == Method::automatic ? evaluators::rounded(unrounded(s, Slope::wanted))
                                                          : PressureLaw::evaluate(s, method);
    double force = 0.0;
    double moment = 0.0;
    UnitWrench before{1.0, 0.0};
    for (std::size_t i = 0; i < edges_.size() && std::isfinite(s); ++i) {
      const UnitWrench ring = evaluators::ring_wrench(edges_[i], s);
      force += differences_[i] * (before.force - ring.force);
      moment += differences_[i] * (ring.moment - before.moment);
      before = ring;
    }
    estimate.error.force += std::min(force, s * distance_);
    estimate.error.moment += moment;
    return estimate;
  }
  double profile_error() const noexcept override {
    return *std::max_element(differences_.begin(), differences_.end()) * std::max(1.0, edges_.back());
  }

 private:
  /// The share of the load that would lie between the last sample and the rim if the pressure went on there.
  [[nodiscard]] double unknown_load() const {
    const double last = profile_.back().radius / rim_;
    if (!(last < 1.0) || profile_.back().pressure == 0.0) return 0.0;
    const double load = static_cast<double>(pieces_(Extended(last * (1.0 - 1e-12)))) * (1.0 - last * last);
    return load / (1.0 + load);
  }
  /// Load and moment of a pure twist beyond the rim.
  [[nodiscard]] std::pair<double, double> beyond_rim() const {
    std::pair<double, double> sum{0.0, 0.0};
    for (const Piece& piece : pieces_.pieces()) {
      constexpr int parts = 32;
      const double begin = std::max(static_cast<double>(piece.left), 1.0);
      const double width = (static_cast<double>(piece.left + piece.width) - begin) / parts;
      for (int k = 0; k < parts && width > 0.0; ++k) {
        const double rho = begin + (k + 0.5) * width;
        const double load = 2.0 * rho * width * piece(rho);
        sum.first += load;
        sum.second += rho * load;
      }
    }
    return sum;
  }

  /// The profile with samples left out, so that each gap is about twice as wide as the widest gap of the profile within
  /// it, or wider: of even radii every other sample. A narrow gap beside a wide one tells nothing about it. The ends of
  /// each run between jumps stay; gaps are merged from the run's outer end, and what is left at its inner end joins the
  /// last. A run with a gap wider than the share `widest_share` of it has too little to compare with (if the pressure
  /// may be unbounded at the rim, a sixth: a wide last gap between a nearly constant pressure and a high one is much
  /// the same twice as wide): each gap becomes constant at its higher pressure, as far from it as any profile that does
  /// not overshoot. So does a run that would lose all its pressure, as a ring between two samples.
  static std::vector<PressureSample> coarser(std::span<const PressureSample> profile, double widest_share) {
    constexpr double about_twice = 1.8;
    constexpr double rounding = 1e-9;  // of radii that are meant to be even
    std::vector<PressureSample> kept;
    for (std::size_t begin = 0; begin < profile.size();) {
      std::size_t last = begin;
      while (last + 1 < profile.size() && profile[last + 1].radius > profile[last].radius) ++last;
      std::vector<std::size_t> places{last};
      double widest = 0.0;
      double widest_of_run = 0.0;
      for (std::size_t i = last; i-- > begin;) {
        widest = std::max(widest, profile[i + 1].radius - profile[i].radius);
        widest_of_run = std::max(widest, widest_of_run);
        if (profile[places.back()].radius - profile[i].radius < about_twice * widest) continue;
        places.push_back(i);
        widest = 0.0;
      }
      places.back() = begin;
      const bool loses_all = last > begin && std::none_of(places.begin(), places.end(), [&](std::size_t place) {
                               return profile[place].pressure > 0.0;
                             });
      if (loses_all ||
          widest_of_run > (1.0 + rounding) * widest_share * (profile[last].radius - profile[begin].radius)) {
        for (std::size_t i = begin; i < last; ++i) {
          const double higher = std::max(profile[i].pressure, profile[i + 1].pressure);
          kept.insert(kept.end(), {{profile[i].radius, higher}, {profile[i + 1].radius, higher}});
        }
      } else {
        for (auto place = places.rbegin(); place != places.rend(); ++place) kept.push_back(profile[*place]);
      }
      begin = last + 1;
    }
    return kept;
  }

  std::string source_;
  double named_rim_;
  double rim_;
  bool is_rim_told_;
  std::vector<std::string> notes_;
  std::vector<PressureSample> profile_;
  CubicPieces pieces_;
  std::vector<Extended> breaks_;
  std::vector<double> edges_;        ///< outer ends of the cells
  std::vector<double> differences_;  ///< Dᵢ
  double distance_ = 0.0;            ///< ∫ 2|g − g′| dρ
};

}  // namespace

Law with_own_radii(const Law& law) {
  const auto* const measured = dynamic_cast<const SamplesLaw*>(law.get());
  return measured == nullptr ? law : measured->with_own_radii();
}

Law samples(std::span<const PressureSample> rows, std::string_view source, double rim) {
  const std::vector<std::size_t> places = places_of_samples(rows);
  std::vector<PressureSample> profile;
  for (const std::size_t place : places) profile.push_back(rows[place]);
  const auto refuse = [&](std::size_t i, const std::string& what) {
    return std::invalid_argument("profile '" + std::string(source) + "', sample " + std::to_string(places[i] + 1) +
                                 " (radius " + format_number(profile[i].radius) + ", pressure " +
                                 format_number(profile[i].pressure) + "): " + what);
  };
  if (profile.size() < 4) {
    throw std::invalid_argument("profile '" + std::string(source) + "' has " + std::to_string(profile.size()) +
                                " samples: expected at least 4");
  }
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (!std::isfinite(profile[i].radius) || !std::isfinite(profile[i].pressure))
      throw refuse(i, "expected finite numbers");
    if (profile[i].radius < 0.0) throw refuse(i, "expected a radius >= 0");
    if (i > 0 && profile[i].radius < profile[i - 1].radius) throw refuse(i, "expected radii that do not decrease");
    if (i > 1 && profile[i].radius == profile[i - 2].radius)
      throw refuse(i, "expected at most two pressures at one radius");
  }
  // For a smaller gap the coefficients of the cubic may overflow.
  const double least_gap = 1e-9 * profile.back().radius;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const double gap = profile[i].radius - (i > 0 ? profile[i - 1].radius : 0.0);
    if (gap > 0.0 && gap < least_gap)
      throw refuse(i, "expected a radius equal to the one before, or larger by at least 1e-9 of the last radius");
  }
  if (!(profile.back().radius > profile.front().radius))
    throw refuse(profile.size() - 1, "expected a last radius > the first");
  if (profile[profile.size() - 2].radius == profile.back().radius)
    throw refuse(profile.size() - 1, "a jump at the last radius, expected one pressure there");
  if (rim != 0.0 && !(rim >= 1e-3 * profile.back().radius && rim <= 1e3 * profile.back().radius)) {
    throw std::invalid_argument("profile '" + std::string(source) + "': got rim = " + format_number(rim) +
                                ", expected 1e-3 to 1e3 times the file's last radius, " +
                                format_number(profile.back().radius));
  }
  std::vector<double> pressures;
  std::vector<double> areas;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    pressures.push_back(profile[i].pressure);
    areas.push_back(profile[i].radius *
                    (profile[std::min(i + 1, profile.size() - 1)].radius - profile[i > 0 ? i - 1 : 0].radius));
  }
  constexpr std::size_t enough = 7;
  std::vector<std::string> notes;
  if (profile.size() < enough) {
    notes.push_back("note: " + std::string(source) + ": " + std::to_string(profile.size()) +
                    " samples are too few to estimate the error between them; expected 7 or more");
  }
  const SignedNoise noise = remove_noise(pressures, areas, [&](std::size_t i) {
    return "profile '" + std::string(source) + "', sample " + std::to_string(places[i] + 1);
  });
  if (noise.zeroed > 0) notes.push_back("note: " + std::string(source) + ": " + noise.text());
  for (std::size_t i = 0; i < profile.size(); ++i) profile[i].pressure = pressures[i];
  // The contact ends where its pressure does: a sensor's line goes on.
  const auto inner = [&]() -> const PressureSample& { return profile[profile.size() - 2]; };
  while (profile.size() > 2 && profile.back().pressure <= 0.0 && inner().pressure <= 0.0 && inner().radius > 0.0)
    profile.pop_back();
  // A jump to 0 is the end. Only to a rim farther out does it tell that there is no pressure.
  if (profile.back().radius == inner().radius && !(rim > inner().radius)) profile.back() = inner();
  return std::make_shared<SamplesLaw>(profile, source, rim, std::move(notes), rim > 0.0);
}

}  // namespace limitcurve
