% The paper's way in GNU Octave: equal triangular elements, fsolve with the analytic Jacobian, arclength continuation.
% Called as: octave-cli paper.m REQUEST RESPONSE. Written from Eqs 2, 9, 12, 15 and 16; lengths in epsilon.
1;

function G = kernel (r, s)                       % Eq 12
  G = 4 ./ (pi * (r + s)) .* ellipke (min (4 * r .* s ./ (r + s).^2, 1 - 1e-15));
end

function M = influence (r)                       % int G(r_i, s) phi_j(s) s ds
  n = numel (r); h = r(2); M = zeros (n);
  t = (0.5 + (0:39)) / 40; x = t.^3 .* (10 - 15 * t + 6 * t.^2);     % midpoint rule, dense at both ends
  w = 30 * (t .* (1 - t)).^2 / 40;
  for k = 1:n-1
    s = r(k) + h * x;
    g = kernel (r, s) .* (s .* w * h);
    M(:,k) += g * (1 - x)'; M(:,k+1) += g * x';
  end
end

function [F, J] = equations (x, p)               % x: gaps, approach; the last row is the arclength condition
  n = p.n; H = x(1:n);
  F = [H + x(n+1) - p.shape + p.M * (8/3 * ((1 + H).^-3 - (1 + H).^-9)); p.metric' .* p.tangent' * (x - p.at)];
  J = [eye(n) - p.M .* (8 * (1 + H).^-4 - 24 * (1 + H).^-10)', ones(n, 1); p.metric' .* p.tangent'];
end

function radius = contact_radius (r, H)          % the outermost one at which the traction is the greatest tension
  i = find (H < 3^(1/6) - 1, 1, "last"); radius = 0;
  if ! isempty (i), radius = r(i) + r(2) * (3^(1/6) - 1 - H(i)) / (H(min (i+1, end)) - H(i)); end
end

function answer = solve_point (point)
  s = point.scene; n = 501;
  if isfield (point.knob, "nodes"), n = point.knob.nodes; end
  known = {"tabor", "amplitude", "wavelength", "radius", "outer_radius"};
  for name = fieldnames (s)'
    if ! any (strcmp (name{1}, known))
      answer = struct ("status", "unsupported", "reason", name{1}); return
    end
  end
  if ! isfield (s, "amplitude"), s.amplitude = 0; s.wavelength = 1; end
  unbounded = ischar (s.outer_radius);           % "inf": cut at R, with the load of the undeformed surfaces beyond
  cut = s.radius; if ! unbounded, cut = s.outer_radius; end
  r = linspace (0, cut, n)'; h = r(2);
  p.n = n; p.M = s.tabor^1.5 / sqrt (s.radius) * influence (r);
  p.shape = r.^2 / (2 * s.radius) + s.amplitude * (1 - cos (2 * pi / s.wavelength * r));
  p.metric = [ones(n, 1) / n; 1];
  weights = h * r; weights([1 n]) = [h^2 / 6, h * (cut / 2 - h / 6)]; weights *= 2 / s.radius;
  start = -12 - 2 * s.amplitude; if ! isempty (point.approach_start), start = point.approach_start; end
  options = optimset ("Jacobian", "on", "TolX", 1e-10, "TolFun", 1e-10, "MaxIter", 12);
  x = [p.shape - start; start]; tangent = [-ones(n, 1); 1]; tangent /= sqrt (p.metric' * tangent.^2); step = 0;
  D = []; W = []; S = []; dD = []; dW = []; gaps = {};
  while true
    p.tangent = tangent; p.at = x + step * tangent;
    [new, ~, info] = fsolve (@(y) equations (y, p), p.at, options);
    [F, J] = equations (new, p); direction = J \ [zeros(n, 1); 1]; direction /= sqrt (p.metric' * direction.^2);
    if step > 0 && (info <= 0 || norm (F, Inf) > 1e-7 || p.metric' * (direction .* tangent) < 0.97)
      step /= 2; if step < 1e-6, error ("step too small at approach %g", x(end)); end
      continue
    end
    x = new; tangent = direction; H = x(1:n);
    tail = 0; if unbounded, tail = 8/3 / (cut^2 / (2 * s.radius) - x(end) + 1)^2; end
    D(end+1) = x(end); W(end+1) = -8/3 * weights' * ((1 + H).^-3 - (1 + H).^-9) - tail; S(end+1) = step;
    dD(end+1) = tangent(end); dW(end+1) = weights' * ((8 * (1 + H).^-4 - 24 * (1 + H).^-10) .* tangent(1:n));
    gaps{end+1} = H;
    a = point.preload.approach; b = point.preload.load;
    if (! isempty (a) && ! ischar (a) && D(end) >= a) || (! isempty (b) && W(end) >= b), break, end
    step = min (max (step, 0.05) * 1.4, 0.15 * max (1, H(1)));
  end
  [folds, extrema, best] = deal ({}, {}, [0 0 1 0]);
  for i = 1:numel (D) - 1
    for which = 1:2
      if which == 1, f = dD; else f = dW; end
      if f(i) * f(i+1) >= 0, continue, end
      t = f(i) / (f(i) - f(i+1)); L = S(i+1);    % cubic Hermite interpolation, at the root of the rate
      c = [2*t^3-3*t^2+1, t^3-2*t^2+t, 3*t^2-2*t^3, t^3-t^2];
      d = c * [D(i); L*dD(i); D(i+1); L*dD(i+1)]; w = c * [W(i); L*dW(i); W(i+1); L*dW(i+1)];
      names = {"jump_out", "jump_in"; "minimum", "maximum"};
      item = struct ("kind", names{which, 1 + (f(i) > 0)}, "approach", d, "load", w);
      if which == 1, folds{end+1} = item; else extrema{end+1} = item; end
      if which == 2 && w < best(2), best = [d w i t]; end
    end
  end
  answer = struct ("status", "ok", "start", D(1), "end", D(end));
  answer.pull_off = struct ("force", -best(2), "approach", best(1), "contact_radius", ...
    (1 - best(4)) * contact_radius (r, gaps{best(3)}) + best(4) * contact_radius (r, gaps{best(3) + 1}));
  answer.folds = folds; answer.extrema = extrema;
  answer.curve = struct ("approach", D, "load", W);
end

words = argv (); request = jsondecode (fileread (words{end-1})); out = fopen (words{end}, "w");
points = request.points;
for k = 1:numel (points)
  if iscell (points), point = points{k}; else point = points(k); end
  for repeat = 1:request.repeats
    begin = tic ();
    try
      answer = solve_point (point);
    catch failure
      answer = struct ("status", "failed", "reason", failure.message);
    end
    answer.id = point.id; answer.repeat = repeat; answer.seconds.solve = toc (begin);
    fprintf (out, "%s\n", jsonencode (answer)); fflush (out);
  end
end
fclose (out);
