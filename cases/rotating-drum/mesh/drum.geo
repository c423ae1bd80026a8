// The shell of a drum about the axis y, fluted so that the bed does not slide on it; millimetres.
//
//   gmsh -2 -format stl -bin drum.geo -o drum.stl        (Gmsh 4.15)

radius = 30;  // at the bottom of the flutes
depth  = 1;
length = 12;
flutes = 48;

n = 2*flutes;
For k In {0:n-1}
  r = radius - depth*(k % 2);
  Point(k + 1) = {r*Cos(2*Pi*k/n), 0, r*Sin(2*Pi*k/n)};
EndFor
For k In {0:n-1}
  Line(k + 1) = {k + 1, (k + 1) % n + 1};
EndFor
Transfinite Curve {1:n} = 2;
Extrude {0, length, 0} { Curve{1:n}; Layers{1}; }
