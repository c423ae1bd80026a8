// A plate of 36 mm × 36 mm with a round hole in its middle; millimetres.
//
//   for d in 10 13 16; do gmsh -2 -format stl -bin -setnumber orifice $d plate.geo -o plate-$d.stl; done        (Gmsh 4.15)

DefineConstant[ orifice = 16 ];

side = 36;
r    = orifice/2;

Point(1) = {-side/2, -side/2, 0};
Point(2) = { side/2, -side/2, 0};
Point(3) = { side/2,  side/2, 0};
Point(4) = {-side/2,  side/2, 0};
Point(5) = {0, 0, 0};
Point(6) = {r, 0, 0};
Point(7) = {0, r, 0};
Point(8) = {-r, 0, 0};
Point(9) = {0, -r, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Circle(5) = {6, 5, 7};
Circle(6) = {7, 5, 8};
Circle(7) = {8, 5, 9};
Circle(8) = {9, 5, 6};
Curve Loop(1) = {1:4};
Curve Loop(2) = {5:8};
Plane Surface(1) = {1, 2};
Transfinite Curve {1:4} = 5;
Transfinite Curve {5:8} = 13;
