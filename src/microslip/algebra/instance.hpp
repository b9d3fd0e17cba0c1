// SPDX-License-Identifier: MIT
#pragma once

// The headers of this folder stand in for those of Eigen and say with `MICROSLIP_INSTANCE
// template …` which of Eigen's templates are compiled here once. An expression that is handed to
// a decomposition has a type of its own: `.eval()` makes it the matrix that the lists name. All
// else of Eigen works as before and is compiled where it is used.
//
// The word says that the code is elsewhere. The source of a header's name takes that away before
// it includes the header, and so makes the code.
#define MICROSLIP_INSTANCE extern
