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

% SPDX-License-Identifier: MIT

if nargin < 1 || ~isstruct(result)
  error('microslip:input', 'result must be a struct of microslip.identify, frf, backbone, loop or march');
end
newplot(); % not plot, which is also the name of this function
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
end
draw_line(s, r.density_per_N);
if ~isempty(r.lower_per_N)
  legend({'band', 'density'});
end
label('slip force [N]', 'density [1/N]');
end

function draw_curve(c)
draw_line(c.frequency_Hz, c.displacement_m);
if ~isempty(c.peaks)
  line(c.frequency_Hz(c.peaks), c.displacement_m(c.peaks), 'LineStyle', 'none', 'Marker', 'o', ...
       'Color', [0.8 0.3 0]);
end
label('frequency [Hz]', 'displacement [m]');
end

function draw_march(m)
colours = get(gca(), 'ColorOrder');
for i = 1:numel(m.points)
  line(m.time_s, m.points(i).displacement_m, 'Color', colours(mod(i - 1, size(colours, 1)) + 1, :));
end
legend({m.points.name});
label('time [s]', 'displacement [m]');
end

function draw_loop(l)
draw_line(l.displacement_m, l.force_N);
label('displacement [m]', 'force [N]');
end

function draw_line(x, y)
line(x, y, 'Color', [0 0.27 0.55], 'LineWidth', 1.5);
end

function label(x, y)
xlabel(x);
ylabel(y);
box('on');
end
