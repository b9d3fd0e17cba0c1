function result = identify(varargin)
% IDENTIFY  A joint from its measured dissipation.
%   r = microslip.identify(amplitude, dissipation, 'Stiffness', k, ...)
%   r = microslip.identify('levels.csv', 'Stiffness', k, ...)
%
%   amplitude of the joint displacement, m, and energy lost per cycle, J: one value per level. k is the stiffness of the
%   stuck joint, N/m. Further columns, one value per level each:
%
%     'AmplitudeStd', 'DissipationStd'             standard deviations, m and J
%     'SecantStiffness', 'SecantStiffnessStd'      of the first harmonic, N/m
%     'LinearDissipation'                          that was subtracted, J
%     'LevelFrequency', 'LevelFrequencyStd'        of the resonance, Hz
%
%   Options, as of `microslip identify`:
%
%     'Bands', n              draws of the band; 0, the default, for none
%     'Confidence', 0.95      of the band
%     'Seed', 1               of the draws
%     'Method', 'inversion'   or 'spline', 'differences'
%     'Smoothing', 'gcv'      or 'lambda=X', 'p=X'; 'SmoothingUnit', 'mm' with 'p=X'
%     'Fit', 'none'           or 'four_parameter', 'power_law', 'uniform'
%     'LinearDamping', false  whether a loss of beta A^2 is identified as well
%     'Atom', false           whether macro-slip is identified
%     'Edges', true           whether the density may jump
%     'DissipationGainStd', 'AmplitudeGainStd', 'LossFactorStd'   errors that all levels share, relative
%     'Threads', 0            for the draws; 0: one per processor
%     'Command', text         the command recorded in joint.json
%
%   r has joint (see microslip.joint; microslip.write_joint writes the joint.json of the program), slip_force_N,
%   density_per_N, lower_per_N and upper_per_N (empty without a band), covered_from_N and covered_to_N, between which the
%   levels determine the density, linear_damping_J_per_m2 (NaN unless identified), converged, reason, summary, and
%   warnings, a struct array of code and text. microslip.plot(r) draws it. In Octave Ctrl-C stops the draws.
%
%   See also microslip.plot, microslip.write_joint, microslip.frf.

% SPDX-License-Identifier: MIT

columns = {'AmplitudeStd', 'DissipationStd', 'SecantStiffness', 'SecantStiffnessStd', 'LinearDissipation', ...
           'LevelFrequency', 'LevelFrequencyStd'};
fields = {'amplitude_std', 'dissipation_std', 'secant_stiffness', 'secant_stiffness_std', 'linear_dissipation', ...
          'frequency', 'frequency_std'};
known = [columns, {'Stiffness', 'Method', 'Smoothing', 'SmoothingUnit', 'Fit', 'LinearDamping', 'Atom', 'Edges', ...
                   'Bands', 'Confidence', 'Seed', 'DissipationGainStd', 'AmplitudeGainStd', 'LossFactorStd', ...
                   'Threads', 'Command'}];
if nargin < 1
  error('microslip:input', 'amplitude and dissipation must be given, or the name of a file');
end
if ischar(varargin{1})
  levels = varargin{1};
  options = microslip.internal.options(known, varargin(2:end));
else
  if nargin < 2
    error('microslip:input', 'dissipation must be given');
  end
  levels = struct('amplitude', varargin{1}, 'dissipation', varargin{2});
  options = microslip.internal.options(known, varargin(3:end));
end
for i = 1:numel(columns)
  if ~isfield(options, columns{i})
    continue
  end
  if ischar(levels)
    error('microslip:input', '%s must be left out: the file has the columns', columns{i});
  end
  levels.(fields{i}) = options.(columns{i});
  options = rmfield(options, columns{i});
end
result = microslip.internal.call('identify', levels, options);
result.joint = microslip.internal.with_record(result.joint);
microslip.internal.warn_if_not_converged(result);
end
