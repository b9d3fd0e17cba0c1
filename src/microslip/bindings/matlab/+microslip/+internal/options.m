function all = options(known, given)
% OPTIONS  Options from pairs of names and values, as a struct.
%   all = microslip.internal.options(known, given): `known` are the names in a cell array, `given` the pairs.
%   Capitals do not matter. A name that is not known is an error.

% SPDX-License-Identifier: MIT

all = struct();
if mod(numel(given), 2) ~= 0
  error('microslip:input', 'options must be pairs of a name and a value');
end
for i = 1:2:numel(given)
  if ~ischar(given{i})
    error('microslip:input', 'options must be pairs of a name and a value; number %d is no name', i);
  end
  at = find(strcmpi(given{i}, known));
  if isempty(at)
    error('microslip:input', '%s is no option; must be one of %s', given{i}, strjoin(known, ', '));
  end
  all.(known{at}) = given{i + 1};
end
end
