% SPDX-License-Identifier: MIT
function text = version()
% VERSION  The version of microslip.
%   text = microslip.version()
text = microslip.internal.call('version');
end
