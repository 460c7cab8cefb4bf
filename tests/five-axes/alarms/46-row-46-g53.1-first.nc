(G53.1 first.)
(machine: ac)
G21 G17 G90 G94 G40 G49 G80
G54
G53.1 (= ! "PS5458")
M30
