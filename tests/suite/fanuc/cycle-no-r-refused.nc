(machine: fanuc-30i)
(set: settings."cycle without R"="refused")
G21 G17 G90 G94 S1000 M3
G0 X0. Y0. Z5.
G81 Z-8.5 F100. (= none | ! CH800 "a drilling cycle without its R level")
G80
M30
