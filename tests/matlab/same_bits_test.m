% SPDX-License-Identifier: MIT
% What the functions return is what the C interface computes, to the last bit (reference.c).
function same_bits_test(examples, reference)
expect = @(name, values) expect_same(reference, name, values);
x = read(reference, 'path');
j = microslip.joint(1.7e5, struct('type', 'uniform', 'from_N', 1, 'to_N', 4, 'weight', 0.1), ...
                    struct('type', 'power_law', 'coefficient', 0.02, 'exponent', -0.5, 'from_N', 0, 'to_N', 10), ...
                    struct('type', 'piecewise_linear', 'slip_force_N', [0 5 12], 'density_per_N', [0.01 0.03 0]), ...
                    struct('type', 'atoms', 'slip_force_N', [9 3], 'weight', [0.1 0.2]));
expect('force', microslip.force(j, x));
assert(isequal(size(microslip.force(j, x')), [1 500]));
expect('dissipation', microslip.dissipation(j, abs(x)));
expect('secant_stiffness', microslip.secant_stiffness(j, abs(x)));

r = microslip.identify(read(reference, 'amplitude'), read(reference, 'level_dissipation'), 'DissipationStd', ...
                       read(reference, 'level_std'), 'stiffness', 1e6, 'Bands', 40, 'Seed', 7);
expect('slip_force', r.slip_force_N);
expect('density', r.density_per_N);
expect('lower', r.lower_per_N);
expect('upper', r.upper_per_N);
assert(r.converged);
assert(isnan(r.linear_damping_J_per_m2));

% The same model as a file and as a struct.
h = 0.7071067811865476;
model.structure.frequency_Hz = [15.91549430918953 27.56644477108960];
model.structure.loss_factor = 0.004;
model.structure.point = struct('name', {'first', 'second'}, 'shape', {[h h], [h -h]});
file = fullfile(examples, 'two_joints', 'joint.json');
model.joint = struct('name', {'wall', 'middle'}, 'shape', {[h h], [0 1.414213562373095]}, ...
                     'joint', {microslip.read_joint(file), microslip.read_joint(file)});
model.excitation.point = 'first';
for given = {fullfile(examples, 'two_joints', 'model.toml'), model}
  c = microslip.frf(given{1}, 'Force', 2, 'Frequency', [14 20], 'Point', 'second');
  expect('frequency', c.frequency_Hz);
  expect('displacement', c.displacement_m);
  expect('real', real(c.response_m));
  expect('imaginary', imag(c.response_m));
  assert(strcmp({c.joints.name}, {'wall', 'middle'}));
  assert(numel(c.peaks) >= 1 && max(c.displacement_m) == max(c.displacement_m(c.peaks)));
  b = microslip.backbone(given{1}, [1e-3 2e-3], 'Point', 'second');
  expect('backbone', b.damping_ratio);
  m = microslip.march(given{1}, read(reference, 'time'), read(reference, 'load'));
  expect('acceleration', m.points(2).acceleration_m_per_s2);
  expect('joint_force', m.joints(1).force_N);
  assert(m.energy.imbalance < 1e-4);
  m = microslip.march(given{1}, read(reference, 'time'), read(reference, 'load'), 'Points', {'first'});
  expect('joint_force', m.joints(1).force_N);
end

% Where it does not converge there is a warning, and the result.
lastwarn('', '');
warning('off', 'microslip:not_converged', 'local');
c = microslip.frf(model, 'Force', 2, 'Frequency', [14 20], 'MaxPoints', 5);
assert(~c.converged && numel(c.frequency_Hz) >= 1);
end

function values = read(folder, name)
file = fopen(fullfile(folder, [name '.bin']), 'rb');
values = fread(file, Inf, 'double');
fclose(file);
end

function expect_same(folder, name, values)
expected = read(folder, name);
if ~isequal(values, expected)
  error('%s: %d values, %d expected; they differ by up to %g', name, numel(values), numel(expected), ...
        max(abs(values(1:min(end, numel(expected))) - expected(1:min(end, numel(values))))));
end
end
