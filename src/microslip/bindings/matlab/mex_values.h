/* SPDX-License-Identifier: MIT */
#ifndef MICROSLIP_MEX_VALUES_H
#define MICROSLIP_MEX_VALUES_H

#include <mex.h>
#include <microslip.h>

/* Between values of MATLAB and those of microslip.h. An error of MATLAB leaves a function by a
 * jump, so that what has to be destroyed is kept in a list, and goes with it. */

typedef enum mx_kind {
  MX_JOINT,
  MX_MEMORY,
  MX_LEVELS,
  MX_IDENTIFICATION,
  MX_MODEL,
  MX_STRUCTURE,
  MX_CURVE,
  MX_MARCHED
} mx_kind;

/* Destroyed by mx_release_all(), which each call ends with, by an error too. */
void mx_keep(mx_kind kind, void* handle);
void mx_release_all(void);

/* Ends the call with error('microslip:ID', ...). */
void mx_fail(const char* id, const char* format, ...);

/* Ends the call unless the status is one with a result. */
void mx_must(microslip_status status);

/* Ends the call with microslip:input unless `holds`: "NAME must ...". */
void mx_require(int holds, const char* name, const char* rule);

/* Real doubles; they belong to the array. */
const double* mx_numbers(const mxArray* array, const char* name, size_t* count);
/* As many of them as wanted. */
const double* mx_numbers_of(const mxArray* array, const char* name, size_t wanted);
double mx_number(const mxArray* array, const char* name);
size_t mx_whole(const mxArray* array, const char* name);
/* Text, which MATLAB frees after the call. */
char* mx_text(const mxArray* array, const char* name);
int mx_is_text(const mxArray* array);

/* A struct of one; fields that are not in the list, which ends with NULL, are an error. */
void mx_struct(const mxArray* array, const char* name, const char* const* known);
/* A field; NULL where it is missing or []. */
const mxArray* mx_optional(const mxArray* array, const char* field);
const mxArray* mx_needed(const mxArray* array, const char* field, const char* name);
/* The name of a field for messages, "NAME.FIELD", which MATLAB frees. */
char* mx_name(const char* name, const char* field);
char* mx_item_name(const char* name, size_t index);

/* Items of a struct array, or of a cell array of structs; each is a struct of one. 0 of NULL. */
size_t mx_count_of(const mxArray* array, const char* name);
const mxArray* mx_item(const mxArray* array, size_t index);

mxArray* mx_column(const double* values, size_t count);
void mx_set(mxArray* structure, const char* field, mxArray* value);
void mx_set_number(mxArray* structure, const char* field, double value);
void mx_set_text(mxArray* structure, const char* field, const char* text);
mxArray* mx_new_struct(void);

/* converged, reason, summary, and warnings, each of which `warning_of` gives of a result. */
typedef microslip_status (*mx_warning_of)(const void* result, size_t index, const char** code,
                                          const char** text);
void mx_set_ending(mxArray* structure, const microslip_outcome* outcome, const void* result,
                   mx_warning_of warning_of);

/* Ctrl-C while a function of microslip runs, in Octave: the progress says stop. */
void mx_begin_listening(void);
void mx_end_listening(void);
int mx_go_on(size_t done, size_t total, void* user);

#endif
