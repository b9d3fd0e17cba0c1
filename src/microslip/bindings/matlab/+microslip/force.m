function f = force(joint, path)
% FORCE  Force of a joint along a path of displacement, from virgin rest.
%   f = microslip.force(j, path)
%
%   path holds displacements, m, in any shape, in the order of its elements; f, N, has that shape. The memory of the
%   joint is exact for any path.
%
%   See also microslip.loop, microslip.joint.

% SPDX-License-Identifier: MIT

if nargin < 2
  error('microslip:input', 'joint and path must be given');
end
f = microslip.internal.call('force', joint, path);
end
