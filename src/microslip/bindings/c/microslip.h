/* SPDX-License-Identifier: MIT */
#ifndef MICROSLIP_H
#define MICROSLIP_H

/** @file
 * The C interface of microslip: joints with friction, their memory, their identification from levels
 * of vibration, and structures with joints over frequency and time. Results are those of the C++
 * library, to the last bit.
 *
 * Rules that hold for all functions:
 *
 *   - Values are SI: m, N, s, J, kg, Hz. Indices begin at 0.
 *   - A function returns MICROSLIP_OK or an error code; then microslip_last_error() describes the
 *     error in a sentence that names the argument. On an error no output is written, with one
 *     exception: MICROSLIP_NOT_CONVERGED comes with a result, which may be partial.
 *   - A pointer may be NULL where its comment says so, and else must not be; numbers must be finite
 *     unless a comment says otherwise. A broken rule gives MICROSLIP_INPUT, never a crash.
 *   - A handle is destroyed by the function of its kind, which also accepts NULL. It owns what it
 *     needs: a memory stays valid when its joint is destroyed.
 *   - Text and arrays that a function points to belong to the handle and live as long as it does. Text
 *     is UTF-8 and ends in 0.
 *   - Different threads may use different handles at once. Joints, levels, structures and results do
 *     not change and may be shared; a memory or a model that is being built may not.
 *   - Options carry their size, so that later versions add members at the end: fill them with the
 *     function of defaults of their kind, then change members. NULL in place of options: the defaults.
 *   - Complex numbers are factors of e^{iωt}. */

#include <stddef.h>
#include <stdint.h>

#include "microslip_version.h"

/** Marks what the library exports. */
#if defined(__GNUC__)
#define MICROSLIP_API __attribute__((visibility("default")))
#else
#define MICROSLIP_API
#endif

/** Gives enumerations the type int in C++ too: an unknown value is then an error, not undefined. */
#ifdef __cplusplus
#define MICROSLIP_INT : int
extern "C" {
#else
#define MICROSLIP_INT
#endif

/* ---- Errors ------------------------------------------------------------------------------------- */

/** How a call ended. */
typedef enum microslip_status MICROSLIP_INT {
  MICROSLIP_OK = 0,            /**< done */
  MICROSLIP_INPUT = 1,         /**< an argument breaks a rule */
  MICROSLIP_FORMAT = 2,        /**< a file does not have the required format */
  MICROSLIP_FILE = 3,          /**< a file cannot be opened, read or written */
  MICROSLIP_NOT_CONVERGED = 4, /**< there is a result, but its method did not converge */
  MICROSLIP_CANCELLED = 5,     /**< the listener to the progress asked to stop */
  MICROSLIP_MEMORY = 6,        /**< no memory left */
  MICROSLIP_INTERNAL = 7       /**< an error of microslip itself */
} microslip_status;

/** The error message of the last call of this thread that did not end with MICROSLIP_OK, one line:
 * "argument = value; rule. remedy". Never NULL; valid until the next such call of the thread. */
MICROSLIP_API const char *microslip_last_error(void);

/** The version of the library, "major.minor.patch". MICROSLIP_VERSION is that of the header. */
MICROSLIP_API const char *microslip_version(void);

/** Called now and then by a long computation of which `done` of `total` pieces are done. It returns
 * other than 0 to go on; with 0 the computation ends with MICROSLIP_CANCELLED and without a result. It
 * may be called from any thread, but never by two at once. */
typedef int (*microslip_progress)(size_t done, size_t total, void *user);

/** How a method ended. */
typedef struct microslip_outcome {
  size_t struct_size;   /**< set by the caller to sizeof(microslip_outcome) */
  int converged;        /**< 1 where its stopping criterion was met and no check failed */
  int usable;           /**< 1 where there is a result to use, with `reason` in mind */
  int iterations;       /**< number of iterations */
  double residual;      /**< measure of the stopping criterion, 1 */
  const char *method;   /**< its name */
  const char *reason;   /**< why it stopped */
  const char *summary;  /**< some lines for the user */
  size_t warning_count; /**< number of warnings, see the functions …_warning */
} microslip_outcome;

/* ---- Joints ------------------------------------------------------------------------------------- */

/** A joint F(x) of stiffness k and density φ of slip forces, with its provenance where it was read or
 * identified. Immutable. */
typedef struct microslip_joint microslip_joint;

/** Kinds of parts of a density. */
typedef enum microslip_part_kind MICROSLIP_INT {
  MICROSLIP_PART_UNIFORM = 0,          /**< φ = weight/(to − from) on [from, to] */
  MICROSLIP_PART_POWER_LAW = 1,        /**< φ = coefficient·f*^exponent on [from, to] */
  MICROSLIP_PART_PIECEWISE_LINEAR = 2, /**< φ = value[i] at slip_force[i], linear between, 0 outside */
  MICROSLIP_PART_ATOMS = 3,            /**< φ = Σ value[i] δ(f* − slip_force[i]) */
  MICROSLIP_PART_FOUR_PARAMETER = 4    /**< Segalman's, J. Appl. Mech. 72 (2005) 752; only alone */
} microslip_part_kind;

/** A part of a density; those of a joint add up, and ∫φ df* must not exceed 1. Members that its kind
 * does not have are ignored. See microslip_part_defaults(). */
typedef struct microslip_part {
  size_t struct_size;       /**< of the caller's struct */
  microslip_part_kind kind; /**< kind of the part */
  double from;              /**< N; ≥ 0; of UNIFORM and POWER_LAW */
  double to;                /**< N; > from; of UNIFORM and POWER_LAW */
  double weight;            /**< share of the stiffness, 1; ≥ 0; of UNIFORM */
  double coefficient;       /**< R, N^−(1+exponent); ≥ 0; of POWER_LAW */
  double exponent;          /**< χ, 1; > −1 where from = 0; of POWER_LAW */
  size_t count;             /**< knots (≥ 2) or atoms (≥ 1) */
  const double *slip_force; /**< N; ≥ 0 and rising at knots, > 0 of atoms; `count` values */
  const double *value;      /**< 1/N at knots, share of the stiffness of atoms; ≥ 0; `count` values */
  double macroslip_force;   /**< F_S, N; > 0; of FOUR_PARAMETER, whose stiffness is that of the joint */
  double chi;               /**< χ, 1; −1 < χ ≤ 0; of FOUR_PARAMETER */
  double beta;              /**< β, 1; ≥ 0; of FOUR_PARAMETER */
} microslip_part;

/** All members 0, but the size. @param part  to fill. @param struct_size  sizeof(microslip_part). */
MICROSLIP_API microslip_status microslip_part_defaults(microslip_part *part, size_t struct_size);

/** A joint of its parts.
 * @param stiffness  k, N/m; > 0.
 * @param parts      `count` of them, of one size; NULL where there are none: a spring.
 * @param count      how many.
 * @param joint      the joint. */
MICROSLIP_API microslip_status microslip_joint_create(double stiffness, const microslip_part *parts,
                                                      size_t count, microslip_joint **joint);

/** Reads a joint.json. @param path  of the file. @param joint  the joint. */
MICROSLIP_API microslip_status microslip_joint_read(const char *path, microslip_joint **joint);

/** A joint from the text of a joint.json. @param text  all of it. @param joint  the joint. */
MICROSLIP_API microslip_status microslip_joint_parse(const char *text, microslip_joint **joint);

/** Writes a joint.json, as the program does: with provenance and identification where the joint was
 * read or identified, else with the version of the library alone. The file appears whole or not at
 * all, and replaces only a joint.json that microslip wrote.
 * @param joint  to write. @param path  of the file. */
MICROSLIP_API microslip_status microslip_joint_write(const microslip_joint *joint, const char *path);

/** The text that microslip_joint_write() writes, without a provenance where the joint has none.
 * @param joint  any. @param text  of the joint. */
MICROSLIP_API microslip_status microslip_joint_text(const microslip_joint *joint, const char **text);

/** Destroys a joint. @param joint  may be NULL. */
MICROSLIP_API void microslip_joint_destroy(microslip_joint *joint);

/** k, N/m. @param joint  any. @param stiffness  k. */
MICROSLIP_API microslip_status microslip_joint_stiffness(const microslip_joint *joint,
                                                         double *stiffness);

/** The number of parts. @param joint  any. @param count  of its density. */
MICROSLIP_API microslip_status microslip_joint_part_count(const microslip_joint *joint,
                                                          size_t *count);

/** Returns a part as it was given. @param joint  any. @param index  below the number of parts.
 * @param part  its struct_size is set by the caller; its arrays belong to the joint. */
MICROSLIP_API microslip_status microslip_joint_part(const microslip_joint *joint, size_t index,
                                                    microslip_part *part);

/** The virgin force F(x) = Φ1(k|x|) + k|x|[1 − Φ0(k|x|)], odd in x: on first loading.
 * @param joint         any.
 * @param count         of the arrays; 0 does nothing.
 * @param displacement  x, m.
 * @param force         F, N; may be `displacement` itself. */
MICROSLIP_API microslip_status microslip_virgin_force(const microslip_joint *joint, size_t count,
                                                      const double *displacement, double *force);

/** The tangent stiffness F′(x) = k[1 − Φ0(k|x|)] on first loading, N/m. At an atom that beyond it.
 * @param joint, count, displacement  as of microslip_virgin_force(). @param stiffness  F′, N/m. */
MICROSLIP_API microslip_status microslip_tangent_stiffness(const microslip_joint *joint, size_t count,
                                                           const double *displacement,
                                                           double *stiffness);

/** The energy D(A) = 4[AΦ1(kA) − Φ2(kA)/k] that a steady cycle dissipates, J.
 * @param joint      any.
 * @param count      of the arrays; 0 does nothing.
 * @param amplitude  A, m; ≥ 0.
 * @param energy     D, J; may be `amplitude` itself. */
MICROSLIP_API microslip_status microslip_dissipation(const microslip_joint *joint, size_t count,
                                                     const double *amplitude, double *energy);

/** The secant stiffness k_eq(A) of the first harmonic, N/m; k at A = 0.
 * @param joint, count, amplitude  as of microslip_dissipation(). @param stiffness  k_eq, N/m. */
MICROSLIP_API microslip_status microslip_secant_stiffness(const microslip_joint *joint, size_t count,
                                                          const double *amplitude,
                                                          double *stiffness);

/** The density φ(f*) without its atoms, 1/N. Infinite at 0 where a power law with a negative exponent
 * begins there.
 * @param joint       any.
 * @param count       of the arrays; 0 does nothing.
 * @param slip_force  f*, N; ≥ 0.
 * @param density     φ, 1/N; may be `slip_force` itself. */
MICROSLIP_API microslip_status microslip_density(const microslip_joint *joint, size_t count,
                                                 const double *slip_force, double *density);

/* ---- Memory ------------------------------------------------------------------------------------- */

/** The exact memory of a joint: the reversals of its displacement, by Madelung's rules. For an
 * implicit integrator: microslip_memory_trial() at each iteration, microslip_memory_advance() once at
 * convergence. Not for two threads at once. */
typedef struct microslip_memory microslip_memory;

/** Creates a memory in the virgin state at x = 0. @param joint  kept alive. @param memory  of it. */
MICROSLIP_API microslip_status microslip_memory_create(const microslip_joint *joint,
                                                       microslip_memory **memory);

/** Copies a memory with its state. @param memory  any. @param copy  of it. */
MICROSLIP_API microslip_status microslip_memory_copy(const microslip_memory *memory,
                                                     microslip_memory **copy);

/** Assigns the state of another memory, its joint included: back to a snapshot.
 * @param memory  that is overwritten. @param from  the snapshot. */
MICROSLIP_API microslip_status microslip_memory_assign(microslip_memory *memory,
                                                       const microslip_memory *from);

/** Destroys a memory. @param memory  may be NULL. */
MICROSLIP_API void microslip_memory_destroy(microslip_memory *memory);

/** Force and tangent after a step to x, which is not taken.
 * @param memory        any.
 * @param displacement  x, m.
 * @param force         f, N.
 * @param tangent       df/dx in the direction of the step, N/m; NULL where it is not needed. */
MICROSLIP_API microslip_status microslip_memory_trial(const microslip_memory *memory,
                                                      double displacement, double *force,
                                                      double *tangent);

/** Takes the step to x. @param memory  that moves. @param displacement  x, m.
 * @param force  f there, N; NULL where it is not needed. */
MICROSLIP_API microslip_status microslip_memory_advance(microslip_memory *memory, double displacement,
                                                        double *force);

/** Takes a step to each x in turn. On an error no step is taken.
 * @param memory        that moves.
 * @param count         of the arrays; 0 does nothing.
 * @param displacement  x, m.
 * @param force         f, N; may be `displacement` itself. */
MICROSLIP_API microslip_status microslip_memory_march(microslip_memory *memory, size_t count,
                                                      const double *displacement, double *force);

/** The energy that the sliders would dissipate in a step to x, J; over the steps taken it adds up.
 * @param memory  any. @param displacement  x, m. @param energy  J; ≥ 0. */
MICROSLIP_API microslip_status microslip_memory_dissipation(const microslip_memory *memory,
                                                            double displacement, double *energy);

/** The energy in the springs of all elements, J: ∫ f dx = dissipated + its change, on any path.
 * @param memory  any. @param energy  J. */
MICROSLIP_API microslip_status microslip_memory_stored_energy(const microslip_memory *memory,
                                                              double *energy);

/** The present state of the joint. @param memory  any. @param displacement  x, m; may be NULL.
 * @param force  f, N; may be NULL. */
MICROSLIP_API microslip_status microslip_memory_state(const microslip_memory *memory,
                                                      double *displacement, double *force);

/** Back to the virgin state at x = 0. @param memory  that forgets. */
MICROSLIP_API microslip_status microslip_memory_reset(microslip_memory *memory);

/* ---- Levels, and the joint identified from them ------------------------------------------------- */

/** Levels of vibration: amplitude and dissipation of each, and further measured columns. */
typedef struct microslip_levels microslip_levels;

/** Columns of levels in addition to amplitude and dissipation. */
typedef enum microslip_level_column MICROSLIP_INT {
  MICROSLIP_LEVEL_AMPLITUDE_STD = 0,        /**< standard deviation of A, m; ≥ 0 */
  MICROSLIP_LEVEL_DISSIPATION_STD = 1,      /**< standard deviation of D, J; ≥ 0 */
  MICROSLIP_LEVEL_SECANT_STIFFNESS = 2,     /**< k_eq of the first harmonic, N/m; > 0 */
  MICROSLIP_LEVEL_SECANT_STIFFNESS_STD = 3, /**< its standard deviation, N/m; ≥ 0 */
  MICROSLIP_LEVEL_LINEAR_DISSIPATION = 4,   /**< W_lin that was subtracted, J; ≥ 0 */
  MICROSLIP_LEVEL_FREQUENCY = 5,            /**< of the resonance, Hz; > 0 */
  MICROSLIP_LEVEL_FREQUENCY_STD = 6         /**< its standard deviation, Hz; ≥ 0 */
} microslip_level_column;

/** Levels in any order.
 * @param count        of the arrays; ≥ 1.
 * @param amplitude    A of the joint displacement, m; > 0.
 * @param dissipation  D, lost per cycle, J; ≥ 0.
 * @param levels       of them; the arrays are copied. */
MICROSLIP_API microslip_status microslip_levels_create(size_t count, const double *amplitude,
                                                       const double *dissipation,
                                                       microslip_levels **levels);

/** Adds a column to levels that are not in use at the time, or replaces it. An identification from
 * levels of a file that were changed so does not name the file as its input.
 * @param levels  that get it. @param column  which. @param count  as many as there are levels.
 * @param values  copied. */
MICROSLIP_API microslip_status microslip_levels_set(microslip_levels *levels,
                                                    microslip_level_column column, size_t count,
                                                    const double *values);

/** Reads a levels.csv, as `microslip identify` does: levels with inner reversals are left out. W_lin
 * is read where there is a column linear_dissipation.
 * @param path  of the file. @param levels  of it. */
MICROSLIP_API microslip_status microslip_levels_read(const char *path, microslip_levels **levels);

/** The number of levels. @param levels  any. @param count  of them. */
MICROSLIP_API microslip_status microslip_levels_count(const microslip_levels *levels, size_t *count);

/** Destroys levels. @param levels  may be NULL. */
MICROSLIP_API void microslip_levels_destroy(microslip_levels *levels);

/** How a joint is identified; see `microslip identify --help`. Text is not kept after the call. */
typedef struct microslip_identify_options {
  size_t struct_size;           /**< of the caller's struct */
  double stiffness;             /**< k of the stuck joint, N/m; 1e-6 to 1e15; has no default */
  const char *method;           /**< "inversion" (default), "spline", "differences" */
  const char *smoothing;        /**< "gcv" (default), "lambda=X", "p=X" */
  const char *smoothing_unit;   /**< of the amplitude with "p=X" of the spline: "mm"; NULL without */
  const char *fit;              /**< "none" (default), "four_parameter", "power_law", "uniform" */
  int linear_damping;           /**< 1: identifies β of D = … + βA² as well; 0 (default) */
  int atom;                     /**< 1: seeks macro-slip as well; 0 (default) */
  int edges;                    /**< 1 (default): the density may jump; 0 */
  size_t bands;                 /**< draws of the band; 0 (default): no band, else 20 to 10⁶ */
  double confidence;            /**< nominal coverage of the band, in (0, 1); 0.95 */
  uint64_t seed;                /**< of the draws; 1 */
  double dissipation_gain_std;  /**< relative error of D that all levels share, 1; 0 */
  double amplitude_gain_std;    /**< relative error of A that all levels share, 1; 0 */
  double loss_factor_std;       /**< relative error of the loss in W_lin, 1; 0; needs W_lin */
  int threads;                  /**< for the draws: 0 (default) one per processor, 1 the caller's */
  const char *command;          /**< the command recorded in joint.json, a line; NULL: a text of
                                     microslip */
  microslip_progress progress;  /**< called with the draws done; NULL (default): none */
  void *user;                   /**< handed to it */
} microslip_identify_options;

/** Defaults. @param options  to fill. @param struct_size  sizeof(microslip_identify_options). */
MICROSLIP_API microslip_status
microslip_identify_options_defaults(microslip_identify_options *options, size_t struct_size);

/** Result of an identification of a joint from levels. */
typedef struct microslip_identification microslip_identification;

/** Identifies a joint from its levels.
 * @param levels          4 amplitudes at least with the method "inversion".
 * @param options         must have a stiffness.
 * @param identification  also set where the status is MICROSLIP_NOT_CONVERGED. */
MICROSLIP_API microslip_status microslip_identify(const microslip_levels *levels,
                                                  const microslip_identify_options *options,
                                                  microslip_identification **identification);

/** Destroys an identification. @param identification  may be NULL. */
MICROSLIP_API void microslip_identification_destroy(microslip_identification *identification);

/** The identified joint, as a new handle that the caller destroys. With provenance and identification,
 * so that microslip_joint_write() writes the joint.json that the program writes.
 * @param identification  any. @param joint  the identified joint. */
MICROSLIP_API microslip_status microslip_identification_joint(
    const microslip_identification *identification, microslip_joint **joint);

/** Arrays of an identification. */
typedef enum microslip_identified_values MICROSLIP_INT {
  MICROSLIP_IDENTIFIED_SLIP_FORCE = 0, /**< f*, N, rising */
  MICROSLIP_IDENTIFIED_DENSITY = 1,    /**< φ there, 1/N */
  MICROSLIP_IDENTIFIED_LOWER = 2,      /**< lower end of the band, 1/N; no values without a band */
  MICROSLIP_IDENTIFIED_UPPER = 3       /**< upper end of the band, 1/N; no values without a band */
} microslip_identified_values;

/** An array. @param identification  any. @param what  which.
 * @param values  of it. @param count  how many; 0 where there are none. */
MICROSLIP_API microslip_status microslip_identification_values(
    const microslip_identification *identification, microslip_identified_values what,
    const double **values, size_t *count);

/** Numbers of an identification. */
typedef enum microslip_identified_number MICROSLIP_INT {
  MICROSLIP_IDENTIFIED_COVERED_FROM = 0,  /**< N: below it only two moments of φ are determined */
  MICROSLIP_IDENTIFIED_COVERED_TO = 1,    /**< N: above it nothing is determined */
  MICROSLIP_IDENTIFIED_LINEAR_DAMPING = 2 /**< β, J/m²; NaN where it was not identified */
} microslip_identified_number;

/** A number. @param identification  any. @param what  which. @param value  of it. */
MICROSLIP_API microslip_status microslip_identification_number(
    const microslip_identification *identification, microslip_identified_number what,
    double *value);

/** How it ended. @param identification  any. @param outcome  its struct_size is set by the caller. */
MICROSLIP_API microslip_status microslip_identification_outcome(
    const microslip_identification *identification, microslip_outcome *outcome);

/** A warning. @param identification  any. @param index  below warning_count.
 * @param code  stable, for programs; may be NULL. @param text  a sentence; may be NULL. */
MICROSLIP_API microslip_status microslip_identification_warning(
    const microslip_identification *identification, size_t index, const char **code,
    const char **text);

/* ---- Structures --------------------------------------------------------------------------------- */

/** A structure under construction. Not for two threads at once. */
typedef struct microslip_model microslip_model;

/** A structure of modes, joints and excitations. Immutable. */
typedef struct microslip_structure microslip_structure;

/** Frequency dependence of the damping. */
typedef enum microslip_damping MICROSLIP_INT {
  MICROSLIP_VISCOUS = 0,   /**< i η_i ω_i nω q_i in harmonic n */
  MICROSLIP_HYSTERETIC = 1 /**< i η_i ω_i² q_i in each harmonic */
} microslip_damping;

/** Begins a model of modes: q̈_i + η_i ω_i q̇_i + ω_i² q_i = Σ_p φ_i(p) f_p, w(p) = Σ_i φ_i(p) q_i.
 * @param modes        ≥ 1.
 * @param frequency    ω_i/(2π), Hz; ≥ 0, 0 of a rigid body; one per mode.
 * @param loss_factor  η_i = 2ζ_i, 1; ≥ 0; one per mode.
 * @param damping      of all modes.
 * @param model        of them. */
MICROSLIP_API microslip_status microslip_model_create(size_t modes, const double *frequency,
                                                      const double *loss_factor,
                                                      microslip_damping damping,
                                                      microslip_model **model);

/** Destroys a model. @param model  may be NULL. */
MICROSLIP_API void microslip_model_destroy(microslip_model *model);

/** Adds a point. @param model  that gets it. @param name  not empty, no two the same.
 * @param modes  as many as the model has. @param shape  φ_i, mass-normalised, kg^−½; per mode. */
MICROSLIP_API microslip_status microslip_model_add_point(microslip_model *model, const char *name,
                                                         size_t modes, const double *shape);

/** Options of a joint in a structure. */
typedef struct microslip_joint_options {
  size_t struct_size;       /**< of the caller's struct */
  double spring_in_modes;   /**< k_s between its ends that the modes were computed with, N/m; ≥ 0; 0 */
  double series_compliance; /**< c in series with the joint, m/N; ≥ 0; 0 */
  double linear_damping;    /**< β, J/m², ≥ 0; NaN (default): as identified with the joint, else 0 */
} microslip_joint_options;

/** Defaults. @param options  to fill. @param struct_size  sizeof(microslip_joint_options). */
MICROSLIP_API microslip_status microslip_joint_options_defaults(microslip_joint_options *options,
                                                                size_t struct_size);

/** Adds a joint. @param model  that gets it. @param name  not empty, no two the same.
 * @param joint    kept alive.
 * @param modes    as many as the model has.
 * @param shape    ψ_i, relative displacement across the joint over q_i, kg^−½; one per mode.
 * @param options  NULL: the defaults. */
MICROSLIP_API microslip_status microslip_model_add_joint(microslip_model *model, const char *name,
                                                         const microslip_joint *joint, size_t modes,
                                                         const double *shape,
                                                         const microslip_joint_options *options);

/** Adds a periodic force at a point, f(t) = A Re Σ_n s_n e^{inωt}: it drives frequency responses.
 * @param model      that gets it; one at least.
 * @param point      where it acts.
 * @param harmonics  1 to 1000.
 * @param real       Re s_n, 1, of harmonic n = 1, 2, …; NULL with one harmonic: 1.
 * @param imaginary  Im s_n, 1; NULL: zeros. */
MICROSLIP_API microslip_status microslip_model_add_excitation(microslip_model *model,
                                                              const char *point, size_t harmonics,
                                                              const double *real,
                                                              const double *imaginary);

/** Adds a constant force. @param model  that gets it. @param point  where it acts.
 * @param force  N. */
MICROSLIP_API microslip_status microslip_model_add_static_load(microslip_model *model,
                                                               const char *point, double force);

/** Creates the structure; the model may be used further or be destroyed.
 * @param model  with a point and an excitation. @param structure  of it. */
MICROSLIP_API microslip_status microslip_structure_create(const microslip_model *model,
                                                          microslip_structure **structure);

/** Reads a model.toml with the joint files that it names. @param path  of the file.
 * @param structure  of it. */
MICROSLIP_API microslip_status microslip_structure_read(const char *path,
                                                        microslip_structure **structure);

/** Destroys a structure. @param structure  may be NULL. */
MICROSLIP_API void microslip_structure_destroy(microslip_structure *structure);

/** Undamped natural frequencies with all joints stuck.
 * @param structure  any. @param frequency  Hz, rising; they belong to the structure.
 * @param count  how many. */
MICROSLIP_API microslip_status microslip_structure_stuck_frequencies(
    const microslip_structure *structure, const double **frequency, size_t *count);

/** Numbers of points and joints. @param structure  any. @param points  may be NULL.
 * @param joints  may be NULL. */
MICROSLIP_API microslip_status microslip_structure_counts(const microslip_structure *structure,
                                                          size_t *points, size_t *joints);

/** The name of a point. @param structure  any. @param index  in the order given. @param name  of it. */
MICROSLIP_API microslip_status microslip_structure_point(const microslip_structure *structure,
                                                         size_t index, const char **name);

/** The name of a joint. @param structure  any. @param index  in the order given. @param name  of it. */
MICROSLIP_API microslip_status microslip_structure_joint(const microslip_structure *structure,
                                                         size_t index, const char **name);

/* ---- Steady vibrations over frequency ----------------------------------------------------------- */

/** Kinds of response at a point. */
typedef enum microslip_response MICROSLIP_INT {
  MICROSLIP_DISPLACEMENT = 0, /**< |w_1|, m */
  MICROSLIP_VELOCITY = 1,     /**< ω|w_1|, m/s */
  MICROSLIP_ACCELERATION = 2  /**< ω²|w_1|, m/s² */
} microslip_response;

/** The quantity held constant along a curve over the frequency. */
typedef enum microslip_kept MICROSLIP_INT {
  MICROSLIP_KEEP_FORCE = 0,   /**< the amplitude A of the excitations, N (m/s² of a base) */
  MICROSLIP_KEEP_RESPONSE = 1 /**< the response; the force is computed */
} microslip_kept;

/** How steady vibrations are computed. */
typedef struct microslip_frf_options {
  size_t struct_size;          /**< of the caller's struct */
  size_t harmonics;            /**< H: harmonics 0 to H; from 1; 5 */
  size_t samples;              /**< per cycle for the forces of joints; from 2H + 2; 256 */
  double tolerance;            /**< largest residual, relative, 1; 1e-14 to 1e-4; 1e-12 */
  int max_iterations;          /**< evaluations that one solution may take; ≥ 2; 40 */
  double largest_change;       /**< from a point to the next, relative, 1; 1e-6 to 1; 0.2 */
  int least_points;            /**< of a curve; ≥ 1; 20 */
  int max_points;              /**< of a curve; ≥ 2; 5000 */
  double accuracy;             /**< interpolation error of the polygon, relative, 1; ≥ 0; 0.002 */
  size_t at_count;             /**< number of additional frequencies of points of the curve; 0 */
  const double *at;            /**< Hz; `at_count` of them, within the range of
                                    microslip_frf(); backbones have none */
  microslip_response response; /**< kind with MICROSLIP_KEEP_RESPONSE and on backbones */
  int modal_forcing;           /**< 1: a backbone is the nonlinear mode; 0 (default) */
  int judge;                   /**< 1 (default): warnings assess the effect of missing harmonics and
                                    modes, as in the program; 0: not, which saves time */
  microslip_progress progress; /**< called with the progress; NULL (default): none */
  void *user;                  /**< handed to it */
} microslip_frf_options;

/** Defaults. @param options  to fill. @param struct_size  sizeof(microslip_frf_options). */
MICROSLIP_API microslip_status microslip_frf_options_defaults(microslip_frf_options *options,
                                                              size_t struct_size);

/** A curve of steady vibrations, in the order of the curve, which may turn back. */
typedef struct microslip_curve microslip_curve;

/** Computes the curve over the frequency from `from` to `to`, which may be lower; both are on it.
 * @param structure  any.
 * @param point      where the response is measured; NULL: as given in the file of the model, else at
 *                   the first excitation.
 * @param kept       the constant quantity.
 * @param value      of it; > 0.
 * @param from       Hz; > 0.
 * @param to         Hz; > 0, other than `from`.
 * @param options    NULL: the defaults.
 * @param curve      also set where the status is MICROSLIP_NOT_CONVERGED. */
MICROSLIP_API microslip_status microslip_frf(const microslip_structure *structure, const char *point,
                                             microslip_kept kept, double value, double from,
                                             double to, const microslip_frf_options *options,
                                             microslip_curve **curve);

/** The vibrations in phase resonance (lag π/2) over the response: frequency and damping over
 * amplitude.
 * @param structure  any.
 * @param point      as of microslip_frf().
 * @param mode       of the stuck structure, from 0.
 * @param count      ≥ 1.
 * @param response   > 0, rising; in the unit of options->response.
 * @param options    NULL: the defaults.
 * @param curve      also set where the status is MICROSLIP_NOT_CONVERGED. */
MICROSLIP_API microslip_status microslip_backbone(const microslip_structure *structure,
                                                  const char *point, size_t mode, size_t count,
                                                  const double *response,
                                                  const microslip_frf_options *options,
                                                  microslip_curve **curve);

/** Destroys a curve. @param curve  may be NULL. */
MICROSLIP_API void microslip_curve_destroy(microslip_curve *curve);

/** Columns of a curve, one value per vibration. */
typedef enum microslip_curve_values_of MICROSLIP_INT {
  MICROSLIP_CURVE_FREQUENCY = 0,          /**< Hz */
  MICROSLIP_CURVE_FORCE = 1,              /**< A of the excitations, N (m/s² of a base) */
  MICROSLIP_CURVE_DISPLACEMENT = 2,       /**< |w_1| at the response point, m */
  MICROSLIP_CURVE_REAL = 3,               /**< Re w_1 there, m; the phase of the force is 0 */
  MICROSLIP_CURVE_IMAGINARY = 4,          /**< Im w_1 there, m */
  MICROSLIP_CURVE_PHASE = 5,              /**< lag of w_1 behind the force, rad; in (−π, π] */
  MICROSLIP_CURVE_DAMPING_RATIO = 6,      /**< ζ from the energy lost per cycle, 1 */
  MICROSLIP_CURVE_DISSIPATION = 7,        /**< D of all joints, J per cycle */
  MICROSLIP_CURVE_LINEAR_DISSIPATION = 8, /**< of the structure itself, J per cycle */
  MICROSLIP_CURVE_IMBALANCE = 9           /**< residual of the energy balance, relative, 1 */
} microslip_curve_values_of;

/** A column. @param curve  any. @param what  which. @param values  of it.
 * @param count  how many vibrations; may be NULL. */
MICROSLIP_API microslip_status microslip_curve_values(const microslip_curve *curve,
                                                      microslip_curve_values_of what,
                                                      const double **values, size_t *count);

/** Columns of a joint along a curve. */
typedef enum microslip_curve_joint_of MICROSLIP_INT {
  MICROSLIP_CURVE_JOINT_AMPLITUDE = 0,  /**< half of max u − min u, m */
  MICROSLIP_CURVE_JOINT_DISSIPATION = 1 /**< D, J per cycle */
} microslip_curve_joint_of;

/** A column of a joint. @param curve  any. @param joint  its index. @param what  which.
 * @param values  of it. @param count  how many vibrations; may be NULL. */
MICROSLIP_API microslip_status microslip_curve_joint(const microslip_curve *curve, size_t joint,
                                                     microslip_curve_joint_of what,
                                                     const double **values, size_t *count);

/** A harmonic w_n of the displacement of a point, m: w(t) = Re Σ_n w_n e^{inωt}.
 * @param curve      any.
 * @param point      of the structure.
 * @param harmonic   n, from 0, the mean, to options->harmonics.
 * @param count      as many as the curve has vibrations.
 * @param real       Re w_n, m.
 * @param imaginary  Im w_n, m. */
MICROSLIP_API microslip_status microslip_curve_harmonic(const microslip_curve *curve,
                                                        const char *point, size_t harmonic,
                                                        size_t count, double *real,
                                                        double *imaginary);

/** Which vibrations are peaks. @param curve  any. @param index  of each; belongs to the curve.
 * @param count  how many; may be NULL. */
MICROSLIP_API microslip_status microslip_curve_peaks(const microslip_curve *curve,
                                                     const size_t **index, size_t *count);

/** How it ended. @param curve  any. @param outcome  its struct_size is set by the caller. */
MICROSLIP_API microslip_status microslip_curve_outcome(const microslip_curve *curve,
                                                       microslip_outcome *outcome);

/** A warning. @param curve  any. @param index  below warning_count. @param code  may be NULL.
 * @param text  may be NULL. */
MICROSLIP_API microslip_status microslip_curve_warning(const microslip_curve *curve, size_t index,
                                                       const char **code, const char **text);

/* ---- Marches in time ---------------------------------------------------------------------------- */

/** Options of a march in time. */
typedef struct microslip_march_options {
  size_t struct_size;               /**< of the caller's struct */
  double step;                      /**< longest step, s; 0 (default): by the shortest period */
  size_t every;                     /**< every n-th time is recorded; ≥ 1; 1 */
  double tolerance;                 /**< of the implicit equations, 1; 1e-14 to 1e-4; 1e-8 */
  int max_iterations;               /**< evaluations that one step may take; ≥ 2; 50 */
  double largest_imbalance;         /**< energy imbalance above which it is not converged, 1; 1e-4 */
  int estimate_error;               /**< 1 (default): by a second march of twice the step; 0 */
  double largest_error;             /**< error above which it is not converged, 1; 1e-2 */
  size_t start_modes;               /**< modes with a start: 0 (default), at rest, or all; all where
                                         one of the next two is not NULL */
  const double *start_displacement; /**< q_i at the first time, kg^½ m; NULL: zeros */
  const double *start_velocity;     /**< q̇_i at the first time, kg^½ m/s; NULL: zeros */
  microslip_progress progress;      /**< called with the times done; NULL (default): none */
  void *user;                       /**< handed to it */
} microslip_march_options;

/** Defaults. @param options  to fill. @param struct_size  sizeof(microslip_march_options). */
MICROSLIP_API microslip_status microslip_march_options_defaults(microslip_march_options *options,
                                                                size_t struct_size);

/** Result of a march in time. */
typedef struct microslip_marched microslip_marched;

/** Marches a structure under forces that are linear between the times. The periodic excitations of the
 * structure do not act, its static loads do. The motion of all points and joints is recorded.
 * @param structure   any.
 * @param count       of the times; ≥ 2.
 * @param time        s, rising, even or not.
 * @param load_count  0: free vibration; at most as many as there are points and bases.
 * @param places      names of points (or bases); `load_count` of them, no two the same; NULL with one
 *                    load: that of the first excitation.
 * @param loads       the force at each, N (m/s² of a base); `load_count` arrays of `count` values.
 * @param options     NULL: the defaults.
 * @param marched     also set where the status is MICROSLIP_NOT_CONVERGED, up to the time reached. */
MICROSLIP_API microslip_status microslip_march(const microslip_structure *structure, size_t count,
                                               const double *time, size_t load_count,
                                               const char *const *places,
                                               const double *const *loads,
                                               const microslip_march_options *options,
                                               microslip_marched **marched);

/** Destroys a march. @param marched  may be NULL. */
MICROSLIP_API void microslip_marched_destroy(microslip_marched *marched);

/** Recorded times. @param marched  any. @param time  s; belongs to the march.
 * @param count  how many; may be NULL. */
MICROSLIP_API microslip_status microslip_marched_time(const microslip_marched *marched,
                                                      const double **time, size_t *count);

/** The motion of a point, one value per recorded time.
 * @param marched  any. @param point  its index. @param what  displacement, m, velocity or
 * acceleration. @param values  of it. @param count  how many; may be NULL. */
MICROSLIP_API microslip_status microslip_marched_point(const microslip_marched *marched, size_t point,
                                                       microslip_response what,
                                                       const double **values, size_t *count);

/** Recorded quantities of a joint. */
typedef enum microslip_marched_joint_of MICROSLIP_INT {
  MICROSLIP_MARCHED_JOINT_DISPLACEMENT = 0, /**< u, m */
  MICROSLIP_MARCHED_JOINT_FORCE = 1         /**< F, N */
} microslip_marched_joint_of;

/** The motion of a joint, one value per recorded time.
 * @param marched  any. @param joint  its index. @param what  which. @param values  of it.
 * @param count  how many; may be NULL. */
MICROSLIP_API microslip_status microslip_marched_joint(const microslip_marched *marched, size_t joint,
                                                       microslip_marched_joint_of what,
                                                       const double **values, size_t *count);

/** Numbers of a march; energies in J, up to the last time reached:
 * initial + input = kinetic + elastic + linear + joint stored + joint dissipation + joint linear. */
typedef enum microslip_marched_number MICROSLIP_INT {
  MICROSLIP_MARCHED_REACHED = 0,           /**< last time reached, s */
  MICROSLIP_MARCHED_INITIAL = 1,           /**< of the initial state, J */
  MICROSLIP_MARCHED_INPUT = 2,             /**< work of the forces, J */
  MICROSLIP_MARCHED_KINETIC = 3,           /**< at the end, J */
  MICROSLIP_MARCHED_ELASTIC = 4,           /**< of the structure at the end, J */
  MICROSLIP_MARCHED_LINEAR = 5,            /**< lost by the damping of the modes, J */
  MICROSLIP_MARCHED_JOINT_STORED = 6,      /**< in all joints at the end, J */
  MICROSLIP_MARCHED_JOINT_DISSIPATION = 7, /**< lost by slip in all joints, J */
  MICROSLIP_MARCHED_JOINT_LINEAR = 8,      /**< other losses of all joints, J */
  MICROSLIP_MARCHED_IMBALANCE = 9,         /**< of the two sides, relative, 1 */
  MICROSLIP_MARCHED_ERROR = 10             /**< estimated, relative, 1; NaN where it is not known */
} microslip_marched_number;

/** A number. @param marched  any. @param what  which. @param value  of it. */
MICROSLIP_API microslip_status microslip_marched_value(const microslip_marched *marched,
                                                       microslip_marched_number what, double *value);

/** How it ended. @param marched  any. @param outcome  its struct_size is set by the caller. */
MICROSLIP_API microslip_status microslip_marched_outcome(const microslip_marched *marched,
                                                         microslip_outcome *outcome);

/** A warning. @param marched  any. @param index  below warning_count. @param code  may be NULL.
 * @param text  may be NULL. */
MICROSLIP_API microslip_status microslip_marched_warning(const microslip_marched *marched,
                                                         size_t index, const char **code,
                                                         const char **text);

#ifdef __cplusplus
}
#endif

#endif
