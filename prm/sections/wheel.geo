// Section of a wheel with a dished web, in millimetres: the file's x is y of the
// program, across; its y is z, from rail to wheel. The contact point is the
// origin, the axle lies at z = radius. See doc/howto/gmsh_wheel.md.
//
//   gmsh -2 wheel.geo -format msh22 -o wheel.msh
//   gmsh -2 wheel.geo -setnumber web 25 -format msh22 -o wheel_25.msh

DefineConstant[
  radius     = 460,  // of the tread
  rim_radius = 390,  // where rim and web meet
  hub_radius = 135,  // where web and hub meet
  bore       = 92.5, // radius
  rim        = 135,  // width
  hub        = 170,  // width
  web        = 30,   // thickness
  dish       = 20,   // middle of the web at the rim, across, from that at the hub

  n_web  = 2, // quadrilaterals through the web
  n_rim  = 4, // upwards through the rim
  n_hub  = 2, // through the hub
  n_side = 3, // on each side of the web, in rim and hub
  n_long = 12 // along the web
];

// Rows upwards: tread, top of the rim, foot of the web, bore.
z[]      = {0, radius - rim_radius, radius - hub_radius, radius - bore};
half[]   = {rim / 2, rim / 2, hub / 2, hub / 2};
middle[] = {dish, dish, 0, 0};
For j In {0:3} // across: edge, both sides of the web, edge
  Point(1 + 4 * j) = {-half[j], z[j], 0};
  Point(2 + 4 * j) = {middle[j] - web / 2, z[j], 0};
  Point(3 + 4 * j) = {middle[j] + web / 2, z[j], 0};
  Point(4 + 4 * j) = {half[j], z[j], 0};
  For i In {1:3}
    Line(i + 4 * j) = {i + 4 * j, i + 1 + 4 * j};
  EndFor
EndFor
For j In {0:2} // upwards: 101 to 112
  For i In {1:4}
    Line(100 + i + 4 * j) = {i + 4 * j, i + 4 * (j + 1)};
  EndFor
EndFor
For j In {0:2}
  For i In {1:3}
    If (j != 1 || i == 2) // between rim and hub there is the web only
      Curve Loop(i + 4 * j) = {i + 4 * j, 101 + i + 4 * j, -(i + 4 * (j + 1)), -(100 + i + 4 * j)};
      Plane Surface(i + 4 * j) = {i + 4 * j};
      section[] += {i + 4 * j};
    EndIf
  EndFor
EndFor
Recursive Delete { Curve{105}; Curve{108}; } // not in any surface

Transfinite Curve {1, 3, 5, 7, 9, 11, 13, 15} = n_side + 1;
Transfinite Curve {2, 6, 10, 14} = n_web + 1;
Transfinite Curve {101:104} = n_rim + 1;
Transfinite Curve {106, 107} = n_long + 1;
Transfinite Curve {109:112} = n_hub + 1;
Transfinite Surface {section[]};
Recombine Surface {section[]};

Physical Curve(Sprintf("contact, radius %g", radius), 1) = {1, 2, 3};
Physical Curve("hub", 2) = {13, 14, 15};
Physical Surface("section", 3) = {section[]};
