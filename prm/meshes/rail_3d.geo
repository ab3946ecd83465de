// Piece of a rail with a crown of 300 mm, in millimetres: x is the rolling
// direction, y goes across, z from rail to wheel; the contact point is the
// origin.
//
//   gmsh -3 rail_3d.geo -format msh22 -o rail_3d.msh
//
// Along x and y: coarse, fine, coarse; downwards: fine, coarse.

crown   = 300;
size_x  = 0.9; // elements of the fine part
size_y  = 0.7;
size_z  = 1;
n_x     = 12; // of them
n_y     = 12;
n_z     = 3;
n_far_x = 3; // of the coarse part on each side
n_far_y = 3;
n_far_z = 3;
grow_x  = 2.1; // each longer than the one before
grow_y  = 2.2;
grow_z  = 2.2;

x[] = {-25, -n_x * size_x / 2, n_x * size_x / 2, 25};
y[] = {-20, -n_y * size_y / 2, n_y * size_y / 2, 20};
z[] = {0, -n_z * size_z, -25};

For k In {0:2}
  For j In {0:3}
    For i In {0:3}
      // flat below the top
      fall = k == 0 ? crown - Sqrt(crown^2 - y[j]^2) : 0;
      Point(1 + i + 4 * j + 16 * k) = {x[i], y[j], z[k] - fall, 0};
    EndFor
  EndFor
EndFor
For i In {0:3}
  Point(101 + i) = {x[i], 0, -crown}; // centres of the arcs
EndFor

// along x: 1000 + i + 4 j + 16 k, along y: 2000 + ..., downwards: 3000 + ...
For k In {0:2}
  For j In {0:3}
    For i In {0:3}
      p = 1 + i + 4 * j + 16 * k;
      If (i < 3)
        Line(1000 + p) = {p, p + 1};
      EndIf
      If (j < 3 && k == 0)
        Circle(2000 + p) = {p, 101 + i, p + 4};
      EndIf
      If (j < 3 && k > 0)
        Line(2000 + p) = {p, p + 4};
      EndIf
      If (k < 2)
        Line(3000 + p) = {p, p + 16};
      EndIf
    EndFor
  EndFor
EndFor

// normal to z, y and x: 4000, 5000, 6000 + ...
For k In {0:2}
  For j In {0:3}
    For i In {0:3}
      p = 1 + i + 4 * j + 16 * k;
      If (i < 3 && j < 3)
        Curve Loop(4000 + p) = {1000 + p, 2001 + p, -(1004 + p), -(2000 + p)};
        Surface(4000 + p) = {4000 + p};
      EndIf
      If (i < 3 && k < 2)
        Curve Loop(5000 + p) = {1000 + p, 3001 + p, -(1016 + p), -(3000 + p)};
        Surface(5000 + p) = {5000 + p};
      EndIf
      If (j < 3 && k < 2)
        Curve Loop(6000 + p) = {2000 + p, 3004 + p, -(2016 + p), -(3000 + p)};
        Surface(6000 + p) = {6000 + p};
      EndIf
    EndFor
  EndFor
EndFor
For k In {0:1}
  For j In {0:2}
    For i In {0:2}
      p = 1 + i + 4 * j + 16 * k;
      Surface Loop(p) = {4000 + p, 4016 + p, 5000 + p, 5004 + p, 6000 + p, 6001 + p};
      Volume(p) = {p};
    EndFor
  EndFor
EndFor

For k In {0:2}
  For j In {0:3}
    For i In {0:3}
      p = 1 + i + 4 * j + 16 * k;
      If (i == 0)
        Transfinite Curve {1000 + p} = n_far_x + 1 Using Progression 1 / grow_x;
      EndIf
      If (i == 1)
        Transfinite Curve {1000 + p} = n_x + 1;
      EndIf
      If (i == 2)
        Transfinite Curve {1000 + p} = n_far_x + 1 Using Progression grow_x;
      EndIf
      If (j == 0)
        Transfinite Curve {2000 + p} = n_far_y + 1 Using Progression 1 / grow_y;
      EndIf
      If (j == 1)
        Transfinite Curve {2000 + p} = n_y + 1;
      EndIf
      If (j == 2)
        Transfinite Curve {2000 + p} = n_far_y + 1 Using Progression grow_y;
      EndIf
      If (k == 0)
        Transfinite Curve {3000 + p} = n_z + 1;
      EndIf
      If (k == 1)
        Transfinite Curve {3000 + p} = n_far_z + 1 Using Progression grow_z;
      EndIf
    EndFor
  EndFor
EndFor
Transfinite Surface "*";
Recombine Surface "*";
Transfinite Volume "*";

For j In {0:2}
  For i In {0:2}
    top[]    += {4001 + i + 4 * j};
    bottom[] += {4033 + i + 4 * j};
  EndFor
EndFor
Physical Surface("contact", 1) = top[];
Physical Surface("hub", 2)     = bottom[];
Physical Volume("rail", 3)     = Volume{:};
