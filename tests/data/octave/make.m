% Makes the files of this folder. Octave 7.3.0: octave-cli make.m
fs = 1000; t = 0:1e-3:0.007; force = single ([0 1 2 3 2 1 0 -1])';
st.acc = [1 2; 3 4; 5 6]'; st.dt = 0.5; st.units = 'm/s^2';
K = sparse ([4 -1 0; -1 5 0; 0 0 2]); D = diag ([1 2 3]); z = [1+2i 3-4i]; force_unit = 'N';
words = ['ab '; 'cde']; many = struct ('dt', {0.5, 0.25}, 'x', {[1 2 3], [4 5]}); nothing = []; c = {'a', [7 8]; 2, true};
save ('-text', 'record.txt', 'fs', 't', 'force', 'force_unit', 'st', 'K', 'D', 'z', 'words', 'many', 'nothing', 'c');
save ('-hdf5', 'record.h5', 't', 'force', 'force_unit', 'st', 'K', 'z');
save ('-v4', 'record.mat', 't', 'force', 'force_unit', 'K', 'z', 'words');
% Of these HDF5 does not keep the order; those of w are the same.
q.time = t; q.z = 1:8; q.a = 10:10:80; q.units = 's, N, mm'; w.time = t; w.z = 1:8; w.a = 2:9; w.units = 's, N, N';
empty = struct ('a', {}); bare = repmat (struct (), 1, 2); none = {};
save ('-hdf5', 'order.h5', 'q', 'w', 'many', 'empty', 'bare', 'none');
z = 1:8; a = 10:10:80; units = {'N', 'mm'}; save ('-hdf5', 'order_top.h5', 'fs', 'z', 'a', 'units');
