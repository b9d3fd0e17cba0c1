function result = secant_stiffness(joint, amplitude)
% SECANT_STIFFNESS  Secant stiffness of a joint by the first harmonic, N/m.
%   y = microslip.secant_stiffness(j, amplitude)
%
%   amplitude in m, 0 or more, in any shape; y has that shape.
%
%   See also microslip.joint, microslip.loop.

% SPDX-License-Identifier: MIT

if nargin < 2
  error('microslip:input', 'joint and amplitude must be given');
end
result = microslip.internal.call('curve_of_joint', 'secant_stiffness', joint, amplitude);
end
