% SPDX-License-Identifier: MIT
% Whatever is handed over: error('microslip:input') or one of its kin, which names the argument.
function bad_input_test(examples, ~)
j = microslip.joint(1e5, struct('type', 'uniform', 'from_N', 0, 'to_N', 10, 'weight', 1));
part = j.density{1};
model = fullfile(examples, 'one_mass', 'model.toml');
a = (1:6) * 1e-5;
d = a.^3 * 1e9;
bad = {
  'input', 'stiffness', @() microslip.joint()
  'input', 'stiffness', @() microslip.joint('much')
  'input', 'stiffness', @() microslip.joint(-1)
  'input', 'stiffness', @() microslip.joint([1 2])
  'input', 'density(1).type', @() microslip.joint(1, struct('from_N', 0))
  'input', 'density(1).type', @() microslip.joint(1, setfield(part, 'type', 'round'))
  'input', 'density(1).to_N', @() microslip.joint(1, rmfield(part, 'to_N'))
  'input', 'density(1).chi', @() microslip.joint(1, setfield(part, 'chi', 1))
  'input', 'density{1}.weight', @() microslip.joint(1, setfield(part, 'weight', -1))
  'input', 'density{2}.to', @() microslip.joint(1, part, setfield(part, 'to_N', NaN))
  'input', 'density(1) must', @() microslip.joint(1, 5)
  'input', 'weight = 3 values', @() microslip.joint(1, struct('type', 'atoms', 'slip_force_N', [1 2], 'weight', [0 0 0]))
  'input', 'joint', @() microslip.force(1, 1)
  'input', 'joint.densitie', @() microslip.force(setfield(j, 'densitie', 1), 1)
  'input', 'joint.density', @() microslip.force(rmfield(j, 'density'), 1)
  'input', 'path', @() microslip.force(j)
  'input', 'path', @() microslip.force(j, 'far')
  'input', 'path', @() microslip.force(j, 1i)
  'input', 'path', @() microslip.force(j, single(1))
  'input', 'displacement[1]', @() microslip.force(j, [0 NaN])
  'input', 'amplitude', @() microslip.loop(j, -1)
  'input', 'points', @() microslip.loop(j, 1, 1.5)
  'input', 'amplitude[0]', @() microslip.dissipation(j, -1)
  'file', '/nowhere/joint.json', @() microslip.read_joint('/nowhere/joint.json')
  'file', '/nowhere/joint.json', @() microslip.write_joint(j, '/nowhere/joint.json')
  'input', 'path', @() microslip.read_joint(5)
  'input', 'Stiffness', @() microslip.identify(a, d)
  'input', 'dissipation', @() microslip.identify(a)
  'input', 'dissipation', @() microslip.identify(a, d(1:3), 'Stiffness', 1)
  'input', 'amplitude', @() microslip.identify(-a, d, 'Stiffness', 1)
  'input', 'Stiff', @() microslip.identify(a, d, 'Stiff', 1)
  'input', 'options', @() microslip.identify(a, d, 'Stiffness')
  'input', 'options', @() microslip.identify(a, d, 5, 5)
  'input', 'Stiffness', @() microslip.identify(a, d, 'Stiffness', 'k')
  'input', 'Bands', @() microslip.identify(a, d, 'Stiffness', 1e5, 'Bands', 20.5)
  'input', 'Bands', @() microslip.identify(a, d, 'Stiffness', 1e5, 'Bands', 3)
  'input', 'Method', @() microslip.identify(a, d, 'Stiffness', 1e5, 'Method', 'guess')
  'input', 'DissipationStd', @() microslip.identify('x.csv', 'DissipationStd', 1)
  'file', '/nowhere/levels.csv', @() microslip.identify('/nowhere/levels.csv', 'Stiffness', 1)
  'input', 'Force', @() microslip.frf(model, 'Frequency', [1 2])
  'input', 'Frequency', @() microslip.frf(model, 'Force', 1)
  'input', 'Frequency', @() microslip.frf(model, 'Force', 1, 'Frequency', 1)
  'input', 'Frequency', @() microslip.frf(model, 'Force', 1, 'Frequency', [0 1])
  'input', 'Force', @() microslip.frf(model, 'Force', 0, 'Frequency', [1 2])
  'input', 'Kind', @() microslip.frf(model, 'Response', 1, 'Frequency', [1 2], 'Kind', 'speed')
  'input', 'point', @() microslip.frf(model, 'Force', 1, 'Frequency', [1 2], 'Point', 'nowhere')
  'input', 'harmonics', @() microslip.frf(model, 'Force', 1, 'Frequency', [1 2], 'Harmonics', 0)
  'input', 'model', @() microslip.frf()
  'input', 'model.structure', @() microslip.frf(struct(), 'Force', 1, 'Frequency', [1 2])
  'input', 'model.structure', @() microslip.frf(struct('structure', struct('frequency_Hz', 1), 'excitation', struct('point', 'p')), 'Force', 1, 'Frequency', [1 2])
  'file', 'nowhere.toml', @() microslip.frf('/nowhere.toml', 'Force', 1, 'Frequency', [1 2])
  'input', 'responses', @() microslip.backbone(model)
  'input', 'response[1]', @() microslip.backbone(model, [2 1])
  'input', 'Mode', @() microslip.backbone(model, 1, 'Mode', 0)
  'input', 'time[1]', @() microslip.march(model, [1 0], [0 0])
  'input', 'force', @() microslip.march(model, [0 1 2], [0 0])
  'input', 'Points', @() microslip.march(model, [0 1 2], zeros(3, 2))
  'input', 'Points', @() microslip.march(model, [0 1 2], zeros(3, 1), 'Points', {'a', 'b'})
  'input', 'every', @() microslip.march(model, [0 1 2], [], 'Every', 0)
  'input', 'result', @() microslip.plot(5)
  'input', 'result', @() microslip.plot(struct('a', 1))
};
for i = 1:size(bad, 1)
  [id, name, call] = bad{i, :};
  try
    call();
    error('taken: %s', func2str(call));
  catch found
    assert(strcmp(found.identifier, ['microslip:' id]), '%s: %s (%s)', func2str(call), found.message, found.identifier);
    assert(~isempty(strfind(found.message, name)), '%s: ''%s'' names no %s', func2str(call), found.message, name);
  end
end

% Ctrl-C while draws are made.
system(sprintf('(sleep 1; kill -INT %d) &', getpid()));
try
  microslip.identify((1:40) * 1e-6, ((1:40) * 1e-6).^2.8 * 1e9, 'Stiffness', 1e6, 'Bands', 1000000);
  error('not interrupted');
catch found
  assert(strcmp(found.identifier, 'microslip:cancelled'), '%s', found.message);
end
end
