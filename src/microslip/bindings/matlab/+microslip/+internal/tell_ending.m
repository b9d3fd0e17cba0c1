function tell_ending(result)
% TELL_ENDING  A warning microslip:not_converged where a result did not converge.

% SPDX-License-Identifier: MIT

if ~result.converged
  warning('microslip:not_converged', 'not converged: %s', result.reason);
end
end
