// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/documents/exports/comment_lines.hpp"
#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {
namespace {

/// A double of Fortran, all digits.
std::string fortran_number(double value) {
  std::string text = fmt::format("{:.16e}", value);
  text[text.find('e')] = 'D';
  return text;
}

/// Statements that fill a table with one number of each slider, in lines of 72 columns.
std::string data_of(const ExportedJoint& joint, std::string_view table,
                    double ExportedSlider::*number, std::size_t padded) {
  std::string text;
  for (std::size_t i = 0; i < padded; i += 2) {
    const auto value = [&](std::size_t j) {
      return fortran_number(j < joint.sliders.size() ? joint.sliders[j].*number : 0.0);
    };
    text += fmt::format("      DATA {0}({1}), {0}({2})\n     1 /{3}, {4}/\n", table, i + 1, i + 2,
                        value(i), value(i + 1));
  }
  return text;
}

constexpr const char* kUseOfElement =
    R"(! In the input file; the number in the second line is the degree of freedom, 1, 2 or 3:
!   *USER ELEMENT, TYPE=U{1}, NODES=2, COORDINATES=3, VARIABLES={2}
!   1
!   *ELEMENT, TYPE=U{1}, ELSET={0}
!   1, NODE_A, NODE_B
!   *UEL PROPERTY, ELSET={0}
! The joint is stretched where NODE_B moves ahead of NODE_A. With several such files keep one UEL,
! which calls the subroutine of each JTYPE. Compile it without contraction of products and sums
! (-ffp-contract=off) for the last digits.
)";

/// The force, and the element on it. [Abaqus User Subroutines Reference Guide, 1.1.28 UEL]
constexpr const char* kElement = R"(
! The force, {5}, after a step from the positions of the sliders, {6}, in
! FROM to the displacement X. TO may be FROM. WORK: stored, dissipated.
      SUBROUTINE {0}_FORCE(
     1 FROM, X, TO, FORCE, SLOPE, WORK)
      IMPLICIT NONE
      INTEGER I, J
      DOUBLE PRECISION FROM({1}), TO({1}), X, FORCE, SLOPE, WORK(2)
      DOUBLE PRECISION STIFF({1}), SLIP({1}), LANES({2}), Z
      SAVE STIFF, SLIP
{3}{4}      DO J = 1, {2}
        LANES(J) = 0D0
      END DO
      SLOPE = {7}
      WORK(1) = 0.5D0*SLOPE*X*X
      WORK(2) = 0D0
      DO I = 1, {1}
        Z = FROM(I)
        IF (Z .LT. X - SLIP(I)) THEN
          Z = X - SLIP(I)
        ELSE IF (Z .GT. X + SLIP(I)) THEN
          Z = X + SLIP(I)
        ELSE
          SLOPE = SLOPE + STIFF(I)
        END IF
        WORK(1) = WORK(1) + 0.5D0*STIFF(I)*(X - Z)**2
        WORK(2) = WORK(2) + STIFF(I)*SLIP(I)*ABS(Z - FROM(I))
        TO(I) = Z
        J = MOD(I - 1, {2}) + 1
        LANES(J) = LANES(J) + STIFF(I)*(X - Z)
      END DO
      FORCE = (((LANES(1) + LANES(5)) + (LANES(3) + LANES(7))) +
     1 ((LANES(2) + LANES(6)) + (LANES(4) + LANES(8)))) +
     2 {7}*X
      END

! SVARS: the positions, then the force at the start of the increment and
! at that of the one before it, which implicit dynamics need (PARAMS(1) is
! alpha of the time integration).
      SUBROUTINE {0}_ELEMENT(
     1 RHS, AMATRX, SVARS, ENERGY, NDOFEL, NRHS, U, DU, LFLAGS, MLVARX,
     2 PARAMS)
      IMPLICIT NONE
      INTEGER NDOFEL, NRHS, MLVARX, LFLAGS(*), I, J, SIGNS(2)
      DOUBLE PRECISION RHS(MLVARX,*), AMATRX(NDOFEL,NDOFEL), SVARS(*)
      DOUBLE PRECISION ENERGY(8), U(NDOFEL), DU(MLVARX,*), PARAMS(*)
      DOUBLE PRECISION TO({1}), FORCE, SLOPE, WORK(2), ALPHA
      DATA SIGNS /-1, 1/
      DO I = 1, NDOFEL
        DO J = 1, NRHS
          RHS(I,J) = 0D0
        END DO
        DO J = 1, NDOFEL
          AMATRX(I,J) = 0D0
        END DO
      END DO
      IF (LFLAGS(3) .EQ. 3 .OR. LFLAGS(3) .EQ. 4) RETURN
      CALL {0}_FORCE(
     1 SVARS, U(2) - U(1), TO, FORCE, SLOPE, WORK)
      ALPHA = 0D0
      IF (LFLAGS(1) .EQ. 11 .OR. LFLAGS(1) .EQ. 12) ALPHA = PARAMS(1)
      IF (LFLAGS(3) .EQ. 1 .OR. LFLAGS(3) .EQ. 2) THEN
        DO I = 1, 2
          DO J = 1, 2
            AMATRX(I,J) = SIGNS(I)*SIGNS(J)*(1D0 + ALPHA)*SLOPE
          END DO
        END DO
      END IF
! A linear perturbation: the stiffness, and the force of the
! perturbation where output asks for it; all stays as it is.
      IF (LFLAGS(4) .NE. 0) THEN
        IF (LFLAGS(3) .EQ. 100) THEN
          DO I = 1, 2
            RHS(I,1) = -SIGNS(I)*SLOPE*(DU(2,1) - DU(1,1))
          END DO
        END IF
        RETURN
      END IF
      IF (LFLAGS(3) .EQ. 5) THEN
        DO I = 1, 2
          RHS(I,1) = -SIGNS(I)*((1D0 + ALPHA)*FORCE -
     1     0.5D0*ALPHA*(SVARS({1}+1) + SVARS({1}+2)))
        END DO
      ELSE IF (LFLAGS(3) .EQ. 1 .OR. LFLAGS(3) .EQ. 6) THEN
        IF (LFLAGS(3) .EQ. 6) ALPHA = 0D0
        DO I = 1, 2
          RHS(I,1) = -SIGNS(I)*((1D0 + ALPHA)*FORCE -
     1     ALPHA*SVARS({1}+1))
        END DO
        DO I = 1, {1}
          SVARS(I) = TO(I)
        END DO
        SVARS({1}+2) = SVARS({1}+1)
        SVARS({1}+1) = FORCE
        ENERGY(2) = WORK(1)
        ENERGY(4) = ENERGY(4) + WORK(2)
      END IF
      END

      SUBROUTINE UEL(RHS, AMATRX, SVARS, ENERGY, NDOFEL, NRHS, NSVARS,
     1 PROPS, NPROPS, COORDS, MCRD, NNODE, U, DU, V, A, JTYPE, TIME,
     2 DTIME, KSTEP, KINC, JELEM, PARAMS, NDLOAD, JDLTYP, ADLMAG,
     3 PREDEF, NPREDF, LFLAGS, MLVARX, DDLMAG, MDLOAD, PNEWDT, JPROPS,
     4 NJPROP, PERIOD)
      INCLUDE 'ABA_PARAM.INC'
      DIMENSION RHS(MLVARX,*), AMATRX(NDOFEL,NDOFEL), PROPS(*),
     1 SVARS(*), ENERGY(8), COORDS(MCRD,NNODE), U(NDOFEL),
     2 DU(MLVARX,*), V(NDOFEL), A(NDOFEL), TIME(2), PARAMS(*),
     3 JDLTYP(MDLOAD,*), ADLMAG(MDLOAD,*), DDLMAG(MDLOAD,*),
     4 PREDEF(2,NPREDF,NNODE), LFLAGS(*), JPROPS(*)
      CALL {0}_ELEMENT(
     1 RHS, AMATRX, SVARS, ENERGY, NDOFEL, NRHS, U, DU, LFLAGS, MLVARX,
     2 PARAMS)
      END
)";

}  // namespace

std::string abaqus_element(const ExportedJoint& joint) {
  const std::size_t padded = padded_sliders(joint);
  constexpr std::size_t kForces = 2;
  return comment_lines(joint, "! ", "abaqus-uel") +
         fmt::format(fmt::runtime(kUseOfElement), joint.name, joint.first_number,
                     padded + kForces) +
         fmt::format(fmt::runtime(kElement), joint.name, padded, kExportedLanes,
                     data_of(joint, "STIFF", &ExportedSlider::stiffness, padded),
                     data_of(joint, "SLIP", &ExportedSlider::slip_displacement, padded),
                     joint.units.force, joint.units.length, fortran_number(joint.spring));
}

}  // namespace microslip
