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
  error(found.identifier, '%s', regexprep(found.message, '^microslip_mex: ', ''));
end
end
