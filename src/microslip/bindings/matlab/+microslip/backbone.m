function curve = backbone(model, responses, varargin)
% BACKBONE  Resonance frequency and damping of a structure with joints over amplitude.
%   c = microslip.backbone(model, responses, ...)
%
%   model as of microslip.frf; responses at the point, rising, m unless 'Kind' says otherwise. Options:
%
%     'Mode', 1               mode of the stuck structure
%     'Forcing', 'excitation' phase resonance; 'modal': the nonlinear mode
%     'Point', 'Kind', 'Harmonics', 'Samples', 'Tolerance', 'Judge'   as of microslip.frf
%
%   c is as of microslip.frf.
%
%   See also microslip.frf.

% SPDX-License-Identifier: MIT

known = {'Mode', 'Forcing', 'Point', 'Kind', 'Harmonics', 'Samples', 'Tolerance', 'Judge'};
if nargin < 2
  error('microslip:input', 'model and responses must be given');
end
curve = microslip.internal.call('backbone', model, responses, microslip.internal.options(known, varargin));
curve = microslip.internal.with_response(curve);
microslip.internal.warn_if_not_converged(curve);
end
