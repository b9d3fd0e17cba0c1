function joint = read_joint(path)
% READ_JOINT  Reads a joint.json.
%   j = microslip.read_joint(path)
%
%   j is as of microslip.joint; where the file has them, also with the fields provenance and identification,
%   and json, the text of the file, from which microslip.write_joint writes them again.
%
%   See also microslip.joint, microslip.write_joint.

% SPDX-License-Identifier: MIT

if nargin < 1
  error('microslip:input', 'path must be given');
end
joint = microslip.internal.with_record(microslip.internal.call('read_joint', path));
end
