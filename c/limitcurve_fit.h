/* SPDX-License-Identifier: MIT */
#ifndef LIMITCURVE_FIT_H
#define LIMITCURVE_FIT_H

/* Fits of friction models to measurements, by the rules of limitcurve.h. Link also with liblimitcurve-c-fit, which is
 * apart because fits need Ceres. */

#include "limitcurve.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct limitcurve_fit limitcurve_fit;

/* Fits the friction model "ellipse", "ratio" or "law" to `count` measured slips with loads [N], forces [N], moments
 * [N m], and standard deviations (both arrays, or both NULL). If `law` is NULL, "ratio" uses hertz, and "law" finds the
 * best. The contact radius is proportional to P^gamma, gamma in [-0.5, 1]. */
LIMITCURVE_API limitcurve_status limitcurve_fit_slips(const char* model, const double* loads, const double* forces,
                                                      const double* moments, const double* sigma_forces,
                                                      const double* sigma_moments, size_t count,
                                                      const limitcurve_law* law, double gamma, limitcurve_fit** fit);

/* Fits c P^gamma to `count` contact radii [m] at loads [N]. The model is "linear" (gamma 0), "hertz" (1/3), "power"
 * (gamma free) or "best", which chooses among these. `sigmas` may be NULL. */
LIMITCURVE_API limitcurve_status limitcurve_fit_radii(const char* model, const double* loads, const double* radii,
                                                      const double* sigmas, size_t count, limitcurve_fit** fit);

LIMITCURVE_API void limitcurve_fit_free(limitcurve_fit* fit);

/* The fitted or best model, the note with its assumptions, and the warnings, NULL after the last. NULL for NULL. */
LIMITCURVE_API const char* limitcurve_fit_model(const limitcurve_fit* fit);
LIMITCURVE_API const char* limitcurve_fit_note(const limitcurve_fit* fit);
LIMITCURVE_API const char* limitcurve_fit_warning(const limitcurve_fit* fit, size_t index);

/* The number of estimates, 0 for NULL, and for each the name, value, standard error (0 if fixed) and unit. Outputs may
 * be NULL. */
LIMITCURVE_API size_t limitcurve_fit_count(const limitcurve_fit* fit);
LIMITCURVE_API limitcurve_status limitcurve_fit_estimate(const limitcurve_fit* fit, size_t index, const char** name,
                                                         double* value, double* std_error, const char** unit);

#ifdef __cplusplus
}
#endif

#endif
