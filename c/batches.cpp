// SPDX-License-Identifier: MIT
#include "c/handles.hpp"

#include <type_traits>

using namespace limitcurve;
using namespace limitcurve::c;
using namespace limitcurve::godobject;

namespace {

// The caller's bytes have the values of the library's states.
static_assert(std::is_same_v<std::underlying_type_t<ContactState>, std::uint8_t>);

template <class Real, class Contacts>
limitcurve_status step(const limitcurve_batch* batch, const Contacts* contacts, std::size_t count) noexcept {
  if (is_no_handle("batch", batch)) return LIMITCURVE_INVALID;
  const auto* const of_real = std::get_if<BasicBatch<Real>>(&batch->batch);
  if (of_real == nullptr) return refuse("batch", "made for the other precision");
  if (count == 0) return LIMITCURVE_OK;
  if (is_missing("contacts", contacts)) return LIMITCURVE_INVALID;
  const Contacts& of = *contacts;
  if (any_missing({{"x", of.x},
                   {"y", of.y},
                   {"twist", of.twist},
                   {"depth", of.depth},
                   {"proxy_x", of.proxy_x},
                   {"proxy_y", of.proxy_y},
                   {"proxy_angle", of.proxy_angle},
                   {"state", of.state},
                   {"force_slides", of.force_slides},
                   {"moment_slides", of.moment_slides},
                   {"search_start", of.search_start},
                   {"search_rate", of.search_rate},
                   {"fx", of.fx},
                   {"fy", of.fy},
                   {"moment", of.moment}}))
    return LIMITCURVE_INVALID;
  const auto all = [count](auto* array) { return std::span(array, count); };
  const auto states = [count](std::uint8_t* array) { return std::span(reinterpret_cast<ContactState*>(array), count); };
  of_real->step({all(of.x), all(of.y), all(of.twist), all(of.depth), all(of.proxy_x), all(of.proxy_y),
                 all(of.proxy_angle), states(of.state), states(of.force_slides), states(of.moment_slides),
                 all(of.search_start), all(of.search_rate), all(of.fx), all(of.fy), all(of.moment)});
  return LIMITCURVE_OK;
}

}  // namespace

limitcurve_status limitcurve_batch_new(const limitcurve_table* table, const limitcurve_finger_parameters* parameters,
                                       limitcurve_projection projection, limitcurve_batch** batch) {
  if (is_no_handle("table", table) || is_missing("parameters", parameters)) return LIMITCURVE_INVALID;
  return make_handle(batch, [&] {
    return limitcurve_batch{Batch(table->curve, parameters_of(*parameters), projection_of(projection))};
  });
}

limitcurve_status limitcurve_batch_new_float(const limitcurve_law* law, double tolerance,
                                             const limitcurve_finger_parameters* parameters,
                                             limitcurve_projection projection, limitcurve_batch** batch) {
  if (is_no_handle("law", law) || is_missing("parameters", parameters)) return LIMITCURVE_INVALID;
  return make_handle(batch, [&] {
    return limitcurve_batch{
        FloatBatch(FloatTable::build(law->law, tolerance), parameters_of(*parameters), projection_of(projection))};
  });
}

void limitcurve_batch_free(limitcurve_batch* batch) {
  free_handle(batch);
}

limitcurve_status limitcurve_batch_step(const limitcurve_batch* batch, const limitcurve_contacts* contacts,
                                        size_t count) {
  return step<double>(batch, contacts, count);
}

limitcurve_status limitcurve_batch_step_float(const limitcurve_batch* batch, const limitcurve_contacts_float* contacts,
                                              size_t count) {
  return step<float>(batch, contacts, count);
}
