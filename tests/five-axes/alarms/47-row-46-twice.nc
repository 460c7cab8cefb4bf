(G68.2 twice.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G54
G68.2 J10.
G68.2 J20. (= ! "PS5456")
M30
