% SPDX-License-Identifier: MIT
% Files are those of the program: joint.json there and back, of an identification, loops.
function files_test(examples, programs)
work = tempname();
mkdir(work);
clean = onCleanup(@() confirm_and_remove(work));
levels = fullfile(examples, 'brake_reuss_beam', 'levels.csv');

% joint.json of the program (see run_tests.sh), byte for byte.
made = fullfile(programs, 'joint.json');
j = microslip.read_joint(made);
assert(isfield(j, 'provenance') && isfield(j, 'identification'));
again = fullfile(work, 'again.json');
microslip.write_joint(j, again);
assert(isequal(fileread(again), fileread(made)));
r = microslip.identify(levels, 'Stiffness', 1e7, 'LinearDamping', true, 'Command', j.provenance.command);
microslip.write_joint(r.joint, again);
assert(isequal(fileread(again), fileread(made)));

% Another stiffness: what the file says of its origin is not true any more.
changed = j;
changed.stiffness_N_per_m = 2 * j.stiffness_N_per_m;
microslip.write_joint(changed, again);
back = microslip.read_joint(again);
assert(strcmp(back.provenance.command, 'microslip_joint_write'));
assert(back.stiffness_N_per_m == 2 * j.stiffness_N_per_m);
assert(isequal(back.density, j.density));

% Decoded by others: parts that are alike become a struct array.
plain = jsondecode(fileread(fullfile(examples, 'reference_joint', 'joint.json')));
x = linspace(0, 3e-4, 50);
assert(isequal(microslip.force(plain, x), microslip.force(microslip.read_joint( ...
  fullfile(examples, 'reference_joint', 'joint.json')), x)));

% The loop of the program, whose file has all digits.
l = microslip.loop(microslip.read_joint(fullfile(examples, 'reference_joint', 'joint.json')), 1e-4, 50);
table = numbers_of(fullfile(programs, 'loop.csv'), 2);
assert(isequal(table(:, 1), l.displacement_m));
assert(isequal(table(:, 2), l.force_N));

assert(~isempty(regexp(microslip.version(), '^\d+\.\d+\.\d+$', 'once')));
for name = {'identify', 'frf', 'backbone', 'march', 'loop', 'force', 'joint', 'read_joint', 'write_joint', 'plot', ...
            'dissipation', 'secant_stiffness', 'virgin_force', 'density', 'version'}
  text = evalc(['help microslip.' name{1}]);
  assert(~isempty(strfind(text, upper(name{1}))), name{1});
end
end

% Without comments and the names of the columns.
function table = numbers_of(path, columns)
lines = strsplit(strtrim(fileread(path)), "\n");
lines = lines(~strncmp(lines, '#', 1));
table = reshape(sscanf(strrep(strjoin(lines(2:end), ','), ',', ' '), '%g'), columns, [])';
end

function confirm_and_remove(folder)
confirm_recursive_rmdir(false, 'local');
rmdir(folder, 's');
end
