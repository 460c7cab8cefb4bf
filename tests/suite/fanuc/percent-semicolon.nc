%;
(machine: fanuc-30i);
O1;
(A semicolon after the percent sign, as listings show it.);
G21 G17 G90 S1000 M3;
G0 X0. Y0. Z0.;
G1 X1. F100.; (= line to X1)
M30;
%;
