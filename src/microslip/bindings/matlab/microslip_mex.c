/* SPDX-License-Identifier: MIT */
/* The one MEX file of the package +microslip: microslip_mex('COMMAND', ...), for its functions
 * alone. It is C over microslip.h and compiles for MATLAB and Octave alike. */
#include <string.h>

#include "mex_commands.h"

typedef struct command {
  const char* name;
  int arguments;
  mxArray* (*run)(const mxArray** arguments);
} command;

static const command commands[] = {
    {"version", 0, mex_version},       {"joint", 2, mex_joint},
    {"read_joint", 1, mex_read_joint}, {"write_joint", 2, mex_write_joint},
    {"force", 2, mex_force},           {"curve_of_joint", 3, mex_curve_of_joint},
    {"identify", 2, mex_identify},     {"frf", 2, mex_frf},
    {"backbone", 3, mex_backbone},     {"march", 4, mex_march},
};

mxArray* mex_version(const mxArray** arguments) {
  (void)arguments;
  return mxCreateString(microslip_version());
}

void mexFunction(int result_count, mxArray* results[], int argument_count,
                 const mxArray* arguments[]) {
  size_t i;
  char* name;
  mx_release_all(); /* of a call that was left by a jump of MATLAB's own */
  mx_require(argument_count > 0, "command", "be given");
  name = mx_text(arguments[0], "command");
  for (i = 0; i < sizeof commands / sizeof commands[0]; ++i) {
    mxArray* result;
    if (strcmp(name, commands[i].name) != 0) continue;
    mx_require(argument_count == commands[i].arguments + 1, name,
               "have as many arguments as its function gives");
    result = commands[i].run(arguments + 1);
    mx_end_listening();
    mx_release_all();
    if (result == NULL) return;
    if (result_count <= 1) results[0] = result;
    return;
  }
  mx_fail("internal", "no command '%s'", name);
}
