// SPDX-License-Identifier: MIT
#include "c/handles.hpp"

#include "godobject/finger.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/contact/load_to_hold.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/measured/samples.hpp"
#include "limitcurve/table_file.hpp"

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

using namespace limitcurve;
using namespace limitcurve::c;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// True if an array of COR distances, or an output array, is bad.
bool refuse_arrays(const double* cors, std::size_t count, const double* forces, const double* moments) noexcept {
  return count > 0 && any_missing({{"cors", cors}, {"forces", forces}, {"moments", moments}});
}

}  // namespace

limitcurve_status limitcurve_law_parse(const char* text, limitcurve_law** law) {
  if (is_missing("text", text)) return LIMITCURVE_INVALID;
  return make_handle(law, [&] {
    const Law parsed = parse_law(text);
    return limitcurve_law{parsed, parsed->name()};
  });
}

limitcurve_status limitcurve_law_samples(const double* radii, const double* pressures, size_t count, const char* source,
                                         double rim, limitcurve_law** law) {
  if (is_missing("source", source)) return LIMITCURVE_INVALID;
  if (count > 0 && any_missing({{"radii", radii}, {"pressures", pressures}})) return LIMITCURVE_INVALID;
  return make_handle(law, [&] {
    std::vector<PressureSample> rows;
    for (std::size_t i = 0; i < count; ++i) rows.push_back({radii[i], pressures[i]});
    const Law measured = samples(rows, source, rim);
    return limitcurve_law{measured, measured->name()};
  });
}

void limitcurve_law_free(limitcurve_law* law) {
  free_handle(law);
}

const char* limitcurve_law_name(const limitcurve_law* law) {
  return is_no_handle("law", law) ? nullptr : law->name.c_str();
}

limitcurve_status limitcurve_law_moment_ratio(const limitcurve_law* law, double* moment_ratio) {
  if (is_no_handle("law", law) || is_missing("moment_ratio", moment_ratio)) return LIMITCURVE_INVALID;
  const DefaultArithmetic arithmetic;
  *moment_ratio = law->law->moment_ratio();
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_law_evaluate(const limitcurve_law* law, const double* cors, size_t count, double* forces,
                                          double* moments, double* force_errors, double* moment_errors) {
  if (is_no_handle("law", law) || refuse_arrays(cors, count, forces, moments)) return LIMITCURVE_INVALID;
  const DefaultArithmetic arithmetic;
  for (std::size_t i = 0; i < count; ++i) {
    const WrenchEstimate estimate =
        std::isnan(cors[i]) ? WrenchEstimate{{not_a_number, not_a_number}, {not_a_number, not_a_number}, not_a_number}
                            : law->law->evaluate(cors[i]);
    forces[i] = estimate.wrench.force;
    moments[i] = estimate.wrench.moment;
    if (force_errors != nullptr) force_errors[i] = estimate.error.force;
    if (moment_errors != nullptr) moment_errors[i] = estimate.error.moment;
  }
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_table_build(const limitcurve_law* law, double tolerance, limitcurve_table** table) {
  if (is_no_handle("law", law)) return LIMITCURVE_INVALID;
  return make_handle(table, [&] {
    const Table built = Table::build(law->law, tolerance);
    return limitcurve_table{built, built, to_csv(built)};
  });
}

limitcurve_status limitcurve_table_ellipse(double force_max, double moment_max, limitcurve_table** table) {
  return make_handle(table, [&] { return limitcurve_table{Ellipse(force_max, moment_max)}; });
}

limitcurve_status limitcurve_table_box(double force_max, double moment_max, limitcurve_table** table) {
  return make_handle(table, [&] { return limitcurve_table{box(force_max, moment_max)}; });
}

limitcurve_status limitcurve_table_read_csv(const char* text, size_t length, const char* source,
                                            limitcurve_table** table) {
  if (any_missing({{"text", text}, {"source", source}})) return LIMITCURVE_INVALID;
  return make_handle(table, [&] {
    const Table read = read_table_csv(std::string_view(text, length), source);
    return limitcurve_table{read, read, to_csv(read)};
  });
}

const char* limitcurve_table_csv(const limitcurve_table* table) {
  if (is_no_handle("table", table)) return nullptr;
  if (table->table) return table->csv.c_str();
  refuse("table", "an ellipse or a box has no cells");
  return nullptr;
}

void limitcurve_table_free(limitcurve_table* table) {
  free_handle(table);
}

limitcurve_status limitcurve_table_checked_error(const limitcurve_table* table, double* error) {
  if (is_no_handle("table", table) || is_missing("error", error)) return LIMITCURVE_INVALID;
  *error = table->table ? table->table->checked_error() : 0.0;
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_table_bytes(const limitcurve_table* table, size_t* bytes) {
  if (is_no_handle("table", table) || is_missing("bytes", bytes)) return LIMITCURVE_INVALID;
  *bytes = table->table ? table->table->bytes() : 0;
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_table_evaluate(const limitcurve_table* table, const double* cors, size_t count,
                                            double* forces, double* moments) {
  if (is_no_handle("table", table) || refuse_arrays(cors, count, forces, moments)) return LIMITCURVE_INVALID;
  const auto write = [&](const auto& curve) {
    for (std::size_t i = 0; i < count; ++i) {
      const UnitWrench wrench =
          std::isnan(cors[i]) ? UnitWrench{not_a_number, not_a_number} : curve.wrench({cors[i], 1.0});
      forces[i] = wrench.force;
      moments[i] = wrench.moment;
    }
  };
  table->table ? write(*table->table) : write(table->curve);
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_table_gauge(const limitcurve_table* table, const double* forces, const double* moments,
                                         size_t count, double* gauges) {
  if (is_no_handle("table", table)) return LIMITCURVE_INVALID;
  if (count > 0 && any_missing({{"forces", forces}, {"moments", moments}, {"gauges", gauges}}))
    return LIMITCURVE_INVALID;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(forces[i])) return refuse("forces", i, forces[i], "a finite number");
    if (!std::isfinite(moments[i])) return refuse("moments", i, moments[i], "a finite number");
  }
  const auto write = [&](const auto& curve) {
    for (std::size_t i = 0; i < count; ++i) gauges[i] = curve.gauge({forces[i], moments[i]});
  };
  table->table ? write(*table->table) : write(table->curve);
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_table_load_to_hold(const limitcurve_table* table,
                                                const limitcurve_finger_parameters* contact, const double* forces,
                                                const double* moments, size_t count, double* loads) {
  if (is_no_handle("table", table) || is_missing("contact", contact)) return LIMITCURVE_INVALID;
  if (count > 0 && any_missing({{"forces", forces}, {"moments", moments}, {"loads", loads}})) return LIMITCURVE_INVALID;
  if (refuse_numbers("forces", forces, count) || refuse_numbers("moments", moments, count)) return LIMITCURVE_INVALID;
  return guarded([&] {
    const godobject::FingerParameters parameters = parameters_of(*contact);
    ContactFriction friction{.mu = parameters.mu, .mu_r = parameters.mu_r, .gamma = parameters.gamma};
    if (!friction.mu_r) friction.radius_law = parameters.radius_law;
    const auto write = [&](const auto& curve) {
      static_cast<void>(
          load_to_hold(curve, friction, 0.0, 0.0));  // what is wrong with the contact, before anything is written
      for (std::size_t i = 0; i < count; ++i) loads[i] = load_to_hold(curve, friction, forces[i], moments[i]);
    };
    table->table ? write(*table->table) : write(table->curve);
  });
}
