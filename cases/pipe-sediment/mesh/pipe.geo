// A pipe with a sag, its axis in the plane y = 0; lengths in metres, z is up.
// The origin is on the axis, in the middle of the sag.
//
//   gmsh -3 -format msh41 -bin pipe.geo -o pipe.msh        (Gmsh 4.15)

SetFactory("OpenCASCADE");

radius = 0.012;  // of the pipe
bend   = 0.040;  // radius of the axis in the bends
inlet  = 0.070;  // vertical leg, before an elbow of 90 degrees
sag    = 0.030;  // level, before a bend of 45 degrees up
rise   = 0.020;  // before a bend of 45 degrees back to level
outlet = 0.040;  // level leg
size   = 0.0040; // edge of a tetrahedron

s = Sqrt(2) / 2;

// The section is swept along the axis, part by part.
Disk(1) = {-sag/2 - bend, 0, bend + inlet, radius};
leg() = Extrude {0, 0, -inlet} { Surface{1}; };
elbow() = Extrude { {0, 1, 0}, {-sag/2, 0, bend}, -Pi/2 } { Surface{leg(0)}; };
level() = Extrude {sag, 0, 0} { Surface{elbow(0)}; };
up() = Extrude { {0, 1, 0}, {sag/2, 0, bend}, -Pi/4 } { Surface{level(0)}; };
slope() = Extrude {rise*s, 0, rise*s} { Surface{up(0)}; };
x = sag/2 + (2*bend + rise)*s;
z = bend + (rise - 2*bend)*s;
back() = Extrude { {0, 1, 0}, {x, 0, z}, Pi/4 } { Surface{slope(0)}; };
out() = Extrude {outlet, 0, 0} { Surface{back(0)}; };

Physical Surface("inlet") = {1};
Physical Surface("outlet") = {out(0)};
Physical Surface("wall") = {leg(2), elbow(2), level(2), up(2), slope(2), back(2), out(2)};
Physical Volume("water") = {leg(1), elbow(1), level(1), up(1), slope(1), back(1), out(1)};

Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;
Mesh.Algorithm = 6;  // frontal Delaunay
Mesh.Optimize = 1;
Mesh.OptimizeNetgen = 1;
