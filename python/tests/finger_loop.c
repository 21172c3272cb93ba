/* SPDX-License-Identifier: MIT */
/* What a step of a finger costs without Python: nanoseconds of an update that sticks, and of one that slips. */
#define _POSIX_C_SOURCE 199309L
#include "limitcurve.h"

#include <stdio.h>
#include <time.h>

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(void) {
  limitcurve_law* law;
  limitcurve_table* table;
  limitcurve_finger* finger;
  limitcurve_finger_parameters parameters = limitcurve_finger_defaults();
  parameters.mu = 0.6;
  parameters.radius_law = "constant:a=0.006";
  if (limitcurve_law_parse("hertz", &law) || limitcurve_table_build(law, 1e-6, &table) ||
      limitcurve_finger_new(table, &parameters, LIMITCURVE_CLOSEST_POINT, &finger)) {
    fprintf(stderr, "%s\n", limitcurve_error());
    return 1;
  }
  const int steps = 1000000;
  double sum = 0;
  for (int slips = 0; slips < 2; ++slips) {
    const double began = seconds();
    for (int i = 0; i < steps; ++i) {
      const limitcurve_contact contact = {{slips * 3e-5 * i, 0, 0}, {0, 0, 1}, 0.002, slips * 1e-2 * i, 0};
      limitcurve_finger_output output;
      limitcurve_finger_update(finger, &contact, 1e-3, &output);
      sum += output.load;
    }
    printf("%g\n", 1e9 * (seconds() - began) / steps);
  }
  return sum > 0 ? 0 : 1;
}
