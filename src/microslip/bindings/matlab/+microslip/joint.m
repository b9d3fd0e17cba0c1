function result = joint(stiffness, varargin)
% JOINT  A joint of a stiffness and the parts of its density of slip forces.
%   j = microslip.joint(stiffness, part, ...)
%
%   stiffness is k of the stuck joint, N/m. Each part is a struct, one of
%
%     struct('type', 'uniform', 'from_N', 0, 'to_N', 20, 'weight', 0.8)
%     struct('type', 'power_law', 'coefficient', 0.02, 'exponent', -0.5, 'from_N', 0, 'to_N', 10)
%     struct('type', 'piecewise_linear', 'slip_force_N', [0 5 12], 'density_per_N', [0.01 0.03 0])
%     struct('type', 'atoms', 'slip_force_N', [3 9], 'weight', [0.2 0.1])
%     struct('type', 'four_parameter', 'macroslip_force_N', 0.2, 'chi', -0.5, 'beta', 0)
%
%   They add up, to a weight of 1 at most; the last must be the only part. Without a part the joint is a spring.
%   j is a struct with the fields of joint.json: schema, stiffness_N_per_m and density, a cell array of parts.
%
%   See also microslip.read_joint, microslip.write_joint, microslip.force, microslip.identify.

% SPDX-License-Identifier: MIT

if nargin < 1
  error('microslip:input', 'stiffness must be given');
end
result = microslip.internal.call('joint', stiffness, varargin);
end
