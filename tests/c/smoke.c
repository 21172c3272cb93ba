/* SPDX-License-Identifier: MIT */
/* The C interface from C99: every kind of handle is made, used and freed, and every error is a status with a line that
 * says why. */
#ifdef WITH_FITS
#include "limitcurve_fit.h"
#else
#include "limitcurve.h"
#endif

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void check(int holds, const char* what, int line) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "smoke.c:%d: %s (last error: %s)\n", line, what, limitcurve_error());
}
#define CHECK(condition) check((condition), #condition, __LINE__)

static void laws_and_tables(void) {
  limitcurve_law* law = NULL;
  CHECK(limitcurve_law_parse("hertz", &law) == LIMITCURVE_OK);
  CHECK(strcmp(limitcurve_law_name(law), "hertz") == 0);
  double m0 = 0;
  CHECK(limitcurve_law_moment_ratio(law, &m0) == LIMITCURVE_OK);
  CHECK(fabs(m0 - 3 * 3.14159265358979323846 / 16) < 1e-15); /* Hertz: 3 pi/16 */
  const double cors[3] = {0, 0.5, INFINITY};
  double forces[3], moments[3], force_errors[3], moment_errors[3];
  CHECK(limitcurve_law_evaluate(law, cors, 3, forces, moments, force_errors, moment_errors) == LIMITCURVE_OK);
  CHECK(forces[0] == 0 && moments[0] == m0 && forces[2] == 1 && moments[2] == 0);
  CHECK(force_errors[1] > 0 && force_errors[1] < (LDBL_MANT_DIG > DBL_MANT_DIG ? 1e-15 : 2e-14));

  limitcurve_table* table = NULL;
  CHECK(limitcurve_table_build(law, 1e-8, &table) == LIMITCURVE_OK);
  limitcurve_law_free(law); /* the table does not need it */
  double error = 1;
  size_t bytes = 0;
  CHECK(limitcurve_table_checked_error(table, &error) == LIMITCURVE_OK && error > 0 && error <= 1e-8);
  CHECK(limitcurve_table_bytes(table, &bytes) == LIMITCURVE_OK && bytes > 0 && bytes <= 4096);
  double table_force, table_moment, gauge;
  CHECK(limitcurve_table_evaluate(table, cors + 1, 1, &table_force, &table_moment) == LIMITCURVE_OK);
  CHECK(fabs(table_force - forces[1]) <= error && fabs(table_moment - moments[1]) <= error);
  CHECK(limitcurve_table_gauge(table, &table_force, &table_moment, 1, &gauge) == LIMITCURVE_OK &&
        fabs(gauge - 1) < 1e-12);

  limitcurve_table* again = NULL;
  const char* csv = limitcurve_table_csv(table);
  CHECK(csv != NULL && limitcurve_table_read_csv(csv, strlen(csv), "memory", &again) == LIMITCURVE_OK);
  CHECK(strcmp(limitcurve_table_csv(again), csv) == 0);
  CHECK(limitcurve_table_read_csv("no table", 8, "memory", &again) == LIMITCURVE_INVALID);
  CHECK(strncmp(limitcurve_error(), "memory:", 7) == 0);
  limitcurve_table_free(again);
  limitcurve_table_free(table);
}

static void measured_profile(void) {
  const double radii[6] = {0, 1, 2, 3, 4, 9}, pressures[6] = {8, 7, 5, 2, 0, 0.01};
  limitcurve_law* law = NULL;
  CHECK(limitcurve_law_samples(radii, pressures, 6, "pad", 4, &law) == LIMITCURVE_OK);
  CHECK(strcmp(limitcurve_law_name(law), "samples:pad,rim=4") == 0);
  limitcurve_law_free(law);
  CHECK(limitcurve_law_samples(radii, pressures, 6, "pad", -1, &law) == LIMITCURVE_INVALID);
}

static void fingers(void) {
  limitcurve_law* law = NULL;
  limitcurve_table* table = NULL;
  limitcurve_finger* finger = NULL;
  limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
  parameters.mu = 0.6;
  parameters.radius_law = "constant:a=0.006";
  CHECK(limitcurve_law_parse("uniform", &law) == LIMITCURVE_OK &&
        limitcurve_table_build(law, 1e-6, &table) == LIMITCURVE_OK);
  CHECK(limitcurve_finger_new(table, &parameters, LIMITCURVE_CLOSEST_POINT, &finger) == LIMITCURVE_OK);
  limitcurve_contact contact = {{0, 0, 0}, {0, 0, 1}, 0.002, 0, 0};
  limitcurve_finger_output output;
  CHECK(limitcurve_finger_update(finger, &contact, 1e-3, &output) == LIMITCURVE_OK && output.state == LIMITCURVE_STICK);
  CHECK(output.load == 2.0);
  for (int i = 1; i <= 100; ++i) { /* pulled away by 1 cm: friction is mu P against it */
    contact.point[0] = 1e-4 * i;
    CHECK(limitcurve_finger_update(finger, &contact, 1e-3, &output) == LIMITCURVE_OK);
  }
  CHECK(output.state == LIMITCURVE_SLIP && fabs(output.force[0] + 0.6 * 2.0) < 1e-12 && isinf(output.cor));
  double device = 0, turn = 0;
  CHECK(limitcurve_device_damping_needed(&parameters, 1e-3, 1, &device, &turn) == LIMITCURVE_OK);
  CHECK(fabs(device - 1.5e-3 * parameters.stiffness) < 1e-12 &&
        fabs(turn - 1.5e-3 * parameters.twist_stiffness) < 1e-15);
  CHECK(limitcurve_require_passive(&parameters, 1e-3, 1, 1.01 * device, 1.01 * turn) == LIMITCURVE_OK);
  CHECK(limitcurve_require_passive(&parameters, 1e-3, 2, 1.01 * device, INFINITY) == LIMITCURVE_INVALID);
  CHECK(strstr(limitcurve_error(), "a delay of 2 samples") != NULL);
  double margin = 1, hold = 0;
  CHECK(limitcurve_finger_margin(finger, &margin, &hold) == LIMITCURVE_OK && margin == 0 && fabs(hold - 2.0) < 1e-9);
  double centre[3];
  CHECK(limitcurve_finger_centre_of_rotation(finger, centre) == LIMITCURVE_OK &&
        !(fabs(centre[0]) < 1e9 && fabs(centre[1]) < 1e9));
  {
    const limitcurve_contact groove[] = {{{0, 0, 1}, {0, 0, 1}, 1, 3, 0}, {{1, 0, 0}, {1, 0, 0}, 1, 3, 1}};
    limitcurve_contact joined;
    CHECK(limitcurve_join(groove, 2, &joined) == LIMITCURVE_OK && fabs(joined.point[0] - 1) < 1e-15 &&
          fabs(joined.point[2] - 1) < 1e-15 && fabs(joined.depth - sqrt(2)) < 1e-15 && joined.twist == 3 &&
          joined.landed == 1);
    CHECK(limitcurve_join(NULL, 2, &joined) == LIMITCURVE_INVALID);
    CHECK(limitcurve_join(groove, 0, &joined) == LIMITCURVE_OK && joined.depth == 0);
  }
  contact.depth = NAN;
  CHECK(limitcurve_finger_update(finger, &contact, 1e-3, &output) == LIMITCURVE_OK &&
        output.state == LIMITCURVE_STATE_INVALID);
  CHECK(output.fault == LIMITCURVE_FAULT_NOT_FINITE);
  CHECK(limitcurve_finger_reset(finger) == LIMITCURVE_OK);
  limitcurve_finger_free(finger);

  parameters.mu = -1;
  finger = NULL;
  CHECK(limitcurve_finger_new(table, &parameters, LIMITCURVE_CLOSEST_POINT, &finger) == LIMITCURVE_INVALID &&
        finger == NULL);
  CHECK(strncmp(limitcurve_error(), "mu", 2) == 0);
  parameters.mu = 0.6;

  limitcurve_patch* patch = NULL;
  CHECK(limitcurve_patch_rectangle(0.02, 0.01, &patch) == LIMITCURVE_OK);
  CHECK(limitcurve_finger_new_patch(patch, &parameters, 0, &finger) == LIMITCURVE_OK);
  contact.depth = 0.002;
  contact.point[0] = 0;
  CHECK(limitcurve_finger_update(finger, &contact, 1e-3, &output) == LIMITCURVE_OK && output.state == LIMITCURVE_STICK);
  const double twist[3] = {0.01, 0, 0};
  double wrench[3], power, bound;
  CHECK(limitcurve_patch_wrench(patch, twist, 1, wrench, &power, &bound) == LIMITCURVE_OK);
  CHECK(fabs(wrench[0] - 1) < 1e-12 && fabs(wrench[1]) < 1e-12 && fabs(wrench[2]) < 1e-12 &&
        fabs(power - 0.01) < 1e-14);
  /* An image of wide pixels is that rectangle, turning about the middle of its right edge. */
  const double pixels[4] = {1, 1, 1, 1}, turning[3] = {0, -0.01, 1};
  double of_image[3], of_rectangle[3], image_bound;
  limitcurve_patch* image = NULL;
  CHECK(limitcurve_patch_image_spaced(pixels, 2, 2, 0.01, 0.005, &image) == LIMITCURVE_OK);
  CHECK(limitcurve_patch_wrench(image, turning, 1, of_image, NULL, &image_bound) == LIMITCURVE_OK);
  CHECK(limitcurve_patch_wrench(patch, turning, 1, of_rectangle, NULL, NULL) == LIMITCURVE_OK);
  CHECK(image_bound < 0.01 && fabs(of_image[1] - of_rectangle[1]) <= image_bound);
  limitcurve_patch_free(image);
  limitcurve_patch* patch_table = NULL;
  limitcurve_patch* read_again = NULL;
  double of_table[3];
  double table_error = 0;
  CHECK(limitcurve_patch_table(patch, 1e-2, &patch_table) == LIMITCURVE_OK);
  CHECK(limitcurve_patch_checked_error(patch_table, &table_error) == LIMITCURVE_OK && table_error <= 1e-2);
  CHECK(limitcurve_patch_wrench(patch_table, turning, 1, of_table, NULL, NULL) == LIMITCURVE_OK);
  CHECK(fabs(of_table[0] - of_rectangle[0]) <= table_error);
  const char* const patch_csv = limitcurve_patch_csv(patch_table);
  CHECK(limitcurve_patch_read_csv(patch_csv, strlen(patch_csv), "t.csv", &read_again) == LIMITCURVE_OK);
  CHECK(strcmp(limitcurve_patch_csv(read_again), patch_csv) == 0 && limitcurve_patch_csv(patch) == NULL);
  CHECK(limitcurve_patch_table(patch, 1e-9, &image) == LIMITCURVE_INVALID);
  limitcurve_patch_free(read_again);
  limitcurve_patch_free(patch_table);
  CHECK(limitcurve_patch_image_spaced(pixels, 2, 2, 0.01, -0.005, &image) == LIMITCURVE_INVALID);
  /* What slips at a load of 5 N is held by 5 N; here mu = 0.5. */
  double needed[2] = {0, 0};
  wrench[0] *= 2.5;
  CHECK(limitcurve_patch_load_to_hold(patch, 0.5, wrench, 1, needed) == LIMITCURVE_OK && fabs(needed[0] - 5) < 1e-9);
  CHECK(limitcurve_patch_load_to_hold(patch, -0.5, wrench, 1, needed) == LIMITCURVE_INVALID);
  double slip[3], slip_bound;
  CHECK(limitcurve_patch_slip(patch, wrench, 1, slip, &slip_bound) == LIMITCURVE_OK && slip_bound < 1e-9);
  CHECK(fabs(slip[0] * wrench[0] - 1) < 1e-9 && fabs(slip[1]) < 1e-9 && fabs(slip[2]) * 0.01 < 1e-9);
  const double bad[6] = {1, 0, 0, 0, NAN, 0}; /* then nothing is written */
  needed[0] = -1;
  CHECK(limitcurve_patch_load_to_hold(patch, 0.5, bad, 2, needed) == LIMITCURVE_INVALID && needed[0] == -1);
  CHECK(strstr(limitcurve_error(), "wrenches[4]: got nan, expected a finite number") != NULL);
  limitcurve_finger_parameters sized = limitcurve_finger_defaults();
  sized.radius_law = NULL; /* a patch has its own size */
  limitcurve_finger* on_patch = NULL;
  CHECK(limitcurve_finger_new_patch(patch, &sized, 0, &on_patch) == LIMITCURVE_OK);
  limitcurve_finger_free(on_patch);
  const double forces[2] = {1.2, 0}, moments[2] = {0, 1.2 * 0.004};
  limitcurve_finger_parameters held = limitcurve_finger_defaults();
  held.mu = 0.6;
  held.radius_law = "constant:a=0.006";
  CHECK(limitcurve_table_load_to_hold(table, &held, forces, moments, 2, needed) == LIMITCURVE_OK);
  CHECK(fabs(needed[0] - 2) < 1e-5 && fabs(needed[1] - 2) < 1e-5); /* m0 = 2/3 */
  held.radius_law = "constant";
  CHECK(limitcurve_table_load_to_hold(table, &held, forces, moments, 2, needed) == LIMITCURVE_INVALID);
  held.radius_law = NULL;
  CHECK(limitcurve_table_load_to_hold(table, &held, forces, moments, 2, needed) == LIMITCURVE_INVALID);
  limitcurve_finger_parameters zeros;
  memset(&zeros, 0, sizeof zeros);
  CHECK(limitcurve_table_load_to_hold(table, &zeros, forces, moments, 2, needed) == LIMITCURVE_INVALID);
  CHECK(strstr(limitcurve_error(), "limitcurve_finger_defaults()") != NULL);
  zeros = limitcurve_finger_defaults();
  zeros.mu_r = 0.002; /* beside the default radius_law */
  CHECK(limitcurve_table_load_to_hold(table, &zeros, forces, moments, 2, needed) == LIMITCURVE_INVALID);
  held.mu_r = 0.6 * 0.004; /* as measured */
  CHECK(limitcurve_table_load_to_hold(table, &held, forces, moments, 2, needed) == LIMITCURVE_OK &&
        fabs(needed[1] - 2) < 1e-5);
  needed[0] = -1;
  CHECK(limitcurve_table_load_to_hold(table, &held, forces, bad + 3, 2, needed) == LIMITCURVE_INVALID &&
        needed[0] == -1);
  CHECK(strstr(limitcurve_error(), "moments[1]: got nan, expected a finite number") != NULL);
  limitcurve_patch_free(patch);
  limitcurve_finger_free(finger);

  limitcurve_limits limits = {1.2, 0.006, 1.2, 0.006, 1000 / 0.04, 1, 1};
  limitcurve_memory memory = {0, 0, 0, 0};
  limitcurve_friction friction;
  CHECK(limitcurve_apply_friction(table, LIMITCURVE_CLOSEST_POINT, &limits, 2.4, 0, &memory, &friction) ==
        LIMITCURVE_OK);
  CHECK(friction.slips && fabs(friction.force_fraction - 0.5) < 1e-12 && memory.force_slides);

  limitcurve_table_free(table);
  limitcurve_law_free(law);
}

static void batches(void) {
  limitcurve_table* table = NULL;
  limitcurve_batch* batch = NULL;
  const limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
  CHECK(limitcurve_table_ellipse(1, 0.6, &table) == LIMITCURVE_OK);
  CHECK(limitcurve_table_csv(table) == NULL);
  CHECK(limitcurve_batch_new(table, &parameters, LIMITCURVE_RADIAL, &batch) == LIMITCURVE_OK);
  double x[2] = {0, 0.01}, y[2] = {0, 0}, angle[2] = {0, 0}, depth[2] = {0.001, 0.001};
  double proxy_x[2] = {0}, proxy_y[2] = {0}, proxy_angle[2] = {0}, parameter[2] = {0}, rate[2] = {0};
  double force_x[2], force_y[2], moment[2];
  uint8_t state[2] = {LIMITCURVE_STICK, LIMITCURVE_STICK}, sliding[2] = {0}, turning[2] = {0};
  const limitcurve_contacts contacts = {x,       y,       angle,     depth, proxy_x, proxy_y, proxy_angle, state,
                                        sliding, turning, parameter, rate,  force_x, force_y, moment};
  CHECK(limitcurve_batch_step(batch, &contacts, 2) == LIMITCURVE_OK);
  CHECK(state[0] == LIMITCURVE_STICK && state[1] == LIMITCURVE_SLIP && fabs(force_x[1] + 0.5) < 1e-12);
  CHECK(limitcurve_batch_step_float(batch, NULL, 1) == LIMITCURVE_INVALID);
  CHECK(strcmp(limitcurve_error(), "batch: made for the other precision") == 0);
  limitcurve_batch_free(batch);
  limitcurve_table_free(table);
}

static void fits(void) {
#ifdef WITH_FITS
  /* Radii a = 0.002 P^(1/3), to the last digit. */
  double loads[8], radii[8];
  for (int i = 0; i < 8; ++i) {
    loads[i] = 0.5 + i;
    radii[i] = 0.002 * cbrt(loads[i]);
  }
  limitcurve_fit* fit = NULL;
  CHECK(limitcurve_fit_radii("best", loads, radii, NULL, 8, &fit) == LIMITCURVE_OK && limitcurve_fit_count(fit) == 2);
  CHECK(strcmp(limitcurve_fit_model(fit), "hertz") == 0);
  const char* name = "";
  const char* unit = "";
  double value = 0;
  CHECK(limitcurve_fit_estimate(fit, 0, &name, &value, NULL, &unit) == LIMITCURVE_OK);
  CHECK(strcmp(name, "c") == 0 && fabs(value - 0.002) < 1e-6 && strlen(unit) > 0);
  CHECK(limitcurve_fit_estimate(fit, 2, NULL, NULL, NULL, NULL) == LIMITCURVE_INVALID);
  limitcurve_fit_free(fit);
  fit = NULL;
  CHECK(limitcurve_fit_slips("elipse", loads, radii, radii, NULL, NULL, 8, NULL, 0, &fit) == LIMITCURVE_INVALID &&
        fit == NULL);
  CHECK(strstr(limitcurve_error(), "elipse") != NULL);
  CHECK(limitcurve_fit_radii("hertzian", loads, radii, NULL, 8, &fit) == LIMITCURVE_INVALID);
  CHECK(strstr(limitcurve_error(), "linear|hertz|power|best") != NULL);
#endif
}

int main(void) {
  CHECK(strlen(limitcurve_version()) >= 5 && strcmp(limitcurve_error(), "") == 0);
  laws_and_tables();
  measured_profile();
  fingers();
  batches();
  fits();
  if (failures == 0) puts("all checks hold");
  return failures == 0 ? 0 : 1;
}
