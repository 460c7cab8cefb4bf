(machine: fanuc-30i)
(set: settings."look-ahead tolerance" = "0.005 mm")
(set: settings."corner rounding" = "0.1 mm")
(set: settings.start_path_mode = "exact-stop")
(The figures that no manual gives are settings.)
G21 G17 G90 G94 S1000 M3
G1 X10. F1000. (= line corner stop)
G64 X20. (= line corner round .1)
G5.1 Q1
X30. (= line corner round .005)
G5.1 Q0
X40. (= line corner round .1)
M30
