/* SPDX-License-Identifier: MIT */
/* A finger in C that slides and twists at once: it settles at the wrench of its slip, and the law gives the exact
 * value. */
#include "limitcurve.h"

#include <math.h>
#include <stdio.h>

static int fail(void) {
  fprintf(stderr, "%s\n", limitcurve_error());
  return 1;
}

int main(void) {
  /* Before the loop: a table of a pressure law, and a finger. Only these calls can fail. */
  limitcurve_law* law = NULL;
  limitcurve_table* table = NULL;
  limitcurve_finger* finger = NULL;
  limitcurve_finger_parameters skin = limitcurve_finger_defaults();
  skin.mu = 0.6;
  skin.radius_law = "constant:a=0.006";
  skin.twist_stiffness = 0.036;
  if (limitcurve_law_parse("hertz", &law) != LIMITCURVE_OK) return fail();
  if (limitcurve_table_build(law, 1e-8, &table) != LIMITCURVE_OK) return fail();
  if (limitcurve_finger_new(table, &skin, LIMITCURVE_CLOSEST_POINT, &finger) != LIMITCURVE_OK) return fail();

  /* The loop: at 1 kHz, 30 mm/s along x and 10 rad/s about the normal, 2 mm deep. */
  limitcurve_finger_output felt;
  for (int i = 0; i < 3000; ++i) {
    const double time = 1e-3 * i;
    const limitcurve_contact contact = {{0.03 * time, 0, 0}, {0, 0, 1}, 0.002, 10 * time, 0};
    if (limitcurve_finger_update(finger, &contact, 1e-3, &felt) != LIMITCURVE_OK) return fail();
  }

  /* The centre of rotation is 3 mm from the contact's centre: half its radius. */
  const double cor = 0.03 / 10 / 0.006;
  double force, moment;
  if (limitcurve_law_evaluate(law, &cor, 1, &force, &moment, NULL, NULL) != LIMITCURVE_OK) return fail();
  const double capacity = 0.6 * felt.load; /* mu P */
  printf("friction %.6f N and %.6f N mm; exactly %.6f and %.6f\n", -felt.force[0], -1e3 * felt.moment, capacity * force,
         1e3 * capacity * 0.006 * moment);
  const int right =
      fabs(-felt.force[0] / capacity - force) < 1e-6 && fabs(-felt.moment / (capacity * 0.006) - moment) < 1e-6;

  limitcurve_finger_free(finger);
  limitcurve_table_free(table);
  limitcurve_law_free(law);
  return right ? 0 : 1;
}
