/* SPDX-License-Identifier: MIT */
#ifndef LIMITCURVE_H
#define LIMITCURVE_H

/* limitcurve for C and for every language that calls C: friction limit curves of soft fingers, and a soft-finger
 * god-object. C99. Link with liblimitcurve-c. README.md beside this header has an example; examples/limitcurve.cs has
 * the declarations for C#. Fits are in limitcurve_fit.h.
 *
 * Units are SI: m, rad, N, N m, s. A unit wrench is a force in units of mu P and a moment in units of mu P a (friction
 * coefficient mu, load P, contact radius a), both magnitudes >= 0. A centre of rotation (COR) is given by its distance
 * from the contact's centre.
 *
 * Errors. A function that can fail returns a limitcurve_status, with the values of the command line's exit codes. If
 * the status is not LIMITCURVE_OK, the function wrote nothing through your pointers, and limitcurve_error() returns a
 * line that names the argument, its value and the values expected. No exception crosses this interface. NULL instead of
 * a handle, a text or an array is LIMITCURVE_INVALID; arrays of length 0 may be NULL.
 *
 * Ownership. The caller owns the handles that functions create, and frees each once with the function of that kind
 * (NULL is ignored). The library reads the caller's texts and arrays only during the call. Texts that a function
 * returns belong to the handle. A handle stays valid if the handles that it was made from are freed. A library built
 * without NDEBUG rejects freed handles.
 *
 * Threads. Laws, tables, batches, patches and fits are immutable: any number of threads may share them. Use a finger
 * from one thread at a time; distinct fingers need no lock. Errors are per thread.
 *
 * Real time. Functions marked [real time] take bounded time, and do not allocate, lock or throw. Call all others before
 * or after the loop. The text of an error is in thread-local storage. If the library was loaded by dlopen, the first
 * error of a thread may allocate it: call limitcurve_error() once in each thread before its loop. */

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(LIMITCURVE_C_BUILD)
#define LIMITCURVE_API __declspec(dllexport)
#elif defined(_WIN32)
#define LIMITCURVE_API __declspec(dllimport)
#else
#define LIMITCURVE_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum limitcurve_status {
  LIMITCURVE_OK = 0,
  LIMITCURVE_FAILED = 1, /* the job failed: no memory, a table that cannot be that fine, a fit that did not converge */
  LIMITCURVE_INVALID = 2 /* an argument is wrong */
} limitcurve_status;

/* A line about the last call of this thread that failed; "" if no call has failed. Valid until the next failure in
 * this thread. */
LIMITCURVE_API const char* limitcurve_error(void);

/* "MAJOR.MINOR.PATCH". */
LIMITCURVE_API const char* limitcurve_version(void);

/* ---- Pressure laws ---- */

typedef struct limitcurve_law limitcurve_law;

/* A law in the command line's grammar, for example "hertz", "uniform", "power:n=2.3", "mix:0.7*hertz+0.3*uniform". For
 * a measured law, call limitcurve_law_samples. */
LIMITCURVE_API limitcurve_status limitcurve_law_parse(const char* text, limitcurve_law** law);

/* A measured profile: pressures (any unit) at `count` >= 4 radii (any unit) that do not decrease. `rim` is the radius,
 * in that unit, that the contact radius stands for. If it is 0, the last radius with pressure counts, which is wrong if
 * noise or an offset of the sensor goes on beyond the contact. Negative pressures are noise, so pressures up to 1.5
 * times the most negative count as 0. Messages call the profile `source`. */
LIMITCURVE_API limitcurve_status limitcurve_law_samples(const double* radii, const double* pressures, size_t count,
                                                        const char* source, double rim, limitcurve_law** law);

LIMITCURVE_API void limitcurve_law_free(limitcurve_law* law);

/* The law's name; NULL for NULL. */
LIMITCURVE_API const char* limitcurve_law_name(const limitcurve_law* law);

/* m0: the unit moment of a pure twist. */
LIMITCURVE_API limitcurve_status limitcurve_law_moment_ratio(const limitcurve_law* law, double* moment_ratio);

/* Unit wrenches at `count` COR distances in contact radii, each in [0, inf] (NaN gives NaN): forces and moments, and
 * bounds on their absolute errors, which may be NULL. Relative error <= 1e-15 in closed form, <= 1e-14 by quadrature
 * (<= 2e-14 where long double is double). The outputs may be `cors` itself. */
LIMITCURVE_API limitcurve_status limitcurve_law_evaluate(const limitcurve_law* law, const double* cors, size_t count,
                                                         double* forces, double* moments, double* force_errors,
                                                         double* moment_errors);

/* ---- Limit curves that drive a finger ---- */

/* A limit curve for a loop: the table of a law, or an ellipse or a box in its place. */
typedef struct limitcurve_table limitcurve_table;

/* The table of `law` with an error of force and moment of at most tolerance * max(1, m0), tolerance in [1e-14, 0.1].
 * Milliseconds in closed form, up to seconds by quadrature. */
LIMITCURVE_API limitcurve_status limitcurve_table_build(const limitcurve_law* law, double tolerance,
                                                        limitcurve_table** table);

/* The ellipse with these semi-axes, in unit wrenches; the usual ellipse is (1, m0). */
LIMITCURVE_API limitcurve_status limitcurve_table_ellipse(double force_max, double moment_max,
                                                          limitcurve_table** table);

/* Separate limits of force and moment, which need LIMITCURVE_CLOSEST_POINT. */
LIMITCURVE_API limitcurve_status limitcurve_table_box(double force_max, double moment_max, limitcurve_table** table);

/* Reads a table from `limitcurve table -o FILE.csv` or limitcurve_table_csv. Error messages call the text `source`. */
LIMITCURVE_API limitcurve_status limitcurve_table_read_csv(const char* text, size_t length, const char* source,
                                                           limitcurve_table** table);

/* The table as CSV. NULL for an ellipse or a box, or without memory. */
LIMITCURVE_API const char* limitcurve_table_csv(const limitcurve_table* table);

LIMITCURVE_API void limitcurve_table_free(limitcurve_table* table);

/* Bound on the absolute error of unit force and moment against the law; 0 for an ellipse or a box. A measured pressure
 * adds the error that limitcurve_law_evaluate gives. */
LIMITCURVE_API limitcurve_status limitcurve_table_checked_error(const limitcurve_table* table, double* error);

/* Bytes that a look-up may touch; 0 for an ellipse or a box. */
LIMITCURVE_API limitcurve_status limitcurve_table_bytes(const limitcurve_table* table, size_t* bytes);

/* As limitcurve_law_evaluate, from the table. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_table_evaluate(const limitcurve_table* table, const double* cors,
                                                           size_t count, double* forces, double* moments);

/* Distance of unit wrenches from the origin divided by that of the curve on the same ray. A contact holds if it is < 1
 * and slips if it is > 1. Forces
 * and moments are finite; signs are ignored. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_table_gauge(const limitcurve_table* table, const double* forces,
                                                        const double* moments, size_t count, double* gauges);

/* ---- Friction ---- */

/* How a wrench outside the limit curve moves back onto it. */
enum {
  LIMITCURVE_RADIAL = 0,
  LIMITCURVE_C_CURVE = 1,
  LIMITCURVE_CLOSEST_POINT = 2 /* maximum dissipation: the wrench of the slip, if its direction stays. Recommended */
};
typedef int limitcurve_projection; /* an int, so that any other number is an error, not undefined behaviour */

/* Friction limits at the current load. */
typedef struct limitcurve_limits {
  double force;                 /* at rest: mu P [N] >= 0 ... */
  double radius;                /* ... and a [m] >= 0: the unit curve grows by force, and by force * radius */
  double sliding_force;         /* while it slips: neither the force ... */
  double sliding_radius;        /* ... nor force * radius is larger than at rest; the radius may be */
  double stiffness_ratio;       /* k_l/k_r of the springs [1/m^2] > 0 */
  double force_stick_fraction;  /* in [0, 1]: a sliding contact comes to rest once its trial is within this fraction of
                                   the limit, or within moment_stick_fraction if that is smaller. 1: as soon as the
                                   trial is within the limit */
  double moment_stick_fraction; /* of the moment; on a box, force and moment are compared separately */
} limitcurve_limits;

/* State of a contact's friction between steps; all 0 at first. */
typedef struct limitcurve_memory {
  double search_start;
  double search_rate;
  int force_slides;  /* whether the sliding limit acts; on a box, the sliding limit of the force */
  int moment_slides; /* on a box, whether the sliding limit of the moment acts */
} limitcurve_memory;

typedef struct limitcurve_friction {
  double force_fraction;  /* fraction of the trial's force within the limit, in [0, 1] */
  double moment_fraction; /* likewise */
  double cor;             /* of the slip [m], inf for pure sliding; NaN if it sticks */
  int slips;              /* in this step */
} limitcurve_friction;

/* Friction for simulators that have their own springs: given a trial force [N] and moment [N m], both finite, returns
 * the fractions of each that lie within the friction limit. LIMITCURVE_C_CURVE acts like LIMITCURVE_RADIAL here,
 * because there is no radius law. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_apply_friction(const limitcurve_table* table,
                                                           limitcurve_projection projection,
                                                           const limitcurve_limits* limits, double force, double moment,
                                                           limitcurve_memory* memory, limitcurve_friction* friction);

/* ---- Fingers ---- */

/* Parameters of a finger. Begin with limitcurve_finger_defaults(); zero bytes are refused. */
typedef struct limitcurve_finger_parameters {
  double mu;              /* coefficient of static friction >= 0 */
  double mu_dynamic;      /* while slipping, in [0, mu]; NaN: mu */
  const char* radius_law; /* a(P), in the command's grammar: "constant:a=0.005"; NULL beside mu_r */
  double mu_r; /* mu_r [m/N^gamma] >= 0: the moment limit is mu_r P^(1+gamma), instead of the radius law's; NaN: none */
  double gamma;           /* gamma, in [-0.5, 1] */
  double mu_r_dynamic;    /* while slipping; NaN: mu_r mu_d/mu */
  double stiffness;       /* k_l [N/m] > 0, normal and tangential */
  double twist_stiffness; /* k_r [N m/rad] > 0 */
  double damping;         /* b_l [N s/m] >= 0 */
  double twist_damping;   /* b_r [N m s/rad] >= 0 */
  double rest_margin;     /* >= 0: a sliding finger rests within its limit over 1 + rest_margin (mu/mu_dynamic - 1) */
  double max_speed;   /* [m/s] > 0: a sample is invalid if it lies farther from the last good one than this times the
                         time since then, at least 1 ms; the next sample counts if it stays there */
  double fault_decay; /* factor of load, force and moment from one invalid sample to the next, in [0, 1] */
} limitcurve_finger_parameters;

/* The defaults of the C++ library, NaN for what is absent, and a radius of 5 mm. */
LIMITCURVE_API limitcurve_finger_parameters limitcurve_finger_defaults(void);

/* The smallest loads [N] under which a contact carries forces [N] and moments [N m], whose signs are ignored; inf if
 * no load holds. Of the finger's parameters, the function reads mu, radius_law, mu_r and gamma. `limitcurve hold`
 * estimates the error from a measured pressure. */
LIMITCURVE_API limitcurve_status limitcurve_table_load_to_hold(const limitcurve_table* table,
                                                               const limitcurve_finger_parameters* contact,
                                                               const double* forces, const double* moments,
                                                               size_t count, double* loads);

typedef enum limitcurve_state {
  LIMITCURVE_FREE = 0,         /* no contact */
  LIMITCURVE_STICK = 1,        /* in contact, the proxy rests */
  LIMITCURVE_SLIP = 2,         /* in contact, the proxy slid in this step */
  LIMITCURVE_STATE_INVALID = 3 /* bad input: the last good output is held, and fades */
} limitcurve_state;

/* The reason for LIMITCURVE_STATE_INVALID. */
typedef enum limitcurve_fault {
  LIMITCURVE_FAULT_NONE = 0,
  LIMITCURVE_FAULT_NOT_FINITE = 1,  /* a NaN or an infinity in point, normal, depth, twist or orientation */
  LIMITCURVE_FAULT_TOO_FAR = 2,     /* the length of (point, depth, twist) is beyond 1e6 */
  LIMITCURVE_FAULT_ORIENTATION = 3, /* the length of the device's orientation is off 1 by more than 1e-2 */
  LIMITCURVE_FAULT_NORMAL = 4,      /* the length of the normal is off 1 by more than 1e-2 */
  LIMITCURVE_FAULT_TIME_STEP = 5,   /* the time step is < 0 or not finite */
  LIMITCURVE_FAULT_SPEED = 6,       /* faster than max_speed since the last good sample */
  LIMITCURVE_FAULT_BODY = 7,        /* not of this interface: the pose of a touched body */
  LIMITCURVE_FAULT_FORCE = 8        /* not of this interface: the force or the moment on a touched body */
} limitcurve_fault;

/* A contact of a finger with a surface. */
typedef struct limitcurve_contact {
  double point[3];  /* point of the surface nearest to the finger [m] */
  double normal[3]; /* outward; normalised if its length is within 1e-2 of 1 */
  double depth;     /* of the finger below the surface [m]; <= 0 outside */
  double twist;     /* of the device about the normal [rad]; may wrap around */
  int landed;       /* not 0: the finger left the surface since the last step and landed on it anew, as from one wall to
                       another; on another body call limitcurve_finger_reset before the step */
} limitcurve_contact;

/* Makes a single contact of the `count` walls that a finger is in, for example of two faces of a groove. All walls must
 * have the same finger position, point - normal * depth. The result has the nearest point outside of all walls; if
 * there is no such point, or if two walls meet at less than 90 degrees, the result is the deepest contact. The twist is
 * that of the first contact. Without walls, depth and normal are 0, so that a finger is free. If the tip is round, move
 * each point outward by the radius before. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_join(const limitcurve_contact* contacts, size_t count,
                                                 limitcurve_contact* joined);

/* Result of a step. The whole force on the user is normal * load + force, the moment is about the normal. After an
 * update under a load apply `force` and the moment alone: the engine pushes. */
typedef struct limitcurve_finger_output {
  double proxy[3]; /* position of the proxy [m] */
  double angle;    /* of the proxy [rad] */
  double depth;    /* [m] */
  double normal[3];
  double load; /* [N], the whole normal force: on a curved surface what bounds friction (k_l depth) and the surface's
                  own push */
  double force[3];  /* friction on the user [N], tangential */
  double moment;    /* friction on the user about the normal [N m] */
  double cor;       /* of the slip [m]; NaN unless it slips */
  double slip_work; /* dissipated in this step [J], >= 0 if converged */
  limitcurve_state state;
  int converged;          /* 0: the search for a patch's closest point did not converge */
  limitcurve_fault fault; /* the reason for LIMITCURVE_STATE_INVALID */
} limitcurve_finger_output;

typedef struct limitcurve_finger limitcurve_finger;
typedef struct limitcurve_patch limitcurve_patch;

LIMITCURVE_API limitcurve_status limitcurve_finger_new(const limitcurve_table* table,
                                                       const limitcurve_finger_parameters* parameters,
                                                       limitcurve_projection projection, limitcurve_finger** finger);

/* A finger with a contact that is not round; radius_law may be NULL. `point_radius` [m] smooths the points of a patch;
 * 0: 1e-3 m0. */
LIMITCURVE_API limitcurve_status limitcurve_finger_new_patch(const limitcurve_patch* patch,
                                                             const limitcurve_finger_parameters* parameters,
                                                             double point_radius, limitcurve_finger** finger);

LIMITCURVE_API void limitcurve_finger_free(limitcurve_finger* finger);

/* One step. Dampers and max_speed use `time_step` [s], the time since the last step. If it is 0, dampers do not act,
 * and a finger that moves farther than max_speed allows in 1 ms (5 mm by default) is taken for a jump. A value that is
 * not finite, a normal not of unit length, a jump or a time step < 0 is not an error: the state is
 * LIMITCURVE_STATE_INVALID, and `fault` names the reason. Outside (depth <= 0), point and normal must be good as well;
 * if you have none, pass the normal (0, 0, 0), so that the finger is free. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_finger_update(limitcurve_finger* finger, const limitcurve_contact* contact,
                                                          double time_step, limitcurve_finger_output* output);

/* One step inside a physics engine, which knows the load [N] but no depth. `contact->depth` is ignored; the output
 * repeats the load, and its depth is NaN. `contact->point` is the position of the finger on the surface. If the load is
 * <= 0 the finger is free, even if the contact is bad; a load that is not finite is bad input. Friction reaches its
 * limit on a surface of any radius. Otherwise as limitcurve_finger_update. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_finger_update_under_load(limitcurve_finger* finger,
                                                                     const limitcurve_contact* contact, double load,
                                                                     double time_step,
                                                                     limitcurve_finger_output* output);

/* These two take the device's orientation (w, x, y, z; finger to surface; like the normal, within 1e-2 of unit length)
 * instead of `twist`, which they do not read. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_finger_update_pose(limitcurve_finger* finger,
                                                               const limitcurve_contact* contact,
                                                               const double orientation[4], double time_step,
                                                               limitcurve_finger_output* output);
LIMITCURVE_API limitcurve_status limitcurve_finger_update_under_load_pose(limitcurve_finger* finger,
                                                                          const limitcurve_contact* contact,
                                                                          double load, const double orientation[4],
                                                                          double time_step,
                                                                          limitcurve_finger_output* output);

/* The result that an update would have, without a change of the finger. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_finger_preview(const limitcurve_finger* finger,
                                                           const limitcurve_contact* contact, double time_step,
                                                           limitcurve_finger_output* output);
LIMITCURVE_API limitcurve_status limitcurve_finger_preview_pose(const limitcurve_finger* finger,
                                                                const limitcurve_contact* contact,
                                                                const double orientation[4], double time_step,
                                                                limitcurve_finger_output* output);

/* Changes the parameters in the loop, for example when the finger touches another material. If one is out of range,
 * nothing changes. Proxy, angle and the last output stay; the next step uses the new springs at the same deflection. If
 * radius_law is NULL, a finger without mu_r keeps its radius law, and the call is [real time]. */
LIMITCURVE_API limitcurve_status limitcurve_finger_change(limitcurve_finger* finger,
                                                          const limitcurve_finger_parameters* parameters);

/* Gives one finger the state of another: proxy, memories and output, not its parameters. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_finger_copy_state(const limitcurve_finger* from, limitcurve_finger* to);

/* Energy in the springs [J], 0 while free. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_finger_spring_energy(const limitcurve_finger* finger,
                                                                 double* spring_energy);

/* Back to the state before any contact. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_finger_reset(limitcurve_finger* finger);

/* Distance to slip, from 1 (no friction) to 0 (slips), and the least `load` of the output [N] that would hold the
 * current friction. Either may be NULL. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_finger_margin(const limitcurve_finger* finger, double* margin,
                                                          double* load_to_hold);

/* The damping [N s/m] and twist damping [N m s/rad] that a device itself needs at a sample time [s], with its force
 * `delay` samples late (0 to 1000), so that a finger's sampled springs and dampers add no energy in any hand. Either
 * result may be NULL, and so may radius_law, which is not used. */
LIMITCURVE_API limitcurve_status limitcurve_device_damping_needed(const limitcurve_finger_parameters* parameters,
                                                                  double sample_time, int delay, double* sliding,
                                                                  double* twist);

/* Checks that a device with this damping has more than limitcurve_device_damping_needed. If not, returns
 * LIMITCURVE_INVALID, and limitcurve_error() says what to change. Pass infinity for a damping that you do not want to
 * check. */
LIMITCURVE_API limitcurve_status limitcurve_require_passive(const limitcurve_finger_parameters* parameters,
                                                            double sample_time, int delay, double sliding,
                                                            double twist);

/* The slip's centre of rotation, in the surface's frame [m]; infinite for pure sliding, NaN without slip. [real time]
 */
LIMITCURVE_API limitcurve_status limitcurve_finger_centre_of_rotation(const limitcurve_finger* finger,
                                                                      double centre_of_rotation[3]);

/* ---- Many contacts at once ---- */

/* Contacts in arrays of one length that do not overlap, each contact in its own tangent plane. The caller owns the
 * arrays; all 0 at first. */
typedef struct limitcurve_contacts {
  const double* x; /* the finger [m], up to 1e6 */
  const double* y;
  const double* twist; /* of the finger [rad], unwrapped */
  const double* depth; /* [m]; <= 0: free */
  double* proxy_x;     /* in and out */
  double* proxy_y;
  double* proxy_angle;
  uint8_t* state;         /* in and out: a limitcurve_state. If a sample or a proxy is NaN, the state is
                             LIMITCURVE_STATE_INVALID, and no other array of this contact changes */
  uint8_t* force_slides;  /* memory */
  uint8_t* moment_slides; /* memory, of the moment on a box */
  double* search_start;   /* memory */
  double* search_rate;    /* memory */
  double* fx;             /* out: friction on the user [N] */
  double* fy;
  double* moment; /* out [N m] */
} limitcurve_contacts;

/* limitcurve_contacts in single precision. */
typedef struct limitcurve_contacts_float {
  const float* x;
  const float* y;
  const float* twist;
  const float* depth;
  float* proxy_x;
  float* proxy_y;
  float* proxy_angle;
  uint8_t* state;
  uint8_t* force_slides;
  uint8_t* moment_slides;
  float* search_start;
  float* search_rate;
  float* fx;
  float* fy;
  float* moment;
} limitcurve_contacts_float;

typedef struct limitcurve_batch limitcurve_batch;

/* A step for contacts that share curve and parameters; it uses friction, radius law and stiffnesses. For double. */
LIMITCURVE_API limitcurve_status limitcurve_batch_new(const limitcurve_table* table,
                                                      const limitcurve_finger_parameters* parameters,
                                                      limitcurve_projection projection, limitcurve_batch** batch);

/* For float: the law's table in single precision, tolerance in [5e-7, 0.1]. */
LIMITCURVE_API limitcurve_status limitcurve_batch_new_float(const limitcurve_law* law, double tolerance,
                                                            const limitcurve_finger_parameters* parameters,
                                                            limitcurve_projection projection, limitcurve_batch** batch);

LIMITCURVE_API void limitcurve_batch_free(limitcurve_batch* batch);

/* Steps `count` contacts. Threads may share a batch, if each thread has a part of the arrays. A batch for the other
 * precision is rejected. [real time] */
LIMITCURVE_API limitcurve_status limitcurve_batch_step(const limitcurve_batch* batch,
                                                       const limitcurve_contacts* contacts, size_t count);
LIMITCURVE_API limitcurve_status limitcurve_batch_step_float(const limitcurve_batch* batch,
                                                             const limitcurve_contacts_float* contacts, size_t count);

/* ---- Contacts that are not round ---- */

/* `count` points [m] with loads >= 0 of any unit. */
LIMITCURVE_API limitcurve_status limitcurve_patch_points(const double* x, const double* y, const double* loads,
                                                         size_t count, limitcurve_patch** patch);
/* Uniform pressure on a simple polygon of `count` vertices [m]. */
LIMITCURVE_API limitcurve_status limitcurve_patch_polygon(const double* x, const double* y, size_t count,
                                                          limitcurve_patch** patch);
/* Uniform pressure on a rectangle with full sides x and y [m]. */
LIMITCURVE_API limitcurve_status limitcurve_patch_rectangle(double x, double y, limitcurve_patch** patch);
/* A law on the ellipse with semi-axes a (along x) and b [m]. */
LIMITCURVE_API limitcurve_status limitcurve_patch_ellipse(const limitcurve_law* law, double a, double b,
                                                          limitcurve_patch** patch);
/* A pressure image: `rows` rows of `columns` pressures, the first row at the largest y; pixels are squares of side
   `pixel` [m]. Negative pressures are noise, so those up to 1.5 times the most negative count as 0. NaN is rejected;
   pass 0 where there is no sensor. */
LIMITCURVE_API limitcurve_status limitcurve_patch_image(const double* pressures, size_t rows, size_t columns,
                                                        double pixel, limitcurve_patch** patch);
/* An image whose pixels are rectangles, `width` along x and `height` along y [m]. */
LIMITCURVE_API limitcurve_status limitcurve_patch_image_spaced(const double* pressures, size_t rows, size_t columns,
                                                               double width, double height, limitcurve_patch** patch);
/* The patch with orthotropic friction: mx times as much along x and my times as much along y, both 1e-6 to 1e6. */
LIMITCURVE_API limitcurve_status limitcurve_patch_orthotropic(const limitcurve_patch* patch, double mx, double my,
                                                              limitcurve_patch** result);

/* The patch as a table for a loop on a large image, because a wrench from a table costs 80 ns whatever the shape. The
 * error of force and moment is at most `tolerance`, in [1e-5, 0.1], in units of mu P and of the largest moment.
 * LIMITCURVE_INVALID if no table of 2 MiB has it; limitcurve_error() then names the finest tolerance. Up to seconds. */
LIMITCURVE_API limitcurve_status limitcurve_patch_table(const limitcurve_patch* patch, double tolerance,
                                                        limitcurve_patch** result);
/* Reads a table from `limitcurve table --patch P -o FILE.csv` or limitcurve_patch_csv. Error messages call the text
 * `source`. */
LIMITCURVE_API limitcurve_status limitcurve_patch_read_csv(const char* text, size_t length, const char* source,
                                                           limitcurve_patch** patch);
/* The table as CSV. NULL for a patch that is not a table, or without memory. */
LIMITCURVE_API const char* limitcurve_patch_csv(const limitcurve_patch* patch);
/* Bound on the error of a table against its patch; 0 for a patch that is not a table. */
LIMITCURVE_API limitcurve_status limitcurve_patch_checked_error(const limitcurve_patch* patch, double* error);

LIMITCURVE_API void limitcurve_patch_free(limitcurve_patch* patch);

/* The wrenches (fx, fy, moment) that keep the patch sliding with `count` twists (vx, vy, omega) [m/s, rad/s] about the
 * origin, three numbers each, for mu = 1 and load 1. Their powers [m/s] and the bounds on their errors may be NULL.
 * [real time] */
LIMITCURVE_API limitcurve_status limitcurve_patch_wrench(const limitcurve_patch* patch, const double* twists,
                                                         size_t count, double* wrenches, double* powers,
                                                         double* errors);

/* The smallest loads [N], of all points together, under which the patch carries `count` wrenches (fx, fy, moment) [N, N
 * m] about the origin, three numbers each, with friction `mu` >= 0; inf if no load holds. */
LIMITCURVE_API limitcurve_status limitcurve_patch_load_to_hold(const limitcurve_patch* patch, double mu,
                                                               const double* wrenches, size_t count, double* loads);

/* The twists (vx, vy, omega) [m/s, rad/s] with which the patch slips under `count` wrenches (fx, fy, moment) [N, N m],
 * both about the origin, three numbers each: at the load that just holds, of power 1 W against the wrench; NaN for
 * wrench 0, and if no load holds. Bounds on |dF|/(mu P) and |dM|/(mu P m0), from the wrench to what the twist needs,
 * may be NULL. */
LIMITCURVE_API limitcurve_status limitcurve_patch_slip(const limitcurve_patch* patch, const double* wrenches,
                                                       size_t count, double* twists, double* errors);

#ifdef __cplusplus
}
#endif

#endif
