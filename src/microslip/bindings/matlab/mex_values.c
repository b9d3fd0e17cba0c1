/* SPDX-License-Identifier: MIT */
#include "mex_values.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#ifdef MICROSLIP_FOR_OCTAVE
#include <pthread.h>
#include <signal.h>
#endif

/* Of each joint of a model one, and a few more. */
typedef struct kept {
  mx_kind kind;
  void* handle;
} kept;

static kept* list = NULL;
static size_t list_size = 0;
static size_t list_room = 0;

static void destroy(kept what) {
  switch (what.kind) {
    case MX_JOINT:
      microslip_joint_destroy((microslip_joint*)what.handle);
      break;
    case MX_MEMORY:
      microslip_memory_destroy((microslip_memory*)what.handle);
      break;
    case MX_LEVELS:
      microslip_levels_destroy((microslip_levels*)what.handle);
      break;
    case MX_IDENTIFICATION:
      microslip_identification_destroy((microslip_identification*)what.handle);
      break;
    case MX_MODEL:
      microslip_model_destroy((microslip_model*)what.handle);
      break;
    case MX_STRUCTURE:
      microslip_structure_destroy((microslip_structure*)what.handle);
      break;
    case MX_CURVE:
      microslip_curve_destroy((microslip_curve*)what.handle);
      break;
    case MX_MARCHED:
      microslip_marched_destroy((microslip_marched*)what.handle);
      break;
  }
}

void mx_keep(mx_kind kind, void* handle) {
  if (list_size == list_room) {
    list_room = 2 * list_room + 8;
    list = (kept*)mxRealloc(list, list_room * sizeof(kept));
    mexMakeMemoryPersistent(list);
  }
  list[list_size].kind = kind;
  list[list_size].handle = handle;
  ++list_size;
}

void mx_release_all(void) {
  while (list_size > 0) destroy(list[--list_size]);
}

void mx_fail(const char* id, const char* format, ...) {
  static char text[4096]; /* it outlives the jump */
  char full_id[64];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  snprintf(full_id, sizeof full_id, "microslip:%s", id);
  mx_end_listening();
  mx_release_all();
  mexErrMsgIdAndTxt(full_id, "%s", text);
}

/* "options->gain_std = ..." as the options are called here: "GainStd = ...". */
static const char* as_called_here(const char* text) {
  static const char before[] = "options->";
  static char changed[4096];
  const size_t skip = sizeof before - 1;
  size_t n = 0;
  size_t i;
  int capital = 1;
  if (strncmp(text, before, skip) != 0) return text;
  for (i = skip; text[i] != '\0' && text[i] != ' ' && n + 1 < sizeof changed; ++i) {
    if (text[i] == '_') {
      capital = 1;
      continue;
    }
    changed[n++] = (char)(capital ? toupper((unsigned char)text[i]) : text[i]);
    capital = 0;
  }
  snprintf(changed + n, sizeof changed - n, "%s", text + i);
  return changed;
}

void mx_must(microslip_status status) {
  static const char* const ids[] = {"", "input",     "format", "file",
                                    "", "cancelled", "memory", "internal"};
  if (status == MICROSLIP_OK || status == MICROSLIP_NOT_CONVERGED) return;
  mx_fail(ids[status], "%s", as_called_here(microslip_last_error()));
}

void mx_require(int holds, const char* name, const char* rule) {
  if (!holds) mx_fail("input", "%s must %s", name, rule);
}

const double* mx_numbers(const mxArray* array, const char* name, size_t* count) {
  mx_require(mxIsDouble(array) && !mxIsComplex(array) && !mxIsSparse(array), name,
             "be real numbers of class double, in a full array");
  *count = mxGetNumberOfElements(array);
  return mxGetPr(array);
}

const double* mx_numbers_of(const mxArray* array, const char* name, size_t wanted) {
  size_t count;
  const double* values = mx_numbers(array, name, &count);
  if (count != wanted) {
    mx_fail("input", "%s = %lu values; must have %lu", name, (unsigned long)count,
            (unsigned long)wanted);
  }
  return values;
}

double mx_number(const mxArray* array, const char* name) {
  mx_require((mxIsDouble(array) || mxIsLogical(array)) && !mxIsComplex(array) &&
                 mxGetNumberOfElements(array) == 1,
             name, "be one real number");
  return mxGetScalar(array);
}

size_t mx_whole(const mxArray* array, const char* name) {
  const double value = mx_number(array, name);
  if (!(value >= 0.0 && value <= 9007199254740992.0 && value == floor(value))) {
    mx_fail("input", "%s = %g; must be a whole number, 0 or more", name, value);
  }
  return (size_t)value;
}

int mx_is_text(const mxArray* array) { return mxIsChar(array) && mxGetM(array) <= 1; }

char* mx_text(const mxArray* array, const char* name) {
  mx_require(mx_is_text(array), name, "be text, one row of characters");
  return mxArrayToString(array);
}

void mx_struct(const mxArray* array, const char* name, const char* const* known) {
  int i;
  mx_require(mxIsStruct(array) && mxGetNumberOfElements(array) == 1, name, "be one struct");
  for (i = 0; i < mxGetNumberOfFields(array); ++i) {
    const char* field = mxGetFieldNameByNumber(array, i);
    const char* const* one = known;
    while (*one != NULL && strcmp(*one, field) != 0) ++one;
    if (*one == NULL)
      mx_fail("input", "%s.%s is unknown; must be one of the fields in the help", name,
              field);
  }
}

const mxArray* mx_optional(const mxArray* array, const char* field) {
  const mxArray* value = mxGetField(array, 0, field);
  return value == NULL || mxIsEmpty(value) ? NULL : value;
}

const mxArray* mx_needed(const mxArray* array, const char* field, const char* name) {
  const mxArray* value = mxGetField(array, 0, field);
  if (value == NULL) mx_fail("input", "%s.%s is missing; must be given", name, field);
  return value;
}

char* mx_name(const char* name, const char* field) {
  const size_t room = strlen(name) + strlen(field) + 2;
  char* full = (char*)mxMalloc(room);
  snprintf(full, room, "%s.%s", name, field);
  return full;
}

char* mx_item_name(const char* name, size_t index) {
  const size_t room = strlen(name) + 32;
  char* full = (char*)mxMalloc(room);
  snprintf(full, room, "%s(%lu)", name, (unsigned long)index + 1);
  return full;
}

size_t mx_count_of(const mxArray* array, const char* name) {
  size_t i;
  if (array == NULL) return 0;
  mx_require(mxIsStruct(array) || mxIsCell(array), name,
             "be structs, in an array or in a cell array");
  for (i = 0; mxIsCell(array) && i < mxGetNumberOfElements(array); ++i) {
    const mxArray* item = mxGetCell(array, i);
    mx_require(item != NULL && mxIsStruct(item) && mxGetNumberOfElements(item) == 1,
               mx_item_name(name, i), "be one struct");
  }
  return mxGetNumberOfElements(array);
}

const mxArray* mx_item(const mxArray* array, size_t index) {
  mxArray* item;
  int i;
  if (mxIsCell(array)) return mxGetCell(array, index);
  item = mxCreateStructMatrix(1, 1, 0, NULL);
  for (i = 0; i < mxGetNumberOfFields(array); ++i) {
    const char* field = mxGetFieldNameByNumber(array, i);
    const mxArray* value = mxGetField(array, index, field);
    mxAddField(item, field);
    if (value != NULL) mxSetField(item, 0, field, mxDuplicateArray(value));
  }
  return item;
}

mxArray* mx_column(const double* values, size_t count) {
  mxArray* column = mxCreateDoubleMatrix(count, count > 0 ? 1 : 0, mxREAL);
  if (count > 0) memcpy(mxGetPr(column), values, count * sizeof(double));
  return column;
}

mxArray* mx_new_struct(void) { return mxCreateStructMatrix(1, 1, 0, NULL); }

void mx_set(mxArray* structure, const char* field, mxArray* value) {
  mxAddField(structure, field);
  mxSetField(structure, 0, field, value);
}

void mx_set_number(mxArray* structure, const char* field, double value) {
  mx_set(structure, field, mxCreateDoubleScalar(value));
}

void mx_set_text(mxArray* structure, const char* field, const char* text) {
  mx_set(structure, field, mxCreateString(text));
}

void mx_set_ending(mxArray* structure, const microslip_outcome* outcome, const void* result,
                   mx_warning_of warning_of) {
  static const char* fields[] = {"code", "text"};
  const size_t count = outcome->warning_count;
  mxArray* const warnings = mxCreateStructMatrix(count, count > 0 ? 1 : 0, 2, fields);
  size_t i;
  mx_set(structure, "converged", mxCreateLogicalScalar(outcome->converged != 0));
  mx_set_text(structure, "reason", outcome->reason);
  mx_set_text(structure, "summary", outcome->summary);
  for (i = 0; i < count; ++i) {
    const char* code;
    const char* text;
    mx_must(warning_of(result, i, &code, &text));
    mxSetField(warnings, i, "code", mxCreateString(code));
    mxSetField(warnings, i, "text", mxCreateString(text));
  }
  mx_set(structure, "warnings", warnings);
}

#ifdef MICROSLIP_FOR_OCTAVE
/* Of Octave's quit.h, which is C++: a thread of its own waits for signals and says that there was
 * one; what it was the interpreter finds out, in its thread alone, when it asks. */
extern volatile sig_atomic_t octave_signal_caught;
extern sig_atomic_t octave_interrupt_state;
extern void (*octave_signal_hook)(void);

static pthread_t interpreter;

void mx_begin_listening(void) { interpreter = pthread_self(); }

/* The interrupt has done its work: the call ends with an error. */
void mx_end_listening(void) {
  if (octave_interrupt_state > 0) octave_interrupt_state = 0;
}

int mx_go_on(size_t done, size_t total, void* user) {
  (void)done;
  (void)total;
  (void)user;
  if (octave_signal_caught && pthread_equal(pthread_self(), interpreter)) {
    octave_signal_caught = 0;
    if (octave_signal_hook != NULL) octave_signal_hook();
  }
  return octave_interrupt_state <= 0;
}
#else
/* MATLAB keeps interrupts to itself while a MEX file runs. */
void mx_begin_listening(void) {}
void mx_end_listening(void) {}

int mx_go_on(size_t done, size_t total, void* user) {
  (void)done;
  (void)total;
  (void)user;
  return 1;
}
#endif
