// SPDX-License-Identifier: MIT
#pragma once

// The headers of this folder replace those of Eigen and declare with `MICROSLIP_INSTANCE template
// …` which of Eigen's templates are compiled here once. An expression that is passed to a
// decomposition has a type of its own: `.eval()` makes it the matrix that the lists name. All else
// of Eigen works as before and is compiled where it is used.
//
// The macro declares that the code is elsewhere. The source of a header's name removes it before it
// includes the header, and so instantiates the code.
#define MICROSLIP_INSTANCE extern
