0 BEGIN PGM 34-CALLED MM
1 ; = called
2 ; square of side Q1 from here, depth Q2; gives back Q5
3 L Z+2 FMAX
4 L Z+Q2 F200
5 L IX+Q1 F500
6 L IY+Q1
7 L IX-Q1
8 L IY-Q1
9 L Z+2 FMAX
10 Q5 = 30 + 2 * Q1
11 END PGM 34-CALLED MM
