(machine: fanuc-30i)
(units: mm)
(A rapid that joins two arcs without a corner, at depth, was meant as a cut. One with corners, or above the plane,)
(is a way to the next cut.)
G21 G17 G90 G40 S5000 M3
G0 X-20. Y0 Z2.
G1 Z-3. F300.
X0
G3 X10. Y10. I0 J10.
G0 Y50. (= ! CH602 "a rapid of 40 mm in a contour")
G3 X0 Y60. I-10. J0
G1 X-20.
G0 Z2.
X-20. Y0
G1 Z1.
X0
G3 X10. Y10. I0 J10.
G0 Y50.
G3 X0 Y60. I-10. J0
G0 Z50.
M30
