function text = version()
% VERSION  The version of microslip.
%   text = microslip.version()

% SPDX-License-Identifier: MIT

text = microslip.internal.call('version');
end
