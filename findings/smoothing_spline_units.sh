#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2), make_smoothing_spline without lam, and Octave 7.3.0 (octave 7.3.0-2) with
#   splines 1.3.4 (octave-splines 1.3.4-3), csaps_sel: a sine of one period in 101 samples with a noise of 5 %, smoothed
#   by generalised cross-validation.
#
# Guess: the same curve whatever the unit of the abscissa is: cross-validation compares predictions, and depends on no
#   unit.
# Instead: if the sine lasts 1 to 100 s, an error of 1.6 to 1.7 % is left. If it lasts 0.1 s, SciPy returns a straight
#   line, and for 1 ms it says that the problem seems ill-posed; over 10 000 Hz it returns all of the noise. It looks
#   for the smoothing from 0 to the number of samples, in units of the abscissa to the third power. Octave returns a
#   straight line for 1 ms. R's smooth.spline is the same for all. No message but that one.
# Why it matters: it is how a recording is differentiated or a backbone drawn without a choice of one's own. A slip in
#   metres or a shock in seconds becomes a line, a spectrum in Hz stays as rough as it is.
# A way to live with it: an abscissa divided by its largest number, times 10.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2 octave=7.3.0-2 octave-splines=1.3.4-3 r-base-core=4.2.2.20221110-2

cat >sine.py <<'END'
import numpy as np
from scipy.interpolate import make_smoothing_spline

place = np.linspace(0, 1, 101)
sine = np.sin(2 * np.pi * place)
samples = sine + 0.05 * np.random.default_rng(0).standard_normal(101)
np.savetxt("samples.txt", np.column_stack([place, sine, samples]))
for length in (1e-3, 0.1, 1, 10, 100, 1e4):
    try:
        curve = make_smoothing_spline(length * place, samples)(length * place)
    except ValueError as error:
        print("refused:", error)
        continue
    line = np.polyval(np.polyfit(place, samples, 1), place)
    print(*(f"{number:.5f}" for number in (np.std(curve - sine), np.std(curve - samples), np.std(curve - line))))
END
cat >sine.m <<'END'
warning("off", "all");
for folder = {"/usr/share/octave/packages", fullfile(getenv("ROOT"), "usr/share/octave/packages")}
  addpath(genpath(folder{1}));
end
data = load("samples.txt");
line = polyval(polyfit(data(:, 1), data(:, 3), 1), data(:, 1));
for scale = [1e-3 1 1e4]
  place = scale * data(:, 1);
  curve = csaps_sel(place, data(:, 3), place);
  printf("%g %g\n", std(curve - data(:, 2)), std(curve - line));
end
END
cat >sine.R <<'END'
data <- read.table("samples.txt")
for (scale in c(1e-3, 1, 1e4)) {
  place <- scale * data[[1]]
  cat(sd(predict(smooth.spline(place, data[[3]]), place)$y - data[[2]]), "\n")
}
END
python3 sine.py >scipy.txt || fail "SciPy does not run it"
ROOT="$root" octave sine.m >octave.txt
r sine.R >r.txt
(($(wc -l <octave.txt) == 3 && $(wc -l <r.txt) == 3)) || fail "Octave or R does not run it: $(cat octave.log r.log)"
{
  read -r refused
  read -r short _ short_line
  read -r second _
  read -r ten _
  read -r hundred _
  read -r wide wide_rest _
} <scipy.txt
{ read -r octave_short octave_line; read -r octave_second _; read -r octave_wide _; } <octave.txt
{ read -r r_short; read -r r_second; read -r r_wide; } <r.txt
[[ "$refused" == refused:*ill-posed* ]] || fail "SciPy smooths over 1 ms: $refused"
for right in "$second" "$ten" "$hundred" "$octave_second" "$octave_wide" "$r_short" "$r_second" "$r_wide"; do
  holds "$right < 0.02" "an error of $right in a unit that suits it"
done
holds "$short > 0.4 && $short_line < 0.01" "SciPy has an error of $short over 0.1 s, and is $short_line off a line"
holds "$wide > 0.04 && $wide_rest < 0.001" "SciPy has an error of $wide over 10 kHz, and leaves out $wide_rest"
holds "$octave_short > 0.4 && $octave_line < 0.01" "Octave has an error of $octave_short over 1 ms"
seen "errors of a sine by SciPy over 0.1, 1, 10, 100 and 10 000: $short $second $ten $hundred $wide, over 0.001" \
  "$refused; over 0.001, 1 and 10 000 by Octave $octave_short $octave_second $octave_wide, by R" \
  "$r_short $r_second $r_wide"
