function result = density(joint, slip_force)
% DENSITY  Density of the slip forces of a joint, 1/N, without its atoms.
%   y = microslip.density(j, slip_force)
%
%   slip_force in N, 0 or more, in any shape; y has that shape.
%
%   See also microslip.joint, microslip.loop.

% SPDX-License-Identifier: MIT

if nargin < 2
  error('microslip:input', 'joint and slip_force must be given');
end
result = microslip.internal.call('curve_of_joint', 'density', joint, slip_force);
end
