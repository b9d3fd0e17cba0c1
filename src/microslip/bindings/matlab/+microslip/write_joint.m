function write_joint(joint, path)
% WRITE_JOINT  Writes a joint.json, as the program does.
%   microslip.write_joint(j, path)
%
%   A joint that was read or identified is written with its provenance and identification; one whose stiffness or
%   density was changed afterwards without, as they belong to another joint.
%
%   See also microslip.read_joint, microslip.identify.

% SPDX-License-Identifier: MIT

if nargin < 2
  error('microslip:input', 'joint and path must be given');
end
microslip.internal.call('write_joint', joint, path);
end
