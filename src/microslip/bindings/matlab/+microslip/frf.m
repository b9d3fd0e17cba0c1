function curve = frf(model, varargin)
% FRF  Steady vibrations of a structure with joints over the frequency, at one force or one response.
%   c = microslip.frf(model, 'Force', F, 'Frequency', [from to], ...)
%   c = microslip.frf(model, 'Response', X, 'Frequency', [from to], ...)
%
%   model is the name of a model.toml, or a struct with its tables and keys:
%
%     model.structure.frequency_Hz     natural frequencies without the joints; one per mode
%     model.structure.damping_ratio    viscous, or loss_factor, hysteretic; one per mode or one for all
%     model.structure.point            struct array of name and shape (mass-normalised, one value per mode)
%     model.joint                      struct array of joint (see microslip.joint) or file, shape, and optionally name,
%                                      spring_in_modes_N_per_m, series_compliance_m_per_N, linear_damping_J_per_m2
%     model.excitation                 struct array of point, and optionally harmonics and phase_rad
%     model.static_load                struct array of point and force_N; may be missing
%
%   F is the amplitude of the excitations, N; X that of the response at the point, m unless 'Kind' says otherwise.
%   Frequencies in Hz; from above to goes downward. Options:
%
%     'Point', name           point of the response; by default that of model.toml, else the first excitation
%     'Kind', 'displacement'  of the constant response, or 'velocity', 'acceleration'
%     'Harmonics', 5          'Samples', 256      'Tolerance', 1e-12
%     'Accuracy', 0.002       interpolation error of the polygon through the points
%     'At', frequencies       additional frequencies of points of the curve
%     'MaxPoints', 5000       largest number of points of the curve
%     'Judge', true           whether warnings assess the effect of missing harmonics and modes
%
%   c has columns in the order of the curve: frequency_Hz, force_N, displacement_m (amplitude of the first harmonic),
%   response_m (as a complex number; the phase of the force is 0), phase_rad (lag), damping_ratio,
%   dissipation_J of all joints, linear_dissipation_J, energy_imbalance; peaks, their indices; joints, a struct array
%   of name, amplitude_m and dissipation_J; converged, reason, summary, warnings. microslip.plot(c) draws it.
%
%   See also microslip.backbone, microslip.march, microslip.plot.

% SPDX-License-Identifier: MIT

known = {'Force', 'Response', 'Frequency', 'Point', 'Kind', 'Harmonics', 'Samples', 'Tolerance', 'Accuracy', 'At', ...
         'MaxPoints', 'Judge'};
if nargin < 1
  error('microslip:input', 'model must be given');
end
curve = microslip.internal.call('frf', model, microslip.internal.options(known, varargin));
curve = microslip.internal.with_response(curve);
microslip.internal.warn_if_not_converged(curve);
end
