function curve = with_response(curve)
% WITH_RESPONSE  Real and imaginary part of a curve as one complex column, response_m.

% SPDX-License-Identifier: MIT

curve.response_m = complex(curve.real_m, curve.imaginary_m);
curve = rmfield(curve, {'real_m', 'imaginary_m'});
end
