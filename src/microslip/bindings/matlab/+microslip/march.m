function result = march(model, time, force, varargin)
% MARCH  Time history of a structure with joints under any forces.
%   m = microslip.march(model, time, force, ...)
%
%   model as of microslip.frf; time in s, rising. force in N, one value per time, linear between them: at the first
%   excitation of the model, or one column for each of 'Points'. []: free vibration. Options:
%
%     'Points', {names}       where the columns of force act
%     'Step', seconds         longest step
%     'Every', 1              every n-th time is recorded
%     'EstimateError', true   by a second march of twice the step
%     'LargestError', 0.01    'LargestImbalance', 1e-4   above which the march has not converged
%     'StartDisplacement', q  'StartVelocity', v         of the modes at the first time
%
%   m has time_s; points, a struct array of name, displacement_m, velocity_m_per_s and acceleration_m_per_s2 of each
%   point of the model; joints of name, displacement_m and force_N; energy; reached_s, error_estimate, converged,
%   reason, summary, warnings. microslip.plot(m) draws it.
%
%   See also microslip.frf, microslip.plot.

% SPDX-License-Identifier: MIT

known = {'Points', 'Step', 'Every', 'EstimateError', 'LargestError', 'LargestImbalance', 'StartDisplacement', ...
         'StartVelocity'};
if nargin < 3
  error('microslip:input', 'model, time and force must be given');
end
result = microslip.internal.call('march', model, time, force, microslip.internal.options(known, varargin));
microslip.internal.warn_if_not_converged(result);
end
