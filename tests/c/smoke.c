/* SPDX-License-Identifier: MIT */
/* The C interface from C99: handles are made, used and freed, and an error is a status with a line that says why. What
 * same_bits_test.cpp compares with C++ is not asked again. */
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
#define WORKS(call) CHECK((call) == LIMITCURVE_OK)
#define REFUSED(call, told) CHECK((call) == LIMITCURVE_INVALID && strstr(limitcurve_error(), told) != NULL)

static void laws_and_tables(void) {
  limitcurve_law* law = NULL;
  WORKS(limitcurve_law_parse("hertz", &law));
  CHECK(strcmp(limitcurve_law_name(law), "hertz") == 0);
  double m0 = 0;
  WORKS(limitcurve_law_moment_ratio(law, &m0));
  CHECK(fabs(m0 - 3 * 3.14159265358979323846 / 16) < 1e-15); /* Hertz: 3 pi/16 */
  const double cors[3] = {0, 0.5, INFINITY};
  double forces[3], moments[3], force_errors[3], moment_errors[3];
  WORKS(limitcurve_law_evaluate(law, cors, 3, forces, moments, force_errors, moment_errors));
  CHECK(forces[0] == 0 && moments[0] == m0 && forces[2] == 1 && moments[2] == 0);
  CHECK(force_errors[1] > 0 && force_errors[1] < (LDBL_MANT_DIG > DBL_MANT_DIG ? 1e-15 : 2e-14));

  limitcurve_table* table = NULL;
  WORKS(limitcurve_table_build(law, 1e-8, &table));
  limitcurve_law_free(law); /* the table does not need it */
  double error = 1, table_force, table_moment, gauge;
  size_t bytes = 0;
  CHECK(limitcurve_table_checked_error(table, &error) == LIMITCURVE_OK && error > 0 && error <= 1e-8);
  CHECK(limitcurve_table_bytes(table, &bytes) == LIMITCURVE_OK && bytes > 0 && bytes <= 4096);
  WORKS(limitcurve_table_evaluate(table, cors + 1, 1, &table_force, &table_moment));
  CHECK(fabs(table_force - forces[1]) <= error && fabs(table_moment - moments[1]) <= error);
  WORKS(limitcurve_table_gauge(table, &table_force, &table_moment, 1, &gauge));
  CHECK(fabs(gauge - 1) < 1e-12);

  limitcurve_table* again = NULL;
  const char* csv = limitcurve_table_csv(table);
  WORKS(limitcurve_table_read_csv(csv, strlen(csv), "memory", &again));
  CHECK(strcmp(limitcurve_table_csv(again), csv) == 0);
  REFUSED(limitcurve_table_read_csv("no table", 8, "memory", &again), "memory:");
  limitcurve_table_free(again);
  WORKS(limitcurve_table_ellipse(1, 0.6, &again));
  CHECK(limitcurve_table_csv(again) == NULL);
  limitcurve_table_free(again);
  limitcurve_table_free(table);

  const double radii[6] = {0, 1, 2, 3, 4, 9}, pressures[6] = {8, 7, 5, 2, 0, 0.01};
  WORKS(limitcurve_law_samples(radii, pressures, 6, "pad", 4, &law));
  CHECK(strcmp(limitcurve_law_name(law), "samples:pad,rim=4") == 0);
  limitcurve_law_free(law);
  REFUSED(limitcurve_law_samples(radii, pressures, 6, "pad", -1, &law), "rim");
}

static void fingers(void) {
  limitcurve_law* law = NULL;
  limitcurve_table* table = NULL;
  limitcurve_finger* finger = NULL;
  limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
  parameters.mu = 0.6;
  parameters.radius_law = "constant:a=0.006";
  WORKS(limitcurve_law_parse("uniform", &law));
  WORKS(limitcurve_table_build(law, 1e-6, &table));
  WORKS(limitcurve_finger_new(table, &parameters, LIMITCURVE_CLOSEST_POINT, &finger));
  limitcurve_contact contact = {{0, 0, 0}, {0, 0, 1}, 0.002, 0, 0};
  limitcurve_finger_output output;
  for (int i = 0; i <= 100; ++i) { /* pulled away by 1 cm: friction is mu P against it */
    contact.point[0] = 1e-4 * i;
    WORKS(limitcurve_finger_update(finger, &contact, 1e-3, &output));
  }
  CHECK(output.state == LIMITCURVE_SLIP && fabs(output.force[0] + 0.6 * 2.0) < 1e-12 && isinf(output.cor));
  double centre[3];
  WORKS(limitcurve_finger_centre_of_rotation(finger, centre));
  CHECK(!(fabs(centre[0]) < 1e9 && fabs(centre[1]) < 1e9));
  contact.depth = NAN;
  WORKS(limitcurve_finger_update(finger, &contact, 1e-3, &output));
  CHECK(output.state == LIMITCURVE_STATE_INVALID && output.fault == LIMITCURVE_FAULT_NOT_FINITE);
  WORKS(limitcurve_finger_reset(finger));
  limitcurve_finger_free(finger);
  finger = NULL;
  parameters.mu = -1;
  REFUSED(limitcurve_finger_new(table, &parameters, LIMITCURVE_CLOSEST_POINT, &finger), "mu");
  CHECK(finger == NULL);
  parameters.mu = 0.6;

  double device = 0, turn = 0;
  WORKS(limitcurve_device_damping_needed(&parameters, 1e-3, 1, &device, &turn));
  CHECK(fabs(device - 1.5e-3 * parameters.stiffness) < 1e-12 &&
        fabs(turn - 1.5e-3 * parameters.twist_stiffness) < 1e-15);
  WORKS(limitcurve_require_passive(&parameters, 1e-3, 1, 1.01 * device, 1.01 * turn));
  REFUSED(limitcurve_require_passive(&parameters, 1e-3, 2, 1.01 * device, INFINITY), "a delay of 2 samples");

  const limitcurve_contact groove[] = {{{0, 0, 1}, {0, 0, 1}, 1, 3, 0}, {{1, 0, 0}, {1, 0, 0}, 1, 3, 1}};
  limitcurve_contact joined;
  WORKS(limitcurve_join(groove, 2, &joined));
  CHECK(fabs(joined.point[0] - 1) < 1e-15 && fabs(joined.point[2] - 1) < 1e-15 &&
        fabs(joined.depth - sqrt(2)) < 1e-15 && joined.twist == 3 && joined.landed == 1);
  REFUSED(limitcurve_join(NULL, 2, &joined), "NULL");
  CHECK(limitcurve_join(NULL, 0, &joined) == LIMITCURVE_OK && joined.depth == 0);

  const double forces[2] = {1.2, 0}, moments[2] = {0, 1.2 * 0.004}, bad[2] = {0, NAN};
  double needed[2];
  WORKS(limitcurve_table_load_to_hold(table, &parameters, forces, moments, 2, needed));
  CHECK(fabs(needed[0] - 2) < 1e-5 && fabs(needed[1] - 2) < 1e-5); /* m0 = 2/3 */
  needed[0] = -1;
  REFUSED(limitcurve_table_load_to_hold(table, &parameters, forces, bad, 2, needed), "moments[1]: got nan");
  CHECK(needed[0] == -1); /* nothing is written */
  limitcurve_finger_parameters held = limitcurve_finger_defaults(), zeros = held;
  held.mu = 0.6;
  held.radius_law = "constant";
  REFUSED(limitcurve_table_load_to_hold(table, &held, forces, moments, 2, needed), "constant");
  held.radius_law = NULL;
  REFUSED(limitcurve_table_load_to_hold(table, &held, forces, moments, 2, needed), "radius_law");
  held.mu_r = 0.6 * 0.004; /* as measured */
  WORKS(limitcurve_table_load_to_hold(table, &held, forces, moments, 2, needed));
  CHECK(fabs(needed[1] - 2) < 1e-5);
  WORKS(limitcurve_finger_new(table, &held, LIMITCURVE_CLOSEST_POINT, &finger));
  held.mu_r = NAN; /* the finger has no radius law to keep */
  REFUSED(limitcurve_finger_change(finger, &held), "radius_law: got NULL");
  limitcurve_finger_free(finger);
  held.mu_r = 0.6 * 0.004;
  held.radius_law = zeros.radius_law; /* beside the default one */
  REFUSED(limitcurve_table_load_to_hold(table, &held, forces, moments, 2, needed), "radius_law");
  memset(&zeros, 0, sizeof zeros);
  REFUSED(limitcurve_table_load_to_hold(table, &zeros, forces, moments, 2, needed), "limitcurve_finger_defaults()");
  limitcurve_table_free(table);
  limitcurve_law_free(law);
}

static void patches(void) {
  limitcurve_patch* patch = NULL;
  limitcurve_finger* finger = NULL;
  limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
  parameters.radius_law = NULL; /* a patch has its own size */
  WORKS(limitcurve_patch_rectangle(0.02, 0.01, &patch));
  WORKS(limitcurve_finger_new_patch(patch, &parameters, 0, &finger));
  const limitcurve_contact contact = {{0, 0, 0}, {0, 0, 1}, 0.002, 0, 0};
  limitcurve_finger_output output;
  WORKS(limitcurve_finger_update(finger, &contact, 1e-3, &output));
  CHECK(output.state == LIMITCURVE_STICK && output.load == 2.0);
  limitcurve_finger_free(finger);
  parameters.mu_r = 0.002;
  REFUSED(limitcurve_finger_new_patch(patch, &parameters, 0, &finger), "absent with a patch");
  const double twist[3] = {0.01, 0, 0};
  double wrench[3], power, bound;
  WORKS(limitcurve_patch_wrench(patch, twist, 1, wrench, &power, &bound));
  CHECK(fabs(wrench[0] - 1) < 1e-12 && fabs(wrench[1]) < 1e-12 && fabs(wrench[2]) < 1e-12 &&
        fabs(power - 0.01) < 1e-14);
  /* An image of wide pixels is that rectangle, turning about the middle of its right edge. */
  const double pixels[4] = {1, 1, 1, 1}, turning[3] = {0, -0.01, 1};
  double found[3], of_rectangle[3], error = 0;
  limitcurve_patch* other = NULL;
  WORKS(limitcurve_patch_wrench(patch, turning, 1, of_rectangle, NULL, NULL));
  WORKS(limitcurve_patch_image_spaced(pixels, 2, 2, 0.01, 0.005, &other));
  WORKS(limitcurve_patch_wrench(other, turning, 1, found, NULL, &bound));
  CHECK(bound < 0.01 && fabs(found[1] - of_rectangle[1]) <= bound);
  limitcurve_patch_free(other);
  REFUSED(limitcurve_patch_image_spaced(pixels, 2, 2, 0.01, -0.005, &other), "");
  limitcurve_patch* again = NULL;
  WORKS(limitcurve_patch_table(patch, 1e-2, &other));
  CHECK(limitcurve_patch_checked_error(other, &error) == LIMITCURVE_OK && error <= 1e-2);
  WORKS(limitcurve_patch_wrench(other, turning, 1, found, NULL, NULL));
  CHECK(fabs(found[0] - of_rectangle[0]) <= error);
  const char* const csv = limitcurve_patch_csv(other);
  WORKS(limitcurve_patch_read_csv(csv, strlen(csv), "t.csv", &again));
  CHECK(strcmp(limitcurve_patch_csv(again), csv) == 0 && limitcurve_patch_csv(patch) == NULL);
  limitcurve_patch_free(again);
  limitcurve_patch_free(other);
  REFUSED(limitcurve_patch_table(patch, 1e-9, &other), "");
  /* What slips at a load of 5 N is held by 5 N; here mu = 0.5. */
  double needed, slip[3];
  wrench[0] *= 2.5;
  CHECK(limitcurve_patch_load_to_hold(patch, 0.5, wrench, 1, &needed) == LIMITCURVE_OK && fabs(needed - 5) < 1e-9);
  REFUSED(limitcurve_patch_load_to_hold(patch, -0.5, wrench, 1, &needed), "mu");
  CHECK(limitcurve_patch_slip(patch, wrench, 1, slip, &bound) == LIMITCURVE_OK && bound < 1e-9);
  CHECK(fabs(slip[0] * wrench[0] - 1) < 1e-9 && fabs(slip[1]) < 1e-9 && fabs(slip[2]) * 0.01 < 1e-9);
  limitcurve_patch_free(patch);
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
  WORKS(limitcurve_fit_radii("best", loads, radii, NULL, 8, &fit));
  CHECK(limitcurve_fit_count(fit) == 2 && strcmp(limitcurve_fit_model(fit), "hertz") == 0);
  const char* name = "";
  const char* unit = "";
  double value = 0;
  WORKS(limitcurve_fit_estimate(fit, 0, &name, &value, NULL, &unit));
  CHECK(strcmp(name, "c") == 0 && fabs(value - 0.002) < 1e-6 && strlen(unit) > 0);
  REFUSED(limitcurve_fit_estimate(fit, 2, NULL, NULL, NULL, NULL), "");
  limitcurve_fit_free(fit);
  fit = NULL;
  REFUSED(limitcurve_fit_slips("elipse", loads, radii, radii, NULL, NULL, 8, NULL, 0, &fit), "elipse");
  CHECK(fit == NULL);
  REFUSED(limitcurve_fit_radii("hertzian", loads, radii, NULL, 8, &fit), "linear|hertz|power|best");
#endif
}

int main(void) {
  CHECK(strlen(limitcurve_version()) >= 5 && strcmp(limitcurve_error(), "") == 0);
  laws_and_tables();
  fingers();
  patches();
  fits();
  if (failures == 0) puts("all checks hold");
  return failures == 0 ? 0 : 1;
}
