% The pull-off force of a wavy sphere against the amplitude of its wave, in MATLAB or Octave, after pulloff_mex.c has been
% compiled. Lengths are in epsilon, loads in pi w R.
amplitudes = linspace(0, 2, 5);
forces = zeros(size(amplitudes));
for k = 1:numel(amplitudes)
  result = jsondecode(pulloff_mex('tabor', 3, 'amplitude', amplitudes(k), 'wavelength', 20));
  forces(k) = result.pull_off.force;
  fprintf('amplitude %.2f: pull-off force %.10g +- %.1e\n', amplitudes(k), forces(k), result.pull_off.error_estimate);
end

% Arrays of the document are arrays of structures.
result = jsondecode(pulloff_mex('tabor', 3, 'amplitude', 1, 'wavelength', 20, 'want', 'curve'));
stable = [result.curve.unstable_modes] == 0;
fprintf('%d points, %d of them stable; least load %.8f\n', numel(stable), nnz(stable), min([result.curve.load]));
fprintf('digest %s\n', result.digest);

try
  pulloff_mex('tabor', -3);
catch problem
  fprintf('refused: %s\n', problem.message);
end
