function joint = with_record(joint)
% WITH_RECORD  A joint with what the text of its file says of its origin, to be looked at.
%   Fields provenance and identification, where there are such. microslip.write_joint writes the text itself,
%   as jsondecode may round the last digit of a number.

% SPDX-License-Identifier: MIT

record = jsondecode(joint.json);
for name = {'provenance', 'identification'}
  if isfield(record, name{1})
    joint.(name{1}) = record.(name{1});
  end
end
end
