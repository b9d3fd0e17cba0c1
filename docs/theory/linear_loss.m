% Linear loss of the reference rig at its highest level, [AR14 (18)], four ways: with the modes of the stick state or
% with modes tuned to the resonance of the level, with and without the factor n of harmonic n. Finite elements and
% three modal coordinates from three accelerometers; nothing of microslip takes part. GNU Octave:
%
%   microslip measure microslip/examples/reference_rig/rig.toml --no-shaker --seed 7 --out test
%   microslip verify test/rig.toml microslip/examples/reference_rig/joint.json test/level_90.csv \
%             --harmonics-csv harmonics.csv --out -
%   octave --no-gui -q microslip/docs/theory/linear_loss.m

1;  % a script file

% First `count` natural frequencies, rad/s, and mass-normalised shapes with the torsional spring kt at the end.
function [omega, shapes] = modes_with_spring(K, M, kt, count)
  K(end, end) = K(end, end) + kt;
  [V, D] = eig(K, M, "chol");
  [square, order] = sort(diag(D));
  omega = sqrt(square(1:count));
  shapes = V(:, order(1:count));
  shapes = shapes ./ sqrt(sum(shapes .* (M * shapes)));
end

% Sum over modes and harmonics of n^power pi eta_i omega_i^2 |q_in|^2; q_in by the accelerations A, harmonic x sensor.
function W = loss(A, f, sensor_shapes, omega, eta, power)
  W = 0;
  for n = 1:rows(A)
    q = sensor_shapes \ (-A(n, :).' / (2 * pi * n * f)^2);
    W = W + n^power * pi * sum(eta .* omega.^2 .* abs(q).^2);
  end
end

% Names and numbers of a CSV table; NaN where there is text.
function [names, values] = read_table(file)
  lines = strsplit(strtrim(fileread(file)), "\n");
  lines = lines(! strncmp(lines, "#", 1));
  names = strsplit(lines{1}, ",");
  values = cell2mat(cellfun(@(line) str2double(strsplit(line, ",")), lines(2:end)', "UniformOutput", false));
end

% ---- The beam: Hermite elements, clamped at 0, no vertical motion at L. ----
L = 0.583; b = 0.040; h = 0.005; E = 2.07e11; rho = 7850; r = 0.030; k = 1.7e5;
position = [0.55 0.35 0.18]; mass = [0.030 0.010 0.010]; eta = [0.0028; 0.0018; 0.0011];
x = unique([linspace(0, L, 121) position]);
K = zeros(2 * numel(x)); M = K;
for e = 1:numel(x) - 1
  l = x(e + 1) - x(e); at = 2 * e - 1:2 * e + 2;
  K(at, at) = K(at, at) + E * b * h^3 / 12 / l^3 * ...
    [12 6*l -12 6*l; 6*l 4*l^2 -6*l 2*l^2; -12 -6*l 12 -6*l; 6*l 2*l^2 -6*l 4*l^2];
  M(at, at) = M(at, at) + rho * b * h * l / 420 * ...
    [156 22*l 54 -13*l; 22*l 4*l^2 13*l -3*l^2; 54 13*l 156 -22*l; -13*l -3*l^2 -22*l 4*l^2];
end
for j = 1:3
  [~, node(j)] = min(abs(x - position(j)));
  M(2*node(j) - 1, 2*node(j) - 1) = M(2*node(j) - 1, 2*node(j) - 1) + mass(j);
end
free = [3:2*numel(x) - 2, 2*numel(x)];
K = K(free, free); M = M(free, free); sensor = 2 * node - 3;

% ---- The record, and what is true. ----
[names, table] = read_table("harmonics.csv");
column = @(name) table(1:5, find(strncmp(names, name, numel(name)), 1));
for j = 1:3
  A(:, j) = column(sprintf("acc%d_recorded [", j)) .* exp(1i * column(sprintf("acc%d_recorded_phase", j)));
end
f = table(1, 3);
[names, table] = read_table("test/truth.csv");
of = @(name) table(end, strncmp(names, name, numel(name)));
truth = of("linear_dissipation"); D = of("dissipation"); resonance = of("resonance_frequency");

% ---- Modes of the stick state, and with the spring that gives the resonance of the level. ----
[omega_stick, stick] = modes_with_spring(K, M, k * r^2, 3);
first_frequency = @(kt) modes_with_spring(K, M, kt, 1) / (2 * pi);
spring = fzero(@(kt) first_frequency(kt) - resonance, [0 k * r^2]);
[omega_level, level] = modes_with_spring(K, M, spring, 3);
printf("stick state %.4f Hz; at the level %.4f Hz with k = %.4g N/m\n", omega_stick(1) / (2*pi), resonance, ...
       spring / r^2);
report = @(what, W) printf("%-42s W_lin %+.2f %%, D %+.2f %%\n", what, 100 * (W / truth - 1), 100 * (truth - W) / D);
report("stick state, factor n:", loss(A, f, stick(sensor, :), omega_stick, eta, 1));
report("stick state, without n:", loss(A, f, stick(sensor, :), omega_stick, eta, 0));
report("modes of the level, factor n:", loss(A, f, level(sensor, :), omega_level, eta, 1));
report("modes of the level, without n, as printed:", loss(A, f, level(sensor, :), omega_level, eta, 0));
