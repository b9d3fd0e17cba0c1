function joint = with_record(joint)
% WITH_RECORD  Adds the provenance and identification of its file to a joint, for reading.
%   Fields provenance and identification, where the file has them. microslip.write_joint writes the text itself,
%   as jsondecode may round the last digit of a number.

% SPDX-License-Identifier: MIT

record = jsondecode(joint.json);
for name = {'provenance', 'identification'}
  if isfield(record, name{1})
    joint.(name{1}) = record.(name{1});
  end
end
end
