% SPDX-License-Identifier: MIT
% Each result is drawn and printed without a screen.
function plot_test(examples, pictures)
warning('off', 'Octave:gnuplot-graphics');
graphics_toolkit('gnuplot');
set(0, 'defaultfigurevisible', 'off');
a = logspace(-6, -4, 25)';
r = microslip.identify(a, 3e10 * a.^2.9 .* (1 + 0.02 * sin(7 * (1:25)')), 'Stiffness', 1e6, 'Bands', 100);
draw(r, pictures, 'density');
model = fullfile(examples, 'one_mass', 'model.toml');
draw(microslip.frf(model, 'Force', 0.1, 'Frequency', [0.12 0.18]), pictures, 'frf');
draw(microslip.loop(microslip.read_joint(fullfile(examples, 'one_mass', 'joint.json')), 2), pictures, 'loop');
t = (0:0.2:60)';
draw(microslip.march(model, t, 0.1 * sin(0.92 * t)), pictures, 'march');
end

function draw(result, folder, name)
figure();
ax = microslip.plot(result);
assert(ishghandle(ax));
file = fullfile(folder, [name '.svg']);
print(gcf(), file, '-dsvg');
close();
text = fileread(file);
assert(numel(text) > 2000 && ~isempty(strfind(text, '<svg')), name);
end
