% SPDX-License-Identifier: MIT
function axes_used = plot(result)
% PLOT  Draws a result into the current axes.
%   microslip.plot(r)
%   ax = microslip.plot(r)
%
%   r is of microslip.identify: density over slip force, with its band; of microslip.frf or microslip.backbone: amplitude
%   over frequency, peaks marked; of microslip.loop: force over displacement; of microslip.march: displacement over
%   time. print(gcf, 'density.svg', '-dsvg') writes the picture.
%
%   See also microslip.identify, microslip.frf, microslip.loop, microslip.march.
if nargin < 1 || ~isstruct(result)
  error('microslip:input', 'result must be a struct of microslip.identify, frf, backbone, loop or march');
end
if isfield(result, 'density_per_N')
  draw_density(result);
elseif isfield(result, 'frequency_Hz')
  draw_curve(result);
elseif isfield(result, 'time_s')
  draw_march(result);
elseif isfield(result, 'force_N') && isfield(result, 'displacement_m')
  draw_loop(result);
else
  error('microslip:input', 'result must be of microslip.identify, frf, backbone, loop or march');
end
grid('on');
if nargout > 0
  axes_used = gca();
end
end

function draw_density(r)
s = r.slip_force_N;
if ~isempty(r.lower_per_N)
  patch([s; flipud(s)], [r.lower_per_N; flipud(r.upper_per_N)], [0.75 0.85 0.95], 'EdgeColor', 'none');
  hold('on');
end
plot(s, r.density_per_N, 'Color', [0 0.27 0.55], 'LineWidth', 1.5);
hold('off');
if ~isempty(r.lower_per_N)
  legend({'band', 'density'});
end
xlabel('slip force [N]');
ylabel('density [1/N]');
end

function draw_curve(c)
plot(c.frequency_Hz, c.displacement_m, 'Color', [0 0.27 0.55], 'LineWidth', 1.5);
if ~isempty(c.peaks)
  hold('on');
  plot(c.frequency_Hz(c.peaks), c.displacement_m(c.peaks), 'o', 'Color', [0.8 0.3 0]);
  hold('off');
end
xlabel('frequency [Hz]');
ylabel('displacement [m]');
end

function draw_march(m)
names = {m.points.name};
plot(m.time_s, [m.points.displacement_m], 'LineWidth', 1);
legend(names);
xlabel('time [s]');
ylabel('displacement [m]');
end

function draw_loop(l)
plot(l.displacement_m, l.force_N, 'Color', [0 0.27 0.55], 'LineWidth', 1.5);
xlabel('displacement [m]');
ylabel('force [N]');
end
