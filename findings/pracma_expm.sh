#!/usr/bin/env bash
# R 4.2.2 (r-base-core 4.2.2.20221110-2) with pracma 2.4.2 (r-cran-pracma 2.4.2-1): expm(A * dt) of the state matrix of
#   one mode with a damping ratio of 1 %, in displacement and velocity, for a tenth of its period.
#
# Guess: right to 1e-10 at any frequency, as an exponential scales with its states. The norm of A * dt is 400 at 100 Hz,
#   but its eigenvalues are 0.63.
# Instead: the steps give back a damping ratio of 1.9 % at 100 Hz, of -1.0 % at 500 Hz, which grows, and from 1 kHz on
#   there is no oscillation. The result is rounded to seven digits of its largest entry. In m and m/s entries are apart
#   by the square of the angular frequency, so the flexibility keeps one digit, and none from 1 kHz on. And by a
#   contour of 128 points, a step over eight periods has numbers of 1e6 where none is above 1. No message.
# Why it matters: the exact step of a linear structure between two slips of a joint, and damping by covariances or
#   state spaces, are exponentials and logarithms of this matrix. The damping of the joint is what comes out wrong.
# A way to live with it: Matrix::expm, which comes with R; or angular frequency times displacement for a state, and
#   steps shorter than a period.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian r-base-core=4.2.2.20221110-2 r-cran-pracma=2.4.2-1 r-cran-matrix=1.5-3-1

cat >modes.R <<'END'
damping <- function(step, dt) {
  pole <- log(as.complex(eigen(step)$values[1])) / dt
  -Re(pole) / Mod(pole)
}
for (frequency in c(100, 500, 1000)) {
  omega <- 2 * pi * frequency
  dt <- 0.1 / frequency
  A <- matrix(c(0, -omega^2, 1, -0.02 * omega), 2)
  other <- as.matrix(Matrix::expm(A * dt))
  step <- pracma::expm(A * dt)
  scaled <- pracma::expm(matrix(c(0, -1, 1, -0.02), 2) * omega * dt)
  cat(damping(step, dt), damping(other, dt), damping(scaled, dt), step[1, 2], other[1, 2], "\n")
}
turn <- matrix(c(0, -1, 1, 0), 2) * 2 * pi * 8
cat(max(abs(pracma::expm(turn))), max(abs(as.matrix(Matrix::expm(turn)))), "\n")
END
r modes.R >modes.txt
(($(wc -l <modes.txt) == 4)) || fail "R does not run it: $(cat r.log)"
{
  read -r slow slow_other slow_scaled _
  read -r middle middle_other middle_scaled _
  read -r fast fast_other fast_scaled flexibility flexibility_other
  read -r turned turned_other
} <modes.txt
for right in "$slow_other" "$middle_other" "$fast_other"; do
  holds "$right > 0.0099999 && $right < 0.0100001" "Matrix::expm gives a damping ratio of $right"
done
for right in "$slow_scaled" "$middle_scaled" "$fast_scaled"; do
  holds "$right > 0.00999 && $right < 0.01001" "with scaled states the damping ratio is $right"
done
holds "$slow > 0.018 && $slow < 0.02" "at 100 Hz the damping ratio is $slow"
holds "$middle < -0.009 && $middle > -0.012" "at 500 Hz the damping ratio is $middle"
holds "$fast > 0.99 && $flexibility == 0 && $flexibility_other > 9e-5" \
  "at 1 kHz the damping ratio is $fast, with an entry of $flexibility"
holds "$turned > 1e5 && $turned_other < 1.0001" "eight turns have entries up to $turned, by Matrix::expm $turned_other"
seen "damping ratio 0.01 becomes $slow at 100 Hz, $middle at 500 Hz and $fast at 1 kHz, by Matrix::expm $fast_other;" \
  "eight turns have entries up to $turned"
