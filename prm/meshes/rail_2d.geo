// Flat rail in the plane of rolling, in millimetres. The file's x is the rolling
// direction, its y goes from rail to wheel; the contact point is the origin.
//
//   gmsh -2 rail_2d.geo -format msh41 -o rail_2d.msh
//
// Seen along x: coarse, fine (7 mm on both sides of the contact point), coarse.

fine = 7;    // half-length and depth of the part with equal elements
size = 0.28; // of its elements
far  = 100;  // half-length and depth of the rail
n    = 19;   // elements from there to the ends
grow = 1.25; // each larger than the one before

x[] = {-far, -fine, fine, far};
y[] = {0, -fine, -far};
For j In {0:2}
  For i In {0:3}
    Point(1 + i + 4 * j) = {x[i], y[j], 0};
  EndFor
EndFor
For j In {0:2} // along x: 1 to 9
  For i In {0:2}
    Line(1 + i + 3 * j) = {1 + i + 4 * j, 2 + i + 4 * j};
  EndFor
EndFor
For j In {0:1} // downwards: 11 to 18
  For i In {0:3}
    Line(11 + i + 4 * j) = {1 + i + 4 * j, 5 + i + 4 * j};
  EndFor
EndFor
For j In {0:1}
  For i In {0:2}
    Curve Loop(1 + i + 3 * j) =
      {1 + i + 3 * j, 12 + i + 4 * j, -(4 + i + 3 * j), -(11 + i + 4 * j)};
    Plane Surface(1 + i + 3 * j) = {1 + i + 3 * j};
  EndFor
EndFor

Transfinite Curve {1, 4, 7} = n + 1 Using Progression 1 / grow;
Transfinite Curve {2, 5, 8} = 2 * fine / size + 1;
Transfinite Curve {3, 6, 9} = n + 1 Using Progression grow;
Transfinite Curve {11:14} = fine / size + 1;
Transfinite Curve {15:18} = n + 1 Using Progression grow;
Transfinite Surface {1:6};
Recombine Surface {1:6};

Physical Curve("contact", 1) = {1, 2, 3};
Physical Curve("hub", 2)     = {7, 8, 9};
Physical Surface("rail", 3)  = {1:6};
