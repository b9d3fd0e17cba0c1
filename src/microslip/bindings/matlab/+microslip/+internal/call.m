function result = call(varargin)
% CALL  A command of the MEX file; its errors are raised without the name of that file, which Octave puts before them.

% SPDX-License-Identifier: MIT

try
  if nargout > 0
    result = microslip_mex(varargin{:});
  else
    microslip_mex(varargin{:});
  end
catch found
  identifier = found.identifier;
  if isempty(identifier)  % of the loader, where a library is not found; an empty one raises nothing
    identifier = 'microslip:load';
  end
  error(identifier, '%s', regexprep(found.message, '^microslip_mex: ', ''));
end
end
