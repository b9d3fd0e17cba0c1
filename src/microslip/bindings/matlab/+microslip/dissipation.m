function result = dissipation(joint, amplitude)
% DISSIPATION  Energy that a joint loses in a steady cycle, J.
%   y = microslip.dissipation(j, amplitude)
%
%   amplitude in m, 0 or more, in any shape; y has that shape. D(A) = 4[A Phi1(kA) - Phi2(kA)/k].
%
%   See also microslip.joint, microslip.loop.

% SPDX-License-Identifier: MIT

if nargin < 2
  error('microslip:input', 'joint and amplitude must be given');
end
result = microslip.internal.call('curve_of_joint', 'dissipation', joint, amplitude);
end
