(machine: fanuc-30i)
(A call and a return with a label in one block: the call is left before any block of it has run, and the block)
(leads to itself.)
N1 M98 P1 M99 (= ! CH211)
O1
M99
