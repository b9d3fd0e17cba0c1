// SPDX-License-Identifier: MIT
#include "microslip/documents/exports/fmu_code.hpp"

namespace microslip {
namespace {

/// Types of FMI, the state of an instance, and what its functions have in common.
constexpr std::string_view kFmuTypes = R"(
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Types of FMI 2.0, as in fmi2TypesPlatform.h and fmi2FunctionTypes.h. */
typedef void *fmi2Component;
typedef void *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef const char *fmi2String;
typedef char fmi2Byte;
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated }
    fmi2StatusKind;
typedef struct {
  void (*logger)(void *environment, fmi2String instance, fmi2Status status, fmi2String category,
                 fmi2String message, ...);
  void *(*allocateMemory)(size_t count, size_t size);
  void (*freeMemory)(void *memory);
  void (*stepFinished)(void *environment, fmi2Status status);
  void *componentEnvironment;
} fmi2CallbackFunctions;
typedef struct {
  fmi2Boolean newDiscreteStatesNeeded;
  fmi2Boolean terminateSimulation;
  fmi2Boolean nominalsOfContinuousStatesChanged;
  fmi2Boolean valuesOfContinuousStatesChanged;
  fmi2Boolean nextEventTimeDefined;
  fmi2Real nextEventTime;
} fmi2EventInfo;

#ifdef FMI2_OVERRIDE_FUNCTION_PREFIX
#define FMI(name) name
#else
#define FMI(name) JOINT(name)
#endif
#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORT __attribute__((visibility("default")))
#else
#define EXPORT
#endif

enum { DISPLACEMENT = 1, FORCE = 2 };

/* All that an instance remembers. */
typedef struct {
  JOINT(state) kept;   /* at the end of the last completed step */
  double displacement; /* tried since then */
  double velocity;     /* of the next step of a co-simulation */
  double time;
} joint_values;

typedef struct {
  joint_values now;
  fmi2CallbackFunctions callbacks;
  char *name;
} joint_instance;

static fmi2Status tell(const fmi2CallbackFunctions *callbacks, const char *name, fmi2Status status,
                       const char *message) {
  if (callbacks->logger) {
    callbacks->logger(callbacks->componentEnvironment, name, status, "logStatusError", "%s",
                      message);
  }
  return status;
}

static fmi2Status refuse(const joint_instance *it, fmi2Status status, const char *message) {
  return it ? tell(&it->callbacks, it->name, status, message) : fmi2Error;
}

/* The joint has no variables, states or event indicators of this kind. */
static fmi2Status none_of(fmi2Component component, size_t count) {
  if (component && count == 0) return fmi2OK;
  return refuse(component, fmi2Error, "the joint has two real variables, 1 and 2, and no others");
}

/* Whether the force is a number at a displacement from the last kept state. */
static int has_force(const joint_instance *it, double displacement) {
  JOINT(state) trial;
  return isfinite(displacement) &&
         isfinite(JOINT(force)(&it->now.kept, displacement, &trial, NULL));
}

static double try_force(const joint_instance *it, double *tangent) {
  JOINT(state) trial;
  return JOINT(force)(&it->now.kept, it->now.displacement, &trial, tangent);
}

static fmi2Status set_time(joint_instance *it, double time) {
  if (!it) return fmi2Error;
  if (!isfinite(time)) return refuse(it, fmi2Error, "the time must be finite");
  it->now.time = time;
  return fmi2OK;
}

/* The sliders move to the displacement that was tried. */
static void keep(joint_instance *it) {
  JOINT(force)(&it->now.kept, it->now.displacement, &it->now.kept, NULL);
}
)";

constexpr std::string_view kFmuCommon = R"(
EXPORT const char *FMI(fmi2GetTypesPlatform)(void) { return "default"; }

EXPORT const char *FMI(fmi2GetVersion)(void) { return "2.0"; }

EXPORT fmi2Status FMI(fmi2SetDebugLogging)(fmi2Component component, fmi2Boolean on, size_t n,
                                           const fmi2String categories[]) {
  return component ? fmi2OK : fmi2Error;
}

EXPORT fmi2Component FMI(fmi2Instantiate)(fmi2String name, fmi2Type type, fmi2String guid,
                                          fmi2String resources,
                                          const fmi2CallbackFunctions *callbacks,
                                          fmi2Boolean visible, fmi2Boolean logging) {
  joint_instance *it;
  if (!callbacks || !name || !guid) return NULL;
  if (strcmp(guid, FMU_GUID) != 0) {
    tell(callbacks, name, fmi2Error, "the GUID is not " FMU_GUID ", that of this joint");
    return NULL;
  }
  it = calloc(1, sizeof *it);
  if (!it) return NULL;
  it->name = malloc(strlen(name) + 1);
  if (!it->name) {
    free(it);
    return NULL;
  }
  strcpy(it->name, name);
  it->callbacks = *callbacks;
  return it;
}

EXPORT void FMI(fmi2FreeInstance)(fmi2Component component) {
  joint_instance *it = component;
  if (!it) return;
  free(it->name);
  free(it);
}

EXPORT fmi2Status FMI(fmi2SetupExperiment)(fmi2Component component, fmi2Boolean with_tolerance,
                                           fmi2Real tolerance, fmi2Real start,
                                           fmi2Boolean with_stop, fmi2Real stop) {
  return set_time(component, start);
}

EXPORT fmi2Status FMI(fmi2EnterInitializationMode)(fmi2Component component) {
  return component ? fmi2OK : fmi2Error;
}

EXPORT fmi2Status FMI(fmi2ExitInitializationMode)(fmi2Component component) {
  if (!component) return fmi2Error;
  keep(component);
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2Terminate)(fmi2Component component) {
  return component ? fmi2OK : fmi2Error;
}

EXPORT fmi2Status FMI(fmi2Reset)(fmi2Component component) {
  if (!component) return fmi2Error;
  memset(&((joint_instance *)component)->now, 0, sizeof(joint_values));
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2GetReal)(fmi2Component component, const fmi2ValueReference vr[],
                                   size_t n, fmi2Real value[]) {
  const joint_instance *it = component;
  size_t i;
  if (!it) return fmi2Error;
  for (i = 0; i < n; ++i) {
    if (vr[i] != DISPLACEMENT && vr[i] != FORCE) return none_of(component, n);
    value[i] = vr[i] == FORCE ? try_force(it, NULL) : it->now.displacement;
  }
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2SetReal)(fmi2Component component, const fmi2ValueReference vr[],
                                   size_t n, const fmi2Real value[]) {
  joint_instance *it = component;
  size_t i;
  if (!it) return fmi2Error;
  for (i = 0; i < n; ++i) {
    if (vr[i] != DISPLACEMENT) return refuse(it, fmi2Error, "the displacement alone can be set");
    if (!has_force(it, value[i])) {
      return refuse(it, fmi2Discard, "the displacement and its force must be finite");
    }
  }
  if (n > 0) it->now.displacement = value[n - 1];
  return fmi2OK;
}

#define NO_VARIABLES(Kind)                                                                       \
  EXPORT fmi2Status FMI(fmi2Get##Kind)(fmi2Component component, const fmi2ValueReference vr[],  \
                                       size_t n, fmi2##Kind value[]) {                          \
    return none_of(component, n);                                                               \
  }                                                                                             \
  EXPORT fmi2Status FMI(fmi2Set##Kind)(fmi2Component component, const fmi2ValueReference vr[],  \
                                       size_t n, const fmi2##Kind value[]) {                    \
    return none_of(component, n);                                                               \
  }
NO_VARIABLES(Integer)
NO_VARIABLES(Boolean)
NO_VARIABLES(String)

/* The slope of the force for a step from the last kept state through the present displacement. */
EXPORT fmi2Status FMI(fmi2GetDirectionalDerivative)(
    fmi2Component component, const fmi2ValueReference unknown[], size_t unknowns,
    const fmi2ValueReference known[], size_t knowns, const fmi2Real change[],
    fmi2Real result[]) {
  double slope, sum = 0.0;
  size_t i;
  if (!component) return fmi2Error;
  try_force(component, &slope);
  for (i = 0; i < knowns; ++i) {
    if (known[i] != DISPLACEMENT) {
      return refuse(component, fmi2Error, "only derivatives by the displacement are known");
    }
    sum += slope * change[i];
  }
  if (!isfinite(sum)) return refuse(component, fmi2Discard, "the derivative must be finite");
  for (i = 0; i < unknowns; ++i) {
    if (unknown[i] != FORCE) {
      return refuse(component, fmi2Error, "only derivatives of the force are known");
    }
    result[i] = sum;
  }
  return fmi2OK;
}
)";

constexpr std::string_view kFmuStates = R"(
EXPORT fmi2Status FMI(fmi2GetFMUstate)(fmi2Component component, fmi2FMUstate *state) {
  if (!component || !state) return fmi2Error;
  if (!*state) *state = malloc(sizeof(joint_values));
  if (!*state) return refuse(component, fmi2Error, "out of memory");
  memcpy(*state, &((joint_instance *)component)->now, sizeof(joint_values));
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2SetFMUstate)(fmi2Component component, fmi2FMUstate state) {
  if (!component || !state) return fmi2Error;
  memcpy(&((joint_instance *)component)->now, state, sizeof(joint_values));
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2FreeFMUstate)(fmi2Component component, fmi2FMUstate *state) {
  if (!component) return fmi2Error;
  if (!state) return fmi2OK;
  free(*state);
  *state = NULL;
  return fmi2OK;
}

/* Whether all is finite, the force too. */
static int is_state(const joint_instance *it) {
  size_t i;
  for (i = 0; i < JOINT(SIZE); ++i) {
    if (!isfinite(it->now.kept.position[i])) return 0;
  }
  return isfinite(it->now.velocity) && isfinite(it->now.time) &&
         has_force(it, it->now.displacement);
}

/* A state as bytes: the GUID, then the values. */
EXPORT fmi2Status FMI(fmi2SerializedFMUstateSize)(fmi2Component component, fmi2FMUstate state,
                                                  size_t *size) {
  if (!component || !state) return fmi2Error;
  *size = sizeof FMU_GUID + sizeof(joint_values);
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2SerializeFMUstate)(fmi2Component component, fmi2FMUstate state,
                                             fmi2Byte bytes[], size_t size) {
  if (!component || !state || size < sizeof FMU_GUID + sizeof(joint_values)) return fmi2Error;
  memcpy(bytes, FMU_GUID, sizeof FMU_GUID);
  memcpy(bytes + sizeof FMU_GUID, state, sizeof(joint_values));
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2DeSerializeFMUstate)(fmi2Component component, const fmi2Byte bytes[],
                                               size_t size, fmi2FMUstate *state) {
  joint_instance read;
  if (!component || !state) return fmi2Error;
  if (size < sizeof FMU_GUID + sizeof(joint_values) ||
      memcmp(bytes, FMU_GUID, sizeof FMU_GUID) != 0) {
    return refuse(component, fmi2Error, "the state is not of this joint");
  }
  memcpy(&read.now, bytes + sizeof FMU_GUID, sizeof(joint_values));
  if (!is_state(&read)) return refuse(component, fmi2Error, "the state must be finite");
  if (!*state) *state = malloc(sizeof(joint_values));
  if (!*state) return refuse(component, fmi2Error, "out of memory");
  memcpy(*state, &read.now, sizeof(joint_values));
  return fmi2OK;
}
)";

constexpr std::string_view kFmuModelExchange = R"(
/* ---- Model exchange: neither continuous states nor event indicators. ---- */

EXPORT fmi2Status FMI(fmi2EnterEventMode)(fmi2Component component) {
  return component ? fmi2OK : fmi2Error;
}

EXPORT fmi2Status FMI(fmi2NewDiscreteStates)(fmi2Component component, fmi2EventInfo *info) {
  if (!component) return fmi2Error;
  keep(component);
  memset(info, 0, sizeof *info);
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2EnterContinuousTimeMode)(fmi2Component component) {
  return component ? fmi2OK : fmi2Error;
}

EXPORT fmi2Status FMI(fmi2CompletedIntegratorStep)(fmi2Component component, fmi2Boolean no_return,
                                                   fmi2Boolean *event, fmi2Boolean *terminate) {
  if (!component) return fmi2Error;
  keep(component);
  *event = 0;
  *terminate = 0;
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2SetTime)(fmi2Component component, fmi2Real time) {
  return set_time(component, time);
}

EXPORT fmi2Status FMI(fmi2SetContinuousStates)(fmi2Component component, const fmi2Real x[],
                                               size_t n) {
  return none_of(component, n);
}

#define NO_STATES(name)                                                         \
  EXPORT fmi2Status FMI(name)(fmi2Component component, fmi2Real x[], size_t n) { \
    return none_of(component, n);                                               \
  }
NO_STATES(fmi2GetDerivatives)
NO_STATES(fmi2GetEventIndicators)
NO_STATES(fmi2GetContinuousStates)
NO_STATES(fmi2GetNominalsOfContinuousStates)
)";

constexpr std::string_view kFmuCoSimulation = R"(
/* ---- Co-simulation: the displacement moves in a straight line in each step. ---- */

EXPORT fmi2Status FMI(fmi2SetRealInputDerivatives)(fmi2Component component,
                                                   const fmi2ValueReference vr[], size_t n,
                                                   const fmi2Integer order[],
                                                   const fmi2Real value[]) {
  joint_instance *it = component;
  size_t i;
  if (!it) return fmi2Error;
  for (i = 0; i < n; ++i) {
    if (vr[i] != DISPLACEMENT || order[i] != 1 || !isfinite(value[i])) {
      return refuse(it, fmi2Error, "only a finite velocity of the displacement can be set");
    }
  }
  if (n > 0) it->now.velocity = value[n - 1];
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2GetRealOutputDerivatives)(fmi2Component component,
                                                    const fmi2ValueReference vr[], size_t n,
                                                    const fmi2Integer order[], fmi2Real value[]) {
  return none_of(component, n);
}

/* From the displacement that was set, by the velocity that was set for this step, if any. Nothing
   moves in a step that is refused. */
EXPORT fmi2Status FMI(fmi2DoStep)(fmi2Component component, fmi2Real time, fmi2Real step,
                                  fmi2Boolean no_return) {
  joint_instance *it = component;
  joint_values before;
  if (!it) return fmi2Error;
  if (!isfinite(time) || !isfinite(time + step) || !(step >= 0.0)) {
    return refuse(it, fmi2Error, "the time must be finite and the step 0 or more");
  }
  before = it->now;
  keep(it);
  if (it->now.velocity != 0.0) {
    const double displacement = it->now.displacement + it->now.velocity * step;
    if (!has_force(it, displacement)) {
      it->now = before;
      return refuse(it, fmi2Discard, "the displacement and its force must be finite");
    }
    it->now.displacement = displacement;
    it->now.velocity = 0.0;
    keep(it);
  }
  it->now.time = time + step;
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2CancelStep)(fmi2Component component) {
  return refuse(component, fmi2Error, "no step is pending: steps end before they return");
}

EXPORT fmi2Status FMI(fmi2GetRealStatus)(fmi2Component component, const fmi2StatusKind kind,
                                         fmi2Real *value) {
  if (!component) return fmi2Error;
  if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
  *value = ((joint_instance *)component)->now.time;
  return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2GetBooleanStatus)(fmi2Component component, const fmi2StatusKind kind,
                                            fmi2Boolean *value) {
  if (!component) return fmi2Error;
  if (kind != fmi2Terminated) return fmi2Discard;
  *value = 0;
  return fmi2OK;
}

#define NO_STATUS(Kind, type)                                                                    \
  EXPORT fmi2Status FMI(fmi2Get##Kind)(fmi2Component component, const fmi2StatusKind kind,       \
                                       type *value) {                                            \
    return component ? fmi2Discard : fmi2Error;                                                  \
  }
NO_STATUS(Status, fmi2Status)
NO_STATUS(IntegerStatus, fmi2Integer)
NO_STATUS(StringStatus, fmi2String)
)";

}  // namespace

std::string_view fmu_code() {
  static const std::string kAll = std::string(kFmuTypes)
                                      .append(kFmuCommon)
                                      .append(kFmuStates)
                                      .append(kFmuModelExchange)
                                      .append(kFmuCoSimulation);
  return kAll;
}

}  // namespace microslip
