#!/usr/bin/env bash
# Octave 7.3.0 (octave 7.3.0-2) with signal 1.4.3 (octave-signal 1.4.3-1): second-order sections of Butterworth filters
#   by zp2sos and tf2sos, applied by sosfilt.
#
# Guess: the filter of butter(), to rounding, with half as many sections as its order. That is what sections are for.
# Instead: with a low-pass of order 4 sosfilt returns NaN for every sample, by either function, as with every order from
#   2 to 8 by zp2sos, and all but 6 by tf2sos. Real zeros and poles get a section each that is written [0 1 z] and not
#   [1 z 0], so a section has 0 for the first coefficient of its denominator, and division by it is no error. Order 6
#   is right by tf2sos, as rounding has made all zeros of its polynomial complex.
# Why it matters: sections are what is advised against the rounding of low cut-off frequencies, so one who is careful
#   with a recording gets none, and a controller of a test, which wants 1 for that coefficient, cannot use them.
# A way to live with it: move each row's leading zeros to its end, [0 1 z] to [1 z 0]: sosfilt then gives the filter.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian octave=7.3.0-2 octave-signal=1.4.3-1

cat >sections.m <<'END'
1;
warning("off", "all");
for folder = {"/usr/share/octave/packages", fullfile(getenv("ROOT"), "usr/share/octave/packages")}
  addpath(genpath(folder{1}));
end
for folder = {"/usr/lib", fullfile(getenv("ROOT"), "usr/lib")}
  for found = glob(fullfile(folder{1}, "*/octave/packages/*/*/"))'
    addpath(found{1});
  end
end
function sections = moved(sections)
  for i = 1:rows(sections)
    for first = [1 4]
      while sections(i, first) == 0
        sections(i, first:first + 2) = [sections(i, first + 1:first + 2), 0];
      end
    end
  end
end
sine = sin(2 * pi * (0:999)' / 50);
bad = [0 0];
for order = 2:8
  [b, a] = butter(order, 0.1);
  right = filter(b, a, sine);
  [z, p, k] = butter(order, 0.1);
  [zp, zp_gain] = zp2sos(z, p, k);
  [tf, tf_gain] = tf2sos(b, a);
  bad += [all(isnan(sosfilt(zp, sine)(10:end))), all(isnan(sosfilt(tf, sine)(10:end)))];
  worst(order - 1) = max(abs(zp_gain * sosfilt(moved(zp), sine) - right));
  if order == 4
    count = [rows(zp), rows(tf)];
  elseif order == 6
    six = max(abs(tf_gain * sosfilt(tf, sine) - right));
  end
end
printf("%d %d %d %d %g %g\n", bad, count, six, max(worst));
END
ROOT="$root" octave sections.m >sections.txt
read -r zp tf zp_sections tf_sections six moved <sections.txt || fail "Octave does not run it: $(cat octave.log)"
holds "$zp == 7 && $tf == 6" "of 7 orders $zp are NaN by zp2sos and $tf by tf2sos"
holds "$zp_sections == 4 && $tf_sections == 3" "order 4 has $zp_sections and $tf_sections sections"
holds "$six < 1e-6" "order 6 has an error of $six by tf2sos"
holds "$moved < 1e-6" "with leading zeros moved there is an error of $moved"
seen "of orders 2 to 8 $zp are NaN by zp2sos and $tf by tf2sos, order 4 has $zp_sections and $tf_sections sections;" \
  "with leading zeros moved to the end the error is $moved"
