/* SPDX-License-Identifier: MIT */
#ifndef MICROSLIP_MEX_COMMANDS_H
#define MICROSLIP_MEX_COMMANDS_H

#include "mex_values.h"

/* The commands of microslip_mex('NAME', ...), with as many arguments as the row there says. */
mxArray* mex_version(const mxArray** arguments);
mxArray* mex_joint(const mxArray** arguments);
mxArray* mex_read_joint(const mxArray** arguments);
mxArray* mex_write_joint(const mxArray** arguments);
mxArray* mex_force(const mxArray** arguments);
mxArray* mex_curve_of_joint(const mxArray** arguments);
mxArray* mex_identify(const mxArray** arguments);
mxArray* mex_frf(const mxArray** arguments);
mxArray* mex_backbone(const mxArray** arguments);
mxArray* mex_march(const mxArray** arguments);

/* A joint of its struct; with its record where that still belongs to it. */
microslip_joint* mx_joint_of(const mxArray* structure, const char* name);
/* The struct of a joint, with the text of its file as field json where `with_text`. */
mxArray* mx_joint_struct(const microslip_joint* joint, int with_text);
/* A structure of the path of a model.toml, or of a struct as that. */
microslip_structure* mx_structure_of(const mxArray* model);

#endif
