function result = loop(joint, amplitude, points)
% LOOP  First loading and one steady cycle of a joint, as `microslip loop --amplitude`.
%   l = microslip.loop(j, amplitude)
%   l = microslip.loop(j, amplitude, points)
%
%   amplitude in m, above 0; points of a branch, 200 unless given. l has the columns displacement_m and force_N:
%   from 0 to the amplitude, to its negative, and back. microslip.plot draws it.
%
%   See also microslip.force, microslip.dissipation.

% SPDX-License-Identifier: MIT

if nargin < 2
  error('microslip:input', 'joint and amplitude must be given');
end
if nargin < 3
  points = 200;
end
if ~(isscalar(amplitude) && isnumeric(amplitude) && isfinite(amplitude) && amplitude > 0)
  error('microslip:input', 'amplitude must be one positive number');
end
if ~(isscalar(points) && isnumeric(points) && points >= 2 && points == floor(points))
  error('microslip:input', 'points must be a whole number, 2 or more');
end
branch = @(from, to) from + (to - from) * (1:points)' / points;
x = [0; branch(0, amplitude); branch(amplitude, -amplitude); branch(-amplitude, amplitude)];
result = struct('displacement_m', x, 'force_N', microslip.force(joint, x));
end
