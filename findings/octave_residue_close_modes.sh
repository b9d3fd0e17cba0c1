#!/usr/bin/env bash
# Octave 7.3.0 (octave 7.3.0-2): residue of a frequency response with two close modes.
#
# Guess: two modes 0.05 % apart are two simple poles, with residues that give the response back to rounding.
# Instead: they become one double pole at their mean: the response by residues and poles is 0.70 at one peak of what
#   it is, and no message says so. Modes 0.2 % apart are right to 1e-6. Poles that are alike to 1e-3 are taken for one.
# Why it matters: two bending directions of a beam of round section, or the blades of a disc, are closer than that and
#   have damping ratios of 1e-4; expansion in partial fractions is how modal constants are read off a fitted response.
# A way to live with it: residues by the derivative of the denominator, polyval(b, p) ./ polyval(polyder(a), p), for
#   poles by roots().
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian octave=7.3.0-2

cat >modes.m <<'END'
1;
function [count, worst, simple] = expanded(apart)
  w = 2 * pi * 1000 * [1, 1 + apart];
  zeta = 1e-4;
  p = -zeta * w + 1i * w * sqrt(1 - zeta^2);
  first = real(poly([p(1), conj(p(1))]));
  second = real(poly([p(2), conj(p(2))]));
  b = first + second;  % 1/first + 1/second = b/a
  a = conv(first, second);
  [r, poles, k, e] = residue(b, a);
  count = sum(e == 1) / 2;
  s = 1i * w;
  right = polyval(b, s) ./ polyval(a, s);
  found = zeros(size(s));
  for j = 1:numel(r)
    found += r(j) ./ (s - poles(j)).^e(j);
  end
  [~, at] = max(abs(found ./ right - 1));
  worst = abs(found(at) / right(at));
  own = roots(a);
  c = polyval(b, own) ./ polyval(polyder(a), own);
  simple = abs(sum(c ./ (s(at) - own)) / right(at));
end
[n, worst, simple] = expanded(5e-4);
[n2, worst2, simple2] = expanded(2e-3);
printf("%g %.3f %.6f %g %.6f\n", n, worst, simple, n2, worst2);
END
octave modes.m >modes.txt || fail "Octave does not run it: $(cat octave.log)"
read -r count worst simple other right <modes.txt
holds "$count == 1 && $worst < 0.75" "two modes 0.05 % apart are apart"
holds "$simple > 0.999 && $simple < 1.001" "poles and derivatives of the denominator are wrong, too"
holds "$other == 2 && $right > 0.9999 && $right < 1.0001" "modes 0.2 % apart are one"
seen "modes 0.05 % apart: $count mode of simple poles, $worst of the response (by the derivative $simple); 0.2 % apart:" \
  "$other modes, $right"
