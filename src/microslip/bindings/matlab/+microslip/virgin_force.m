function result = virgin_force(joint, displacement)
% VIRGIN_FORCE  Force of a joint on first loading, N.
%   y = microslip.virgin_force(j, displacement)
%
%   displacement in m, in any shape; y has that shape, and is odd.
%
%   See also microslip.joint, microslip.loop.

% SPDX-License-Identifier: MIT

if nargin < 2
  error('microslip:input', 'joint and displacement must be given');
end
result = microslip.internal.call('curve_of_joint', 'virgin_force', joint, displacement);
end
