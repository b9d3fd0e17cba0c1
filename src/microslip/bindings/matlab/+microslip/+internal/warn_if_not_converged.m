function warn_if_not_converged(result)
% WARN_IF_NOT_CONVERGED  A warning microslip:not_converged where a result did not converge.

% SPDX-License-Identifier: MIT

if ~result.converged
  warning('microslip:not_converged', 'not converged: %s', result.reason);
end
end
